"""Reading of a sidecar: channels, test conditions and origin of a recording (CONTRACTS.md, section 1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError, did_you_mean
from torquerig.recordings.files.scale import known_si_per_unit, missing_scale, si_per_unit_from
from torquerig.recordings.files.set_point_text import read_set_point
from torquerig.recordings.files.sidecar_schema import (
    IN_OTHERS,
    WrittenChannel,
    WrittenRun,
    WrittenSidecar,
    sidecar_schema,
)
from torquerig.recordings.quantities import OTHER
from torquerig.recordings.recording import Channel
from torquerig.recordings.run import Profile, Run
from torquerig.recordings.tacho_statement import PULSES, tacho_conditions
from torquerig.units import UNITS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_CHANNEL_KEYS = {one.name for one in fields(WrittenChannel)}
_RUN_KEYS = {one.name for one in fields(WrittenRun)}
_RUN_SLIPS = {"speed": "speed_rpm", "rpm": "speed_rpm", "occupancy": "occupancy_percent"}  # too unlike to be found
_RUN_SLIPS |= {"particle_size": "particle_size_mm", "ratio": "gear_ratio"}
_RUN_SLIPS |= {"lead": "travel_per_turn_mm", "lead_mm": "travel_per_turn_mm", "pitch_mm": "travel_per_turn_mm"}


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
    of: str | None = None
    role: str | None = None
    tare: bool = False
    reason: str = ""
    missing: str = ""

    def channel(self, values: NDArray[np.float64]) -> Channel:
        """Return the channel with these samples, shape (samples,)."""
        return Channel(
            values=values, quantity=self.quantity, unit=self.unit, si_per_unit=self.si_per_unit, truth=self.truth,
            of=self.of, role=self.role, tare=self.tare,
        )  # fmt: skip


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
    return sidecar_from(read_document(path))


def sidecar_from(document: Document) -> Sidecar:
    """Return the sidecar that a document holds; errors as in :func:`read_sidecar`."""
    if not isinstance(document.data, dict):
        raise InputError(f"{document.place()}: a sidecar holds the keys sample_rate_Hz, channels and run; write them")
    _refuse_unknown_conditions(document)
    pruned, scales = _pruned(document)
    written = validated(pruned, sidecar_schema())
    if written.encoder is not None:
        scales |= _encoder_scales(document, written, scales)
    channels = {
        name: _entry(document, name, entry, scales.get(name, {})) for name, entry in (written.channels or {}).items()
    }
    return Sidecar(
        path=document.path,
        sample_rate=written.sample_rate_Hz,
        channels=channels,
        run=_run(document, written),
        origin=written.origin or {},
    )


def _encoder_scales(
    document: Document, written: WrittenSidecar, scales: Mapping[str, Mapping[str, Any]]
) -> dict[str, dict[str, Any]]:
    """Return the scale of each angle in counts that has none of its own, from ``encoder:``."""
    counts = {} if written.encoder is None else {"counts_per_rev": written.encoder.counts_per_rev}
    entries = (written.channels or {}).items()
    angles = [name for name, one in entries if one.quantity in ("angle", "motor_angle") and one.unit == "count"]
    found = {name: counts for name in angles if not scales.get(name)}
    if not found:
        raise InputError(
            f"{document.place(('encoder',))}: no channel is an angle in counts without a scale; give the encoder's "
            "channel quantity: motor_angle and unit: count, or remove this key"
        )
    return found


def _pruned(document: Document) -> tuple[Document, dict[str, dict[str, Any]]]:
    """Return the document without scales, whose keys the schema cannot list."""
    data, scales = dict(document.data), {}
    if isinstance(data.get("channels"), dict):
        entries: dict[Any, Any] = {}
        for name, entry in data["channels"].items():
            entries[name] = entry
            if isinstance(entry, dict):
                _refuse_decimal_comma(document, str(name), entry)
                scaling = {str(key): value for key, value in entry.items() if "_per_" in str(key)}
                scales[name] = {key: value for key, value in scaling.items() if key != PULSES}
                entries[name] = {key: value for key, value in entry.items() if str(key) not in scales[name]}
        data["channels"] = entries
    return replace(document, data=data), scales


def _refuse_decimal_comma(document: Document, name: str, entry: Mapping[Any, Any]) -> None:
    """Raise InputError for ``Nm_per_V: 5,0``, which YAML reads as the number 5 and a key 0."""
    keys = list(entry)
    for before, key in pairwise(keys):
        if isinstance(key, int) and entry[key] is None:
            raise InputError(
                f"{document.place(('channels', name, before))}: {entry[before]},{key} has a decimal comma; write "
                f"{entry[before]}.{key}"
            )


def _refuse_unknown_conditions(document: Document) -> None:
    """Raise InputError for an unknown key of ``run:``, and for a known one among the further conditions."""
    run = document.data.get("run")
    if not isinstance(run, dict):
        return
    further = run.get("others") if isinstance(run.get("others"), dict) else {}
    for key in further or {}:
        if key in _RUN_KEYS or str(key).lower() in _RUN_SLIPS:
            meant = key if key in _RUN_KEYS else _RUN_SLIPS[str(key).lower()]
            raise InputError(f"{document.place(('run', 'others', key))}: is no further condition; write it as "
                             f"{meant!r} directly below run:")  # fmt: skip
    for key in run:
        if key in _RUN_KEYS:
            continue
        close = did_you_mean(str(key), _RUN_KEYS)
        meant = f"did you mean {_RUN_SLIPS[str(key).lower()]!r}?" if str(key).lower() in _RUN_SLIPS else close
        if not meant.startswith("did you mean"):
            meant = f"write a further condition as others: {{{key}: ...}}; {close}"
        raise InputError(f"{document.place(('run', key))}: unknown key; {meant}")


def _entry(document: Document, name: str, entry: WrittenChannel, scales: Mapping[str, Any]) -> ChannelEntry:
    # what is kept and not used needs no unit
    unit = "1" if entry.unit is None and entry.quantity == OTHER else entry.unit
    if unit is None:
        raise InputError(f"{document.place(('channels', name))}: the key 'unit' is missing; add it")
    if len(scales) > 1:
        raise InputError(
            f"{document.place(('channels', name))}: there are two scales, {' and '.join(scales)}; keep one of them"
        )
    si_per_unit = known_si_per_unit(entry.quantity, unit)
    for key, number in scales.items():
        try:
            si_per_unit = si_per_unit_from(key, number, quantity=entry.quantity, unit=unit)
        except ValueError as error:
            raise InputError(f"{document.place(('channels', name, key))}: {error}") from None
    if si_per_unit is None:
        raise InputError(f"{document.place(('channels', name, 'unit'))}: {missing_scale(entry.quantity, unit)}")
    return ChannelEntry(
        quantity=entry.quantity, unit=unit, si_per_unit=si_per_unit, truth=entry.truth, of=entry.of,
        role=entry.role, tare=entry.tare,
    )  # fmt: skip


def _run(document: Document, sidecar: WrittenSidecar) -> Run:
    written, notes = sidecar.run or WrittenRun(), sidecar.notes
    stated = {key: getattr(written, key) for key in IN_OTHERS} | tacho_conditions(document, sidecar)
    both = [note for note in (notes, written.notes) if note is not None]
    stated["notes"] = both if len(both) > 1 else both[0] if both else None
    stated["teeth"] = sidecar.teeth
    speed, size, travel = written.speed_rpm, written.particle_size_mm, written.travel_per_turn_mm
    return Run(
        motor=written.motor,
        gear_ratio=written.gear_ratio,
        travel_per_turn=None if travel is None else travel * UNITS["length"]["mm"],
        speed=None if speed is None else speed * UNITS["speed"]["rpm"],
        profile=cast(Profile, written.profile),
        set_points=read_set_point(document, written),
        occupancy_percent=written.occupancy_percent,
        particle_size=None if size is None else size * UNITS["length"]["mm"],
        others={key: value for key, value in stated.items() if value is not None} | (written.others or {}),
    )
