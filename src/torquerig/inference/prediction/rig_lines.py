"""Lines of a rig in each segment of a run, by its linear twin."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import spence

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.kept_twin import loads_of, speed_balance
from torquerig.inference.prediction.measuring_chain import crosstalk_lines, passed_by_logger
from torquerig.inference.prediction.phase_modulation import side_lines
from torquerig.inference.prediction.ringing import ringing_lines
from torquerig.inference.prediction.swayed_response import swayed_lines
from torquerig.linear_twin.twin import LineSource, Twin, passed, sources
from torquerig.sensor_stages.band_noise import BandNoise
from torquerig.sensor_stages.flicker import FlickerNoise
from torquerig.sensor_stages.gain_ripple import GainRipple
from torquerig.sensor_stages.noise import WhiteNoise
from torquerig.sensor_stages.scale_and_zero import ScaleAndZero
from torquerig.sensor_stages.tone import Tone, folded

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

SHIFT = 0.01  # [1] of the frequencies of the modes, for a difference quotient
_OF_EXPONENTIAL = pi**2 / 6  # variance of the logarithm of an exponential variate
_DIGITS = 9  # of a frequency: lines that differ later have the same one
_NOTHING = 1e-300  # keeps quotients finite
_ADDED = (WhiteNoise, FlickerNoise, BandNoise, ScaleAndZero)  # stages that neither make nor change a line
_SLOWEST = 0.05  # of the slowest band: slower than this the response of the shafts is that at rest


class RigLines(NamedTuple):
    """Lines of a rig in a run, arrays of shape (lines, segments).

    Frequencies [Hz], mean squares of the amplitudes [(N m)^2], the same with all modes at ``1 - SHIFT`` of their
    frequency, standard deviations of the logarithm of the square over the speeds of each segment [1], and whether they
    follow the shaft, that of ``node``. ``scatter`` is the variance of the logarithm of the square in one block [1], of
    lines that are noise in part, with the half-widths ``half_width`` [Hz], or sums of unknown phases. Lines of a phase
    modulation do not beat with the line that they belong to: together they have a constant amplitude. ``about`` is the
    density that each leaves in the bands, relative to its power [1/Hz], shape (lines, segments, bands). Where lines of
    one frequency are one line here, ``each`` says of which one each of them is part, and holds their mean squares.
    """

    frequency: Floats
    square: Floats
    shifted: Floats
    varied: Floats
    follows: bool
    node: str = ""
    scatter: Floats | float = 0.0
    half_width: Floats | float = 0.0
    beats: bool = True
    about: Floats | None = None
    each: tuple[NDArray[np.intp], Floats] | None = None


def lines_key(twin: Twin, seen: RunFeatures) -> tuple[Hashable, ...]:
    """Return all that the lines in a run depend on; of the loads that is the sway that the angle does not follow."""
    lines = tuple((each.owner, each.order, each.amplitude, each.node, each.phase, each.by_load,
                   *(on for on, _ in each.transfer.acts)) for each in twin.lines())  # fmt: skip
    stages = tuple(stage for stage in twin.rig.stages() if not isinstance(stage, _ADDED))
    slow = any(line.by_load for line in twin.lines()) or any(isinstance(stage, GainRipple) for stage in stages)
    balance = speed_balance(twin, seen) if slow else None
    torques = () if balance is None else (balance.motor.tobytes(), balance.sensor.tobytes())
    is_followed = np.isinf(seen.run.followed) and {line.node for line in twin.lines()} <= {twin.drives[0].on}
    loads = () if is_followed else loads_of(twin.rig)
    return twin.shafts, twin.cutoff, twin.scale, lines, stages, loads, torques


def rig_lines(twin: Twin, seen: RunFeatures) -> Iterator[RigLines]:
    """Yield the lines as they are recorded: those of the shafts, of the measuring chain, and its tones."""
    for each in _at_the_sensor(twin, seen):
        recorded = passed_by_logger(twin.rig, each.frequency)
        own = None if each.each is None else (each.each[0], recorded[each.each[0]] * each.each[1])
        yield each._replace(square=recorded * each.square, shifted=recorded * each.shifted, each=own)


def _at_the_sensor(twin: Twin, seen: RunFeatures) -> Iterator[RigLines]:
    yield from _of_shafts(twin, seen)
    frequency, size = crosstalk_lines(twin, seen)
    if size.size:
        yield RigLines(frequency, size**2, size**2, np.zeros(size.shape), True)
    comb = ringing_lines(twin, seen)
    if comb.amplitude.size:
        square, scatter = comb.amplitude**2, _OF_EXPONENTIAL * np.square(1 - comb.share)
        none = np.zeros(square.shape)
        yield RigLines(comb.frequency, square, square, none, True, scatter=scatter, half_width=comb.half_width)
    yield from gain_lines(twin, seen)
    volts = seen.unit
    for stage in twin.rig.stages():
        if isinstance(stage, Tone):
            tones = np.array([folded(h * stage.frequency, seen.run.rate) for h in range(1, len(stage.amplitudes) + 1)])
            shape = (tones.size, seen.speed.size)
            square = np.broadcast_to(np.square(volts * np.array(stage.amplitudes))[:, None], shape)
            yield RigLines(np.broadcast_to(tones[:, None], shape), square, square, np.zeros(shape), False)


def gain_lines(twin: Twin, seen: RunFeatures) -> Iterator[RigLines]:
    """Yield the lines that a varying gain makes of the slow torque; those that it makes of other lines are left out."""
    for stage in twin.rig.stages():
        if isinstance(stage, GainRipple):
            slow = speed_balance(twin, seen).sensor.reshape(seen.speeds.shape)
            level = np.square(slow).mean(axis=1)
            varied = np.log(np.maximum(np.square(slow), 1e-300)).std(axis=1)
            unit = stage.order * np.abs(seen.speed) / (2 * pi) if stage.order else np.full(level.size, stage.frequency)
            frequency = np.arange(1.0, len(stage.depths) + 1)[:, None] * unit
            square = np.square(stage.depths)[:, None] * level * np.square(np.abs(twin.amplifier(frequency)))
            yield RigLines(frequency, square, square, np.broadcast_to(varied, square.shape), bool(stage.order))


def _of_shafts(twin: Twin, seen: RunFeatures) -> Iterator[RigLines]:
    """Yield the lines of each node, and the side lines that the sway by slower lines makes of them."""
    lines = twin.lines()
    if not lines:
        return
    count, points = seen.speeds.shape
    speeds = seen.speeds.ravel()
    motor = speed_balance(twin, seen).motor
    orders = np.array([line.order for line in lines])[:, None]
    at = np.maximum(orders * np.abs(speeds) / (2 * pi), _SLOWEST * seen.run.slowest)
    both = np.concatenate([at, at * (1 + SHIFT)], axis=1)
    response = passed([line.transfer for line in lines], both)
    gain = np.abs(_together(lines, response * np.tile(sources(lines, motor), 2), np.tile(np.sign(speeds), 2)))
    square, shifted = np.square(gain).reshape(len(lines), 2, count, points).transpose(1, 0, 2, 3)
    here, there = response.reshape(len(lines), 2, count, points).transpose(1, 0, 2, 3)
    steepness = (np.abs(there - here) / np.maximum(np.abs(here), 1e-300)).max(axis=2) / SHIFT
    swayed = swayed_lines(seen, lines, np.sqrt(np.square(np.abs(here)).mean(axis=2)), steepness)
    varied = np.log(np.maximum(square, 1e-300)).std(axis=2)
    frequency = orders * np.abs(seen.speed) / (2 * pi)
    nodes = np.array([line.node for line in lines])
    source = sources(lines, motor).reshape(len(lines), count, points).mean(axis=2)
    side = side_lines(twin, seen, lines, source)
    kept = side.kept if swayed is None else side.kept * swayed.kept
    square, shifted = square.mean(axis=2) * kept, shifted.mean(axis=2) * kept
    for node in dict.fromkeys(nodes.tolist()):
        own = nodes == node
        about = None if swayed is None else swayed.about[own]
        yield RigLines(frequency[own], square[own], shifted[own], varied[own], True, node, about=about)
    for node in dict.fromkeys(side.nodes):
        own = np.array(side.nodes) == node
        yield _of_equal_orders(side.frequency[own], side.square[own], node, seen)


def _together(lines: Sequence[LineSource], waves: Complex, direction: Floats) -> Complex:
    """Return waves of the lines, shape (lines, points), with those of one order whose phases are known summed.

    The first of them has the sum. ``direction`` is the sign of the speed at each point.
    """
    first = dict[float, int]()
    phased = [(row, line.order, line.phase) for row, line in enumerate(lines) if line.phase is not None]
    summed = waves.copy()
    for row, order, phase in phased:
        own = waves[row] * np.exp(1j * phase * direction)
        at = first.setdefault(round(order, _DIGITS), row)
        summed[row] = 0.0
        summed[at] = own if at == row else summed[at] + own
    return summed


def _of_equal_orders(frequency: Floats, square: Floats, node: str, seen: RunFeatures) -> RigLines:
    """Return side lines with one line for each frequency: n + m and n - m of many pairs are the same order.

    How the phases of the pairs stand to each other is unknown, and the same in all blocks.
    """
    different, first, which = np.unique(np.round(frequency[:, 0], _DIGITS), return_index=True, return_inverse=True)
    together, strongest = np.zeros((2, different.size, square.shape[1]))
    np.add.at(together, which, square)
    np.maximum.at(strongest, which, square)
    blocks = np.array([len(segment.blocks) for segment in seen.segments], dtype=float)
    scatter = blocks * beat_variance(together, strongest, np.ones(together.shape))
    none = np.zeros(together.shape)
    return RigLines(frequency[first], together, together, none, True, node, scatter, beats=False, each=(which, square))


def beat_variance(power: Floats, strongest: Floats, count: Floats) -> Floats:
    """Return the variance of the logarithm of the power of lines that share a place, their phases unknown.

    Two phasors of random phase, r the ratio of their powers: ``var ln|1 + sqrt(r) exp(i phi)|^2 = 2 Li2(r)``, Li2 the
    dilogarithm, by the Fourier series ``2 sum (-1)^(k+1) r^(k/2) cos(k phi) / k``. All but the strongest line count as
    the second phasor. In each of ``count`` blocks the phase is another one; of lines of one frequency it is the same in
    all, so that these count as one block.
    """
    ratio = np.clip((power - strongest) / np.maximum(strongest, _NOTHING), 0.0, 1.0)
    return np.asarray(2 * spence(1 - ratio) / np.maximum(count, 1.0))
