"""The result of ``torquerig info``: what is in recordings, and what is missing or suspicious."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import pi

from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.file_contents import ColumnContents, FileContents
from torquerig.recordings.inspection.pauses import Pauses
from torquerig.recordings.inspection.recording_info import RecordingInfo
from torquerig.reporting.json_results.values import Missing, known

_NO_PAUSE = "the recording has no pause of ten samples or more"


@dataclass(frozen=True)
class PausesResult:
    """The pauses of a recording: their number, and shortest, longest and total time from sample to sample."""

    count: int
    shortest_s: float
    longest_s: float
    total_s: float


@dataclass(frozen=True)
class ColumnResult:
    """A column: what it is taken for and why, rate, length and levels in its unit; ``to_add`` for the sidecar."""

    name: str
    quantity: str
    unit: str
    role: str
    of: str
    known_by: str
    to_add: str
    sample_rate_Hz: float | Missing  # noqa: N815 (the unit in the key)
    samples: int
    not_numbers: int
    duration_s: float | Missing
    minimum: float | Missing
    mean: float | Missing
    maximum: float | Missing
    std: float | Missing


@dataclass(frozen=True)
class RecordingResult:
    """A file; ``problem`` is the reason why it cannot be used as it is, empty where it can."""

    path: str
    problem: str
    sample_rate_Hz: float | Missing  # noqa: N815 (the unit in the key)
    duration_s: float | Missing
    span_s: float | Missing
    pauses: PausesResult | Missing
    motor_speed_rpm: float | Missing
    motor_speed: str
    columns: tuple[ColumnResult, ...]
    time: str
    skipped: Mapping[str, str]
    notes: tuple[str, ...]
    suspicions: tuple[str, ...]


@dataclass(frozen=True)
class InfoResult:
    """All files that were named."""

    recordings: tuple[RecordingResult, ...]


def column_result(
    one: ColumnContents, *, role: str = "", of: str = "", rate: float | None = None, duration: float | None = None
) -> ColumnResult:
    """Return a column; ``rate`` [Hz] and ``duration`` [s] are those of the recording where it can be used."""
    no_rate, no_level = "the sample rate is not known", "the column has no finite number"
    return ColumnResult(
        name=one.name, quantity=one.quantity, unit=one.unit or "", role=role, of=of, known_by=one.reason,
        to_add=one.missing, sample_rate_Hz=known(rate or one.rate, no_rate), samples=one.samples, not_numbers=one.gone,
        duration_s=known(duration if duration is not None else one.duration, no_rate),
        minimum=known(one.minimum, no_level), mean=known(one.mean, no_level), maximum=known(one.maximum, no_level),
        std=known(one.std, no_level),
    )  # fmt: skip


def unreadable(path: str, problem: str) -> RecordingResult:
    """Return the result of a file that cannot be read at all."""
    gone = Missing("the file cannot be read")
    return RecordingResult(path, problem, gone, gone, gone, gone, gone, "", (), "", {}, (), ())


def _pauses(found: Pauses | None) -> PausesResult | Missing:
    if found is None:
        return Missing(_NO_PAUSE)
    return PausesResult(found.count, found.shortest, found.longest, found.total)


def unusable(contents: FileContents) -> RecordingResult:
    """Return the result of a file that is read, but lacks what a recording needs."""
    gone = Missing(contents.problem)
    return RecordingResult(
        path=contents.path.as_posix(), problem=contents.problem, sample_rate_Hz=gone, duration_s=gone, span_s=gone,
        pauses=gone, motor_speed_rpm=gone, motor_speed="", columns=tuple(map(column_result, contents.columns)),
        time=contents.time or "", skipped=dict(contents.skipped), notes=contents.notes, suspicions=(),
    )  # fmt: skip


def usable(
    contents: FileContents, stream: RecordingStream, info: RecordingInfo, *, speed: float | None, speed_text: str,
    suspicions: Sequence[str],
) -> RecordingResult:  # fmt: skip
    """Return the result of a recording; ``speed`` [rad/s] is that of the motor."""
    columns = []
    for one in contents.columns:
        entry = stream.entries.get(one.name)
        role, of = ("", "") if entry is None else (entry.role or "", entry.of or "")
        columns.append(column_result(one, role=role, of=of, rate=info.sample_rate, duration=info.duration))
    return RecordingResult(
        path=contents.path.as_posix(), problem="", sample_rate_Hz=info.sample_rate, duration_s=info.duration,
        span_s=info.span, pauses=_pauses(info.pauses),
        motor_speed_rpm=known(None if speed is None else speed * 30 / pi, speed_text), motor_speed=speed_text,
        columns=tuple(columns), time=contents.time or "", skipped=dict(contents.skipped),
        notes=tuple(stream.table.notes), suspicions=tuple(suspicions),
    )  # fmt: skip
