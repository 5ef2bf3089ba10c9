"""The fields of a sidecar as a form: of each channel, of the run, and of the file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from torquerig.recordings.files.scale import known_si_per_unit, scale_key
from torquerig.recordings.quantities import OTHER, QUANTITIES, ROLES
from torquerig.recordings.run import PROFILES
from torquerig.studio.session.tab_session import Session
from torquerig.studio.session.working_document import WorkingDocument
from torquerig.studio.session.yaml_spans import Keys

NO_CHOICE = ""
RUN_FIELDS = (
    ("speed_rpm", "speed of the motor", "rpm"), ("gear_ratio", "motor turns per output turn", ""),
    ("occupancy_percent", "occupancy", "%"), ("particle_size_mm", "particle size", "mm"),
)  # fmt: skip
"""Keys of the conditions that are numbers, with label and unit."""
NO_SCALES = ("quantity", "unit", "truth", "of", "role", "tare", "pulses_per_rev", "teeth", "shaft")
"""Keys of a channel that are no scale."""


@dataclass(frozen=True)
class SheetField:
    """A field of the form.

    Parameters
    ----------
    keys : tuple of str or int
        Path of its value in the sidecar.
    label : str
    kind : str
        ``choice``, ``picker`` or ``text``.
    value : str
        As the sidecar states it; empty where it does not.
    options : tuple of str
    unit : str
    """

    keys: Keys
    label: str
    kind: Literal["choice", "picker", "text"]
    value: str
    options: tuple[str, ...] = ()
    unit: str = ""


@dataclass(frozen=True)
class SheetGroup:
    """Fields that belong together: those of one channel, of the run, or of the file."""

    title: str
    fields: tuple[SheetField, ...]


def sheet_form(document: WorkingDocument, *, parts: Sequence[str], motors: Sequence[str]) -> tuple[SheetGroup, ...]:
    """Return the form of a sidecar.

    Parameters
    ----------
    document : WorkingDocument
        The sidecar that is open.
    parts : sequence of str
        Parts of the scenario, for ``of:``.
    motors : sequence of str
        Of the catalog.
    """
    channels = document.value("channels")
    listed = [str(name) for name in channels] if isinstance(channels, dict) else []
    return (*(_channel(document, name, parts) for name in listed), _run(document, motors), _file(document))


def set_field(session: Session, document: WorkingDocument, keys: Keys, written: str) -> WorkingDocument:
    """Return the sidecar with a field as a person wrote it; an empty field takes the key out."""
    path = document.path
    if written.strip():
        return session.edit_text(path, keys, written)
    return session.remove(path, keys) if _is_there(document, keys) else document


def _channel(document: WorkingDocument, name: str, parts: Sequence[str]) -> SheetGroup:
    def field(key: str, label: str, kind: Literal["choice", "text"], options: Sequence[str] = ()) -> SheetField:
        return SheetField(("channels", name, key), label, kind, _text(document, "channels", name, key), tuple(options))

    of = _text(document, "channels", name, "of")
    owners = tuple(dict.fromkeys((NO_CHOICE, *parts, *([of] if of else []))))
    fields = [
        field("quantity", "quantity", "choice", [one for one in QUANTITIES if one != "time"]),
        field("unit", "unit", "text"), *_scales(document, name), field("of", "of the part", "choice", owners),
        field("role", "used as", "choice", (NO_CHOICE, *ROLES)),
    ]  # fmt: skip
    return SheetGroup(f"channel {name}", tuple(fields))


def _scales(document: WorkingDocument, name: str) -> list[SheetField]:
    """Return the scales that a channel states, or the one that it needs."""
    entry = document.value("channels", name)
    stated = [str(key) for key in entry if key not in NO_SCALES] if isinstance(entry, dict) else []
    if not stated:
        quantity, unit = _text(document, "channels", name, "quantity"), _text(document, "channels", name, "unit")
        is_open = quantity in QUANTITIES and quantity != OTHER and unit and known_si_per_unit(quantity, unit) is None
        stated = [scale_key(quantity, unit)] if is_open else []
    return [
        SheetField(("channels", name, key), f"scale {key}", "text", _text(document, "channels", name, key))
        for key in stated
    ]  # fmt: skip


def _run(document: WorkingDocument, motors: Sequence[str]) -> SheetGroup:
    numbers = [
        SheetField(("run", key), label, "text", _text(document, "run", key), unit=unit)
        for key, label, unit in RUN_FIELDS
    ]  # fmt: skip
    return SheetGroup("conditions of the run", (
        SheetField(("run", "motor"), "motor of the catalog", "picker", _text(document, "run", "motor"), tuple(motors)),
        *numbers,
        SheetField(("run", "profile"), "profile", "choice", _text(document, "run", "profile"), (NO_CHOICE, *PROFILES)),
    ))  # fmt: skip


def _file(document: WorkingDocument) -> SheetGroup:
    rate = SheetField(("sample_rate_Hz",), "sample rate", "text", _text(document, "sample_rate_Hz"), unit="Hz")
    return SheetGroup("the file", (rate,))


def _text(document: WorkingDocument, *keys: str) -> str:
    value: Any = document.value(*keys)
    if value is None:
        return ""
    return ("true" if value else "false") if isinstance(value, bool) else str(value)


def _is_there(document: WorkingDocument, keys: Keys) -> bool:
    holder = document.value(*keys[:-1]) if len(keys) > 1 else document.data
    return isinstance(holder, dict) and any(str(key) == str(keys[-1]) for key in holder)
