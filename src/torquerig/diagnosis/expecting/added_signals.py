"""What the electronics add to a reading, whatever the shafts do: tones, a moving zero, rings, coarse codes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import SHIFTED
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.recording import Recording
from torquerig.sensor_stages.drift import Drift
from torquerig.sensor_stages.ringing import Ringing
from torquerig.sensor_stages.rounding import Rounding
from torquerig.sensor_stages.tone import Tone, folded

Floats = NDArray[np.float64]
_MULTIPLE = 0.02  # [1/rev of the motor] so near a place stands on a multiple of the impacts
_ORDER_TOLD = 0.01  # [1/rev] the order of impacts is told to so much
_BEST_CARRIED = 30.0  # so much better a slow line of impacts may reach the sensor than their ring
_SLOWED = 0.01  # of the order: balls slip by one to two per cent, so impacts come so much slower or faster
_LOAD_ZONE = ((1.0, 0.0), (0.5, 1.0))  # of the amplitude, so many turns of the shaft beside a multiple
_SLOW_RATE = 100.0  # [Hz] a moving zero is looked at so often


@dataclass(frozen=True)
class AddedSignals:
    """Density in each band, level in each part, tones as (frequency [Hz], amplitude [N m]), steps of codes [N m].

    ``impacts`` is the amplitude [N m] that impacts without slip would give the line at each place, ``ringing`` the
    part of ``power`` that rings after them: beside its resonance no two modes are alike. ``carried`` is the density
    that their lines would have in each band if the shafts carried them to the sensor.
    """

    power: Floats
    level: Floats
    tones: tuple[tuple[float, float], ...]
    codes: tuple[float, ...] = ()
    impacts: Floats | float = 0.0
    ringing: Floats | float = 0.0
    carried: Floats | float = 0.0


def added_signals(twin: Twin, seen: Features) -> AddedSignals:
    """Return what the measuring chain adds to a reading of zero over the run of ``seen``."""
    observed, bands = seen.observed, seen.band.size
    unit = observed.torque_unit
    power = np.zeros(bands)
    tones: list[tuple[float, float]] = []
    codes: list[float] = []
    struck: Floats | float = 0.0
    ringing: Floats | float = 0.0
    carried: Floats | float = 0.0
    for stage in twin.rig.stages():
        if isinstance(stage, Tone):
            tones += [
                (folded(harmonic * stage.frequency, observed.rate), volts * unit)
                for harmonic, volts in enumerate(stage.amplitudes, start=1)
            ]
        elif isinstance(stage, Rounding):
            codes.append(stage.step * unit)
        elif isinstance(stage, Ringing):
            struck = np.hypot(struck, _struck(stage, twin, seen))
            carried = carried + _struck_between(stage, twin, seen)
    for _, rung in rung_by(twin, seen):
        power, ringing = power + rung, ringing + rung
    return AddedSignals(power, zero_of(twin, seen), tuple(tones), tuple(codes), struck, ringing, carried)


def rung_by(twin: Twin, seen: Features) -> Iterator[tuple[Ringing, Floats]]:
    """Yield each mode that impacts ring, and the density that it leaves in each band of a run [(N m)^2/Hz]."""
    for stage in twin.rig.stages():
        if isinstance(stage, Ringing):
            yield (
                stage,
                stage.density_between(*seen.band_edges, _impacts(stage, seen)) * twin.amplifier_power(seen.band),
            )


def _struck(stage: Ringing, twin: Twin, seen: Features) -> Floats:
    """Amplitude at each place that is a multiple of the impacts' order: all power between two multiples in one line.

    Half of it a turn beside: impacts that swell and fade as the shaft turns through its load zone (Randall & Antoni
    2011, 2.1), by how much is not known.
    """
    each = stage.order * stage.turns
    revolutions = abs(seen.observed.mean_speed) / (2 * pi)
    answer = np.zeros(len(seen.places))
    for column, place in enumerate(seen.places if revolutions else ()):
        at = place.frequency(abs(seen.observed.mean_speed))
        multiple = np.round(at / revolutions / each)
        apart = abs(at / revolutions - each * multiple)
        strays = seen.observed.smearing * SHIFTED * at / revolutions + _ORDER_TOLD * stage.turns * multiple
        # where the angle was followed, a whole order beside a multiple may be taken for the peak's place
        strays = max(strays if seen.observed.smearing else 0.0, _SLOWED * each * multiple)
        reaches = (max(_MULTIPLE, strays), _MULTIPLE)
        by_zone = [
            share
            for (share, turns), reach in zip(_LOAD_ZONE, reaches, strict=True)
            if abs(apart - turns * stage.turns) < reach
        ]
        if by_zone:
            density = stage.density(np.array([at]), each * revolutions) * twin.amplifier_power(np.array([at]))
            lone = np.sqrt(2 * float(density[0]) * each * revolutions)
            answer[column] = by_zone[0] * lone * _carried(stage, at)
    return answer


def _impacts(stage: Ringing, seen: Features) -> float:
    """Return how many impacts there are a second [Hz]."""
    return float(stage.order * stage.turns * abs(seen.observed.mean_speed) / (2 * pi))


def _struck_between(stage: Ringing, twin: Twin, seen: Features) -> Floats:
    """Density in each band of the multiples that may stand in it, beyond what their ring has there, shape (bands,)."""
    spacing = _impacts(stage, seen)
    if not (seen.power.size and spacing):
        return np.zeros(seen.band.size)
    low, high = seen.band_edges
    lines = np.floor(high * (1 + _SLOWED) / spacing) - np.ceil(low * (1 - _SLOWED) / spacing) + 1
    better = np.array([_carried(stage, at) ** 2 - 1 for at in seen.band.tolist()])
    density = stage.density(seen.band, spacing) * twin.amplifier_power(seen.band)
    return np.asarray(density * better * np.maximum(lines, 0.0) * spacing / seen.width)


def _carried(stage: Ringing, at: float) -> float:
    """Return by how much better a frequency reaches the sensor than the mode's own, if the shafts carry the impacts.

    Whether the mode shakes the sensor or drives the shafts is not known; above their modes the latter pass a torque
    on by the inverse square of its frequency. Never less than 1.
    """
    return float(np.clip((stage.frequency / at) ** 2, 1.0, _BEST_CARRIED)) if at else _BEST_CARRIED


def zero_of(twin: Twin, seen: Features) -> Floats:
    """Mean of what a moving zero adds to each part of a run [N m], shape (parts,)."""
    return moving_zero(twin, seen.observed, [part.start for part in seen.parts], [part.stop for part in seen.parts])


def moving_zero(twin: Twin, observed: Observed, starts: ArrayLike, stops: ArrayLike) -> Floats:
    """Mean of what a moving zero adds between samples ``starts`` and ``stops`` of a run [N m], shape (starts,)."""
    drifts = [stage for stage in twin.rig.stages() if isinstance(stage, Drift)]
    if not drifts:
        return np.zeros(np.size(starts))
    recording = observed.recording
    name = recording.torque_name()
    count = max(2, round(recording.duration * _SLOW_RATE))
    silence = replace(recording.channels[name], values=np.zeros(count))
    silent = Recording(sample_rate=count / recording.duration, channels={name: silence}, run=recording.run)
    share = count / recording.samples
    low = (np.asarray(starts) * share).astype(int)
    high = np.maximum((np.asarray(stops) * share).astype(int), low + 1)
    total = np.zeros(low.size)
    for drift in drifts:
        summed = np.concatenate([[0.0], np.cumsum(drift.apply(silent).channels[name].in_si())])
        total += (summed[high] - summed[low]) / (high - low)
    return total
