"""Torque over time and its spectrum: the curves, ranges and lines of the two plots of a what-if."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10
from typing import Any

import numpy as np

from torquerig.filters.filter_effect import LineLevel
from torquerig.metrics.truth_error import true_load
from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.spectrum import hann_spectrum
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.figures.families import COLOURS
from torquerig.studio.what_if.quick_curve import quick_curve

FIRST_VIEW = 0.3  # [s] some turns of the shaft; the whole recording is one click on reset away
LEAST = 1e-9  # smallest amplitude that is drawn, below any converter step
DECADES = 5  # of the axis below the largest peak
BEYOND = 1.3  # [1] end of the first view of the spectrum, over the highest line
IN_VIEW = 2  # harmonics of each cause in the first view
HIGHEST = 2000.0  # [Hz] end of the first view where no line is known


def signal_view(before: Recording, after: Recording) -> dict[str, Any]:
    """Return plot and curves of the torque over time: before and after the filter, and the true load where known."""
    load, step = true_load(before), 1 / before.sample_rate
    values = {"before": before.torque(), "after": after.torque()} | ({} if load is None else {"load": load})
    return {
        "plot": ("signal", tuple(values), f"{effort_name(before)} [{effort_unit(before)}]"),
        "curves": {name: quick_curve(curve, start=0.0, step=step) for name, curve in values.items()},
        "first": [0.0, min(FIRST_VIEW, before.duration)], "whole": [0.0, before.duration],
    }  # fmt: skip


def spectrum_view(before: Recording, after: Recording, levels: Sequence[LineLevel]) -> dict[str, Any]:
    """Return plot and curves of the amplitude spectrum, with the lines of the drive and their causes.

    Amplitudes are by a Hann window [N m]. Without ``levels``, as of a run that is not steady, no line is marked.
    """
    spectra = {
        name: hann_spectrum(one.torque(), one.sample_rate) for name, one in (("before", before), ("after", after))
    }
    frequency = spectra["before"][0]
    step, end = float(frequency[1] - frequency[0]), float(frequency[-1])
    top = 10.0 ** ceil(log10(max(LEAST, *(float(one[1:].max()) for _, one in spectra.values()))))
    low = 10.0 ** (floor(log10(top)) - DECADES)
    shown = [one.frequency for one in levels if one.line.harmonic <= IN_VIEW]
    highest = BEYOND * max(shown, default=HIGHEST / BEYOND)
    return {
        "plot": ("spectrum", ("before", "after"), f"amplitude [{effort_unit(before)}]"),
        "curves": {
            name: quick_curve(np.log10(np.maximum(one[1:], LEAST)), start=step, step=step, logarithmic=True)
            for name, (_, one) in spectra.items()
        },
        "lines": {
            "x": [one.frequency for one in levels], "low": [low] * len(levels), "high": [top] * len(levels),
            "cause": [name_of(one.line) for one in levels], "colour": [COLOURS[one.line.family] for one in levels],
            "order": [f"{one.line.output_order:.5g} per output turn" for one in levels],
        },
        "first": [0.0, min(highest, end)], "whole": [0.0, end], "y": [low, top],
    }  # fmt: skip
