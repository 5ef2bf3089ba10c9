"""A filter chain: stages in order under one name; and the two chains of the reference report."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.moving_mean import MovingMeanKept

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
    from torquerig.orders.kinematics.line_families import Family
    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage

# in the order of the report's code; the band-stop itself subtracts the mean and adds it again
REPORT_FAMILIES: tuple[Family, ...] = ("cogging_per_pole", "slots_times_pole_pairs", "motor", "shaft", "electrical")
REPORT_HARMONICS = 4
REPORT_HALF_WIDTH = 0.5  # Hz
REPORT_MEAN_SAMPLES = 1000


@dataclass(frozen=True, kw_only=True)
class Chain:
    """Stages applied one after the other; a chain is also a stage.

    Parameters
    ----------
    name : str
        The name in tables.
    stages : tuple of Stage
        In order; an empty chain does not change the recording.
    left_out : tuple of str
        Lines of the chain that this drive does not have, each with the reason.
    """

    name: str
    stages: tuple[Stage, ...]
    left_out: tuple[str, ...] = ()

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` after every stage."""
        for stage in self.stages:
            recording = stage.apply(recording)
        return recording

    @property
    def lines(self) -> tuple[KinematicLine, ...]:
        """The distinct lines that the stages remove."""
        return tuple(dict.fromkeys(_lines_of(self.stages)))


def report_filter_code_chain(kinematics: Kinematics) -> Chain:
    """Return the band-stops of the report's Appendix A: five families with four harmonics, +-0.5 Hz each.

    Source: reference report, Appendix A, code lines 14-74. Families that need unknown slots or poles are left out and
    listed.
    """
    lines, left_out = select_lines(kinematics, dict.fromkeys(REPORT_FAMILIES, range(1, REPORT_HARMONICS + 1)))
    stage = IdealBandstop(lines=lines, half_width=REPORT_HALF_WIDTH)
    return Chain(name="report_filter_code", stages=(stage,), left_out=left_out)


def report_filter_text_chain(kinematics: Kinematics) -> Chain:
    """Return the filter of the report's text: the band-stops of its code around a rolling mean of 1000 samples.

    Source: reference report, Appendix A, code line 11 (computed there and never used) and its text; report audit B3.
    """
    code = report_filter_code_chain(kinematics)
    stage = MovingMeanKept(samples=REPORT_MEAN_SAMPLES, around=code.stages)
    return Chain(name="report_filter_text", stages=(stage,), left_out=code.left_out)


def select_lines(
    kinematics: Kinematics, wanted: dict[Family, range] | dict[Family, tuple[int, ...]]
) -> tuple[tuple[KinematicLine, ...], tuple[str, ...]]:
    """Return the lines that ``wanted`` names by family and harmonic, and the reason for each family without lines."""
    highest = max((max(harmonics) for harmonics in wanted.values()), default=1)
    listed = kinematics.lines(highest)
    lines = tuple(
        line
        for family, harmonics in wanted.items()
        for line in listed
        if line.family == family and line.harmonic in harmonics
    )
    missing = kinematics.left_out
    return lines, tuple(f"{family}: {missing[family]}" for family in wanted if family in missing)


def _lines_of(stages: tuple[Stage, ...]) -> Iterator[KinematicLine]:
    for stage in stages:
        yield from getattr(stage, "lines", ())
        yield from _lines_of(getattr(stage, "around", ()))
