"""A filter chain: stages by one name, in order; and the seed's two chains."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.moving_mean import MovingMeanKept

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import Family, KinematicLine, Kinematics
    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage

# in the order of the seed's code; the mean is taken off and put back by the band-stop itself
SEED_FAMILIES: tuple[Family, ...] = ("cogging_as_published", "unknown_as_published", "motor", "shaft", "electrical")
SEED_HARMONICS = 4
SEED_HALF_WIDTH = 0.5  # Hz
SEED_MEAN_SAMPLES = 1000


@dataclass(frozen=True, kw_only=True)
class Chain:
    """Stages applied one after the other; itself a stage.

    Parameters
    ----------
    name : str
        What the chain is called in tables.
    stages : tuple of Stage
        In order; none leaves the recording as it is.
    left_out : tuple of str
        Lines that the chain names but this drive does not have, each with the reason.
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
        """The lines that any of the stages takes out, each once."""
        return tuple(dict.fromkeys(_lines_of(self.stages)))


def seed_code_chain(kinematics: Kinematics) -> Chain:
    """Return the filter of the seed's Appendix A: five families, fundamental and three harmonics, +-0.5 Hz each.

    Source: seed Appendix A, code lines 14-74. Families that need unknown slots or poles are left out and named.
    """
    lines, left_out = select_lines(kinematics, dict.fromkeys(SEED_FAMILIES, range(1, SEED_HARMONICS + 1)))
    stage = IdealBandstop(lines=lines, half_width=SEED_HALF_WIDTH)
    return Chain(name="seed_code", stages=(stage,), left_out=left_out)


def seed_text_chain(kinematics: Kinematics) -> Chain:
    """Return the filter that the seed's text describes: as its code, but around a rolling mean of 1000 samples.

    Source: seed Appendix A, code line 11 (computed there and never used) and its text; seed audit B3.
    """
    code = seed_code_chain(kinematics)
    stage = MovingMeanKept(samples=SEED_MEAN_SAMPLES, around=code.stages)
    return Chain(name="seed_text", stages=(stage,), left_out=code.left_out)


def select_lines(
    kinematics: Kinematics, wanted: dict[Family, range] | dict[Family, tuple[int, ...]]
) -> tuple[tuple[KinematicLine, ...], tuple[str, ...]]:
    """Return the lines that ``wanted`` names by family and harmonic, and why any of the families has none here."""
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
