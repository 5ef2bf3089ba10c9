"""Curves for pictures: what a recording shows, and what the nominal and the completed model expect of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.engine import Outcome
from torquerig.inference.features.run_features import RunFeatures, run_features
from torquerig.inference.features.segment import Segment
from torquerig.inference.fit import Fit
from torquerig.inference.load_spectrum import gain_shapes, with_gains
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_HANN = 1.5  # [bins] equivalent noise bandwidth of a Hann window


@dataclass(frozen=True, kw_only=True)
class SpectrumCurves:
    """Amplitudes of one run at about one speed.

    Parameters
    ----------
    name : str
        Of the recording.
    rpm : float
        Mean speed of the motor [1/min].
    frequency, measured : ndarray, shape (bins,)
        [Hz], and amplitude of each bin, zero to peak [N m], averaged over blocks in power.
    band : ndarray, shape (bands,)
        Middles [Hz].
    band_nominal, band_completed : ndarray, shape (bands,)
        Amplitude that the models' densities make in a bin [N m].
    line : ndarray, shape (lines,)
        Frequencies of the lines that are compared [Hz].
    line_measured, line_nominal, line_completed : ndarray, shape (lines,)
        [N m], zero to peak.
    line_names : tuple of str
        What was added to the model there; empty for other lines.
    """

    name: str
    rpm: float
    frequency: Floats
    measured: Floats
    band: Floats
    band_nominal: Floats
    band_completed: Floats
    line: Floats
    line_measured: Floats
    line_nominal: Floats
    line_completed: Floats
    line_names: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class LevelCurves:
    """Mean torques of the parts of one run [N m], shape (parts,) each; ``time`` [s] is the middle of a part.

    ``scatter`` is one standard deviation of what the completed model expects.
    """

    name: str
    time: Floats
    measured: Floats
    nominal: Floats
    completed: Floats
    scatter: Floats
    held_out: NDArray[np.bool_]


@dataclass(frozen=True)
class RunCurves:
    """Pictures' data of one run; ``gain`` [N m] is by how much the model improves in it."""

    spectrum: SpectrumCurves | None
    levels: LevelCurves
    gain: float
    is_steady: bool


def run_curves(outcome: Outcome) -> tuple[RunCurves, ...]:
    """Return the curves of every run, fitted and held-out blocks together."""
    names = {place: each.mechanism or each.kind for each in outcome.model.additions for place in each.places}
    places = outcome.data.seen[0].places
    answer = []
    for row, run in enumerate(outcome.runs):
        seen = run_features(run, places, held_out=None)
        models = [
            _expected(fit, rig, seen, row=row, runs=outcome.runs)
            for fit, rig in ((outcome.nominal, outcome.nominal.fitted_rig), (outcome.model.fit, outcome.completed))
        ]
        texts = tuple(names.get(place, "").replace("_", " ") for place in places)
        spectrum = _spectrum(seen, models, texts) if seen.segments else None
        levels = _levels(seen, models)
        answer.append(RunCurves(spectrum, levels, _gain(spectrum, levels), run.is_steady))
    return tuple(answer)


def _expected(fit: Fit, rig: Rig, seen: RunFeatures, *, row: int, runs: Sequence[MeasuredRun]) -> ExpectedRun:
    return with_gains(expected_run(rig, seen), gain_shapes(seen, run=row, runs=runs), fit.gains)


def _spectrum(seen: RunFeatures, models: Sequence[ExpectedRun], names: tuple[str, ...]) -> SpectrumCurves:
    """Return the spectrum of the segment that holds most of the run, and of several the fastest."""
    row = max(range(len(seen.segments)), key=lambda at: (len(seen.segments[at].blocks), abs(seen.segments[at].speed)))
    segment = seen.segments[row]
    frequency, measured = _amplitudes(seen, segment)
    bin_width = _HANN / seen.duration_of(segment)
    shown = np.flatnonzero(segment.line_count > 0)
    bands = segment.bands
    noise = np.interp(seen.line_frequency[row, shown], bands.middle, np.nan_to_num(bands.power))
    line = np.maximum(segment.line_power[shown] - segment.line_noise_bandwidth[shown] * noise, 0.0)
    nominal, completed = (np.sqrt(np.maximum(each.line_power[row, shown], 0.0)) for each in models)
    low, high = (np.sqrt(2 * each.density[row] * bin_width) for each in models)
    return SpectrumCurves(
        name=seen.run.name, rpm=segment.speed * 30 / pi, frequency=frequency, measured=measured, band=bands.middle,
        band_nominal=low, band_completed=high, line=seen.line_frequency[row, shown], line_measured=np.sqrt(line),
        line_nominal=nominal, line_completed=completed, line_names=tuple(names[at] for at in shown.tolist()),
    )  # fmt: skip


def _amplitudes(seen: RunFeatures, segment: Segment) -> tuple[Floats, Floats]:
    """Return frequencies [Hz] and amplitudes [N m] of a segment, blocks of the shortest length averaged in power."""
    length = min(block.stop - block.start for block in segment.blocks)
    window = np.hanning(length)
    power = np.zeros(length // 2 + 1)
    for block in segment.blocks:
        part = seen.run.torque[block.start : block.start + length]
        power += np.abs(np.fft.rfft((part - part.mean()) * window) * 2 / window.sum()) ** 2 / len(segment.blocks)
    frequency = np.arange(power.size) * seen.run.rate / length
    return frequency[2:], np.sqrt(power[2:])  # without the mean and what the window spreads of it


def _levels(seen: RunFeatures, models: Sequence[ExpectedRun]) -> LevelCurves:
    middle = seen.parts.mean(axis=1)
    held = [any(block.held_out and block.start <= at < block.stop for block in seen.run.blocks) for at in middle]
    nominal, completed = models
    return LevelCurves(
        name=seen.run.name, time=middle / seen.run.rate, measured=seen.level, nominal=nominal.level,
        completed=completed.level, scatter=np.sqrt(np.diag(completed.level_covariance)), held_out=np.array(held),
    )  # fmt: skip


def _gain(spectrum: SpectrumCurves | None, levels: LevelCurves) -> float:
    before = float(np.mean((levels.measured - levels.nominal) ** 2))
    after = float(np.mean((levels.measured - levels.completed) ** 2))
    if spectrum is not None:
        before += 0.5 * float(np.sum((spectrum.line_measured - spectrum.line_nominal) ** 2))
        after += 0.5 * float(np.sum((spectrum.line_measured - spectrum.line_completed) ** 2))
    return float(np.sqrt(before) - np.sqrt(after))
