"""Reading of a sidecar: channels, test conditions and origin of a recording (CONTRACTS.md, section 1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any, cast

from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError
from torquerig.recordings.files.scale import known_si_per_unit, missing_scale, si_per_unit_from
from torquerig.recordings.files.set_point_text import read_set_point
from torquerig.recordings.files.sidecar_schema import WrittenChannel, WrittenRun, sidecar_schema
from torquerig.recordings.run import Profile, Run
from torquerig.units import UNITS

_CHANNEL_KEYS = {one.name for one in fields(WrittenChannel)}
_RUN_KEYS = {one.name for one in fields(WrittenRun)}
# known keys without their unit are refused as slips, not taken as further conditions
_RUN_SLIPS = {"speed": "speed_rpm", "rpm": "speed_rpm", "occupancy": "occupancy_percent"}
_RUN_SLIPS |= {"particle_size": "particle_size_mm", "ratio": "gear_ratio"}


@dataclass(frozen=True, kw_only=True)
class ChannelEntry:
    """One column's quantity, unit, SI value of the unit, and whether it is a truth channel of a simulation.

    ``reason`` and ``missing`` are those of :class:`~torquerig.recordings.names.interpretation.Interpretation`; both
    are empty where a sidecar describes the column.
    """

    quantity: str
    unit: str
    si_per_unit: float = 1.0
    truth: bool = False
    reason: str = ""
    missing: str = ""


@dataclass(frozen=True, kw_only=True)
class Sidecar:
    """The content of a sidecar; ``sample_rate`` [Hz] is None and ``channels`` empty where it does not state them."""

    path: Path
    sample_rate: float | None = None
    channels: Mapping[str, ChannelEntry] = field(default_factory=dict)
    run: Run = field(default_factory=Run)
    origin: Mapping[str, Any] = field(default_factory=dict)


def sidecar_path(recording: Path) -> Path:
    """Return the path of the sidecar of a recording's table file: the same name with the ending ``.yaml``.

    That of ``run.csv.gz`` is ``run.yaml``.
    """
    if recording.suffix.lower() == ".gz" and recording.with_suffix("").suffix:
        recording = recording.with_suffix("")
    return recording.with_suffix(".yaml")


def read_sidecar(path: Path) -> Sidecar:
    """Read one sidecar file, in SI.

    Raises
    ------
    InputError
        With file, line and key: a misspelt or unknown key, an unknown quantity or profile, a number out of range, a
        unit that needs a scale and has none, a scale that does not fit the unit.
    """
    document = read_document(path)
    if not isinstance(document.data, dict):
        raise InputError(f"{document.place()}: a sidecar holds the keys sample_rate_Hz, channels and run; write them")
    pruned, scales, others = _pruned(document)
    written = validated(pruned, sidecar_schema())
    channels = {
        name: _entry(document, name, entry, scales.get(name, {})) for name, entry in (written.channels or {}).items()
    }
    return Sidecar(
        path=path,
        sample_rate=written.sample_rate_Hz,
        channels=channels,
        run=_run(document, written.run or WrittenRun(), others),
        origin=written.origin or {},
    )


def _pruned(document: Document) -> tuple[Document, dict[str, dict[str, Any]], dict[str, Any]]:
    """Return the document without scales and further conditions, whose keys the schema cannot list."""
    data, scales, others = dict(document.data), {}, {}
    if isinstance(data.get("channels"), dict):
        entries: dict[Any, Any] = {}
        for name, entry in data["channels"].items():
            entries[name] = entry
            if isinstance(entry, dict):
                scales[name] = {key: value for key, value in entry.items() if "_per_" in str(key)}
                entries[name] = {key: value for key, value in entry.items() if key not in scales[name]}
        data["channels"] = entries
    if isinstance(data.get("run"), dict):
        others = {str(key): value for key, value in data["run"].items() if key not in _RUN_KEYS}
        for key in others:
            _refuse_slip(document, key)
        data["run"] = {key: value for key, value in data["run"].items() if key in _RUN_KEYS}
    return replace(document, data=data), scales, others


def _refuse_slip(document: Document, key: str) -> None:
    near = get_close_matches(key.lower(), [known.lower() for known in _RUN_KEYS], n=1, cutoff=0.85)
    meant = _RUN_SLIPS.get(key.lower()) or (near[0] if near else None)
    if meant:
        raise InputError(f"{document.place(('run', key))}: unknown key; did you mean {meant!r}?")


def _entry(document: Document, name: str, entry: WrittenChannel, scales: Mapping[str, Any]) -> ChannelEntry:
    if len(scales) > 1:
        raise InputError(
            f"{document.place(('channels', name))}: there are two scales, {' and '.join(scales)}; keep one of them"
        )
    si_per_unit = known_si_per_unit(entry.quantity, entry.unit)
    for key, number in scales.items():
        try:
            si_per_unit = si_per_unit_from(key, number, quantity=entry.quantity, unit=entry.unit)
        except ValueError as error:
            raise InputError(f"{document.place(('channels', name, key))}: {error}") from None
    if si_per_unit is None:
        raise InputError(f"{document.place(('channels', name, 'unit'))}: {missing_scale(entry.quantity, entry.unit)}")
    return ChannelEntry(quantity=entry.quantity, unit=entry.unit, si_per_unit=si_per_unit, truth=entry.truth)


def _run(document: Document, written: WrittenRun, others: dict[str, Any]) -> Run:
    speed, size = written.speed_rpm, written.particle_size_mm
    return Run(
        motor=written.motor,
        gear_ratio=written.gear_ratio,
        speed=None if speed is None else speed * UNITS["speed"]["rpm"],
        profile=cast(Profile, written.profile),
        set_points=read_set_point(document, written),
        occupancy_percent=written.occupancy_percent,
        particle_size=None if size is None else size * UNITS["length"]["mm"],
        others=others,
    )
