"""Lines spread over a hertz or two: too wide for a peak, too narrow for a band of the spectrum to show them.

A line whose phase jumps L times a second is spread over about L/pi hertz (a Lorentzian, the spectrum of a phase that
forgets itself at that rate), as is a tone whose frequency wanders. What a load or a sensor makes is smooth over so
little.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import e, log10, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.diagnosis.looking.spread_heights import (
    HIGHEST,
    LOWEST,
    STEP,
    SpreadHeights,
    spectrum_beside,
    spread_heights,
)
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

_WIDTHS = (1.5, 3.0)  # [Hz] over which the power is gathered
_CLEAR = 6.3  # spreads of one run, or of several together; chance reaches 5.8 on 180 clean rigs
_SHOWS = 2.0  # in a run that is named
_ONE_FREQUENCY = 1.0  # spreads more, at one order than at one frequency, before it is told to turn
_SKIRT, _MIRRORED = 0.06, 0.4  # within this share of a line's frequency, with this share of the spreads across the line


@dataclass(frozen=True)
class _Together:
    """Runs put together at orders of the motor [1/rev] or at frequencies [Hz], one of which is ``scales`` [Hz] in each.

    ``spreads`` are those of the run that shows most; at orders of the runs that show most, so many that it is most.
    """

    domain: str
    width: float
    runs: tuple[SpreadHeights, ...]
    at: Floats
    scales: Floats
    spreads: Floats

    def told(self, known: Sequence[Place], places: int) -> Mismatch | None:
        """Return where they stand out most; None unless clearly, or where that is a skirt of a known line."""
        top = int(np.argmax(self.spreads))
        there = self.at[top] * self.scales
        each = [run.at(there[row : row + 1]) for row, run in enumerate(self.runs)]
        spreads, heights = (np.array([one[kind][0] for one in each]) for kind in (0, 1))
        most = int(np.argmax(spreads))
        if self.spreads[top] < _CLEAR or _skirt(self.runs[most], float(there[most]), known, self.width):
            return None
        return Mismatch(
            domain=self.domain, axis="motor_shaft" if self.domain == "order" else "Hz", at=float(self.at[top]),
            width=self.width / float(self.scales.mean()),
            recordings=tuple(run.run.name for run, shown in zip(self.runs, spreads > _SHOWS, strict=True) if shown),
            excess_dB=10 * log10(e) * float(heights.max()), share_of_misfit=0.0,
            p_value=by_chance(float(self.spreads[top]), places),
        )  # fmt: skip


def spread_line(case: Case) -> Mismatch | None:
    """Return the clearest spread line that the steady runs show beside the case's known ones, None where none does.

    At one order or at one frequency, whichever the runs show better. ``share_of_misfit`` is 0: the bands and lines
    that fits compare do not show it.
    """
    known, steady = case.seen[0].places, [run for run in case.runs if run.steady and not run.rebuilt]
    spectra, every = [(run, spectrum_beside(run, known)) for run in steady], list[_Together]()
    for width in _WIDTHS:
        runs = tuple(each for run, beside in spectra if (each := spread_heights(run, beside, width)) is not None)
        every += [_together(domain, runs, width) for domain in ("frequency", "order")] if runs else []
    places = sum(each.at.size for each in every)
    found = [(float(each.spreads.max()) - _ONE_FREQUENCY * (each.domain == "order"), told)
             for each in every if (told := each.told(known, places)) is not None]  # fmt: skip
    return max(found, key=lambda row: row[0])[1] if found else None


def _together(domain: str, runs: tuple[SpreadHeights, ...], width: float) -> _Together:
    speeds = np.array([abs(each.run.mean_speed) for each in runs])
    scales = speeds / (2 * pi) if domain == "order" else np.ones(speeds.size)
    at = np.arange(LOWEST / scales.min(), HIGHEST / scales.max(), STEP / scales.max())
    spreads = np.sort([each.at(at * scale)[0] for each, scale in zip(runs, scales, strict=True)], axis=0)[::-1]
    if domain == "frequency":  # there every run has the modes of the rig, which no model has to the last hertz
        return _Together(domain, width, runs, at, scales, spreads[0])
    number = np.arange(1, len(runs) + 1)[:, None]
    return _Together(domain, width, runs, at, scales, (np.cumsum(spreads, axis=0) / np.sqrt(number)).max(axis=0))


def _skirt(shown: SpreadHeights, at: float, known: Sequence[Place], width: float) -> bool:
    """Whether a run stands out as well across a line, which an angle that was not measured spreads evenly.

    Along a measured one too a line has a foot: what shakes the shaft changes its amplitude.
    """
    lines = [place.frequency(shown.run.mean_speed) for place in known if place.domain == "order"]
    across = [
        np.abs(shown.frequency - (2 * line - at)) < 0.5 * width
        for line in lines
        if abs(line - at) < (width if shown.run.angle_measured else _SKIRT * line)
    ]
    mirrored = max((float(shown.spreads[there].max(initial=0.0)) for there in across), default=0.0)
    return bool(mirrored > _MIRRORED * float(shown.at(np.array([at]))[0][0]))
