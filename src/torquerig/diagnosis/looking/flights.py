"""Flights: moments in which the flanks of a gear have parted, ended by the blow with which they meet again.

Between two flanks nothing drives the shafts behind the gear, so the sensor reads next to nothing, and that quietly. No
linear rig stays there and then jumps.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.linear_twin.quasi_static import behind_sensor
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.repair.robust_spread import spread_about_zero
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Inertia
from torquerig.scenario.kinematics import gears_to_sensor

Floats = NDArray[np.float64]

CLEARLY = 5  # flights that no rig without a gap shows, long ones counted twice
BY_CHANCE = 0.1  # flights in four runs of a rig without a gap: 22 in 226 blind rigs, three at most in one
_SMOOTHED, _BLOW = 1e-3, 1.5e-3  # [s] short against a flight; in which a blow rises
_HARD, _CODES = 12.0, 2.2  # noises, and steps of coarse codes, that a blow rises by: two may follow one another
_QUIET, _NOISY = 12.0, 6.0  # spreads of the smoothed noise within which a flight stays, from top to bottom
_QUIET_AT_MOST = 0.012  # [N m] the same: under more noise, shoulders of waves would look quiet
SHORTEST, _LONG = 4e-3, 12e-3  # [s]; of five in 18 rigs without a gap the longest lasted 7 ms
UNDRIVEN = 0.03  # [N m] what friction and weak inertias ask for
_NEAR_LEVEL = 0.012  # [N m] by which the torque leaves the level of a flight where the flanks part
_SLOPE = 2.5e-3  # [s] each way, over which the speed at the parting is taken
_SMALLEST = 0.05  # of all that a torque moves by, the smallest steps: what was mended is less
_TRIMMED, _OF_TRIMMED = 0.95, 0.871  # quantile, and the rms of a normal variate below it


@dataclass(frozen=True)
class Flight:
    """Samples ``start`` to ``stop``, and by what angle [rad] the flanks moved meanwhile, at the gear's output."""

    start: int
    stop: int
    distance: float


def blows(observed: Observed, *, held: bool | None = False) -> list[int]:
    """Return the samples at which a quiet stay near zero torque ends in a blow.

    Parameters
    ----------
    observed : Observed
    held : bool or None
        In which stretches: those that fits may see (False), may not see (True), or all (None).
    """
    torque, noise, smooth = observed.torque, noise_of(observed), _smooth(observed)
    rise, quiet = (round(span * observed.rate) for span in (_BLOW, SHORTEST))
    if noise == 0 or torque.size <= rise:
        return []
    jump = np.zeros(torque.size)
    jump[:-rise] = np.abs(smooth[rise:] - smooth[:-rise])
    hard = max(_HARD * noise, _CODES * _code(observed))
    starts = np.flatnonzero((jump[1:] > hard) & (jump[:-1] <= hard)) + 1
    left = noise / np.sqrt(max(1, _SMOOTHED * observed.rate))
    within = max(min(_QUIET * left, _QUIET_AT_MOST), _NOISY * left)
    wanted = observed.mask(held=held)
    starts = starts[(starts > 2 * quiet) & wanted[starts]]
    before = np.lib.stride_tricks.sliding_window_view(smooth, quiet)[starts - quiet]
    still = np.ptp(before, axis=1) < within
    undriven = np.abs(np.median(before[still], axis=1)) < UNDRIVEN
    return [int(at) for at in starts[still][undriven]]


def flights_counted(observed: Observed, *, held: bool | None = False) -> int:
    """Return how many flights are seen, long ones counted twice: chance makes hardly any of these."""
    ended, smooth = blows(observed, held=held), _smooth(observed)
    long = round(_LONG * observed.rate)
    return len(ended) + sum(blow - _parted(smooth, blow, observed.rate) >= long for blow in ended)


def flights(observed: Observed, rig: Rig) -> list[Flight]:
    """Return the flights in the stretches that fits may see.

    Flanks part at the speed of the driving one. From then on only the sensor's torque T acts on the inertia J between
    gear and sensor, ``J d omega/dt = -T``; the motor's angle is known, so the difference of both is how far they moved
    (0 for flanks that meet again, the gap for opposite ones).
    """
    smooth, (inertia, turns) = _smooth(observed), _between_gear_and_sensor(rig, observed)
    slope, found = max(1, round(_SLOPE * observed.rate)), []
    for blow in blows(observed):
        level = _level(smooth, blow, observed.rate)
        met = np.flatnonzero(np.abs(smooth[blow:] - level) > _NEAR_LEVEL)
        start, stop = _parted(smooth, blow, observed.rate), blow + int(met[0]) if met.size else blow
        if start <= slope or stop - start < 2:
            continue
        driven = (observed.angle[start + slope] - observed.angle[start - slope]) * observed.rate / (2 * slope)
        speed = driven if observed.angle_measured else observed.speed[start]
        free = speed * turns - np.cumsum(observed.torque[start:stop]) / inertia / observed.rate
        moved = (observed.angle[stop] - observed.angle[start]) * turns - free.sum() / observed.rate
        found.append(Flight(start, stop, float(moved)))
    return found


def _level(smooth: Floats, blow: int, rate: float) -> float:
    """Return the torque at which a flight stays before its blow."""
    return float(np.median(smooth[blow - round(SHORTEST * rate) : blow]))


def _parted(smooth: Floats, blow: int, rate: float) -> int:
    """Return the sample from which the torque stays near the level of a flight, up to its blow."""
    left = np.flatnonzero(np.abs(smooth[:blow] - _level(smooth, blow, rate)) > _NEAR_LEVEL)
    return int(left[-1]) + 1 if left.size else 0


def noise_of(observed: Observed) -> float:
    """Return the noise of the samples; where most are equal to the one before (coarse codes), by a trimmed mean."""
    steps = np.abs(np.diff(observed.torque))
    middle = spread_about_zero(steps)
    if middle == 0:
        middle = float(np.sqrt(np.mean(steps[steps <= np.quantile(steps, _TRIMMED)] ** 2))) / _OF_TRIMMED
    return middle / float(np.sqrt(2))


def _code(observed: Observed) -> float:
    """Return the step of coarse codes [N m]: the smallest of a torque that mostly takes none; else 0."""
    steps = np.abs(np.diff(observed.torque))
    moving = steps[steps > 0]
    if not 0 < moving.size < 0.5 * steps.size:
        return 0.0
    rising = np.sort(moving)
    moved = np.cumsum(rising)
    return float(rising[np.searchsorted(moved, _SMALLEST * moved[-1])])


def _smooth(observed: Observed) -> Floats:
    width = max(1, int(_SMOOTHED * observed.rate))
    return np.asarray(np.convolve(observed.torque, np.full(width, 1 / width), "same"))


def _between_gear_and_sensor(rig: Rig, observed: Observed) -> tuple[float, float]:
    """Return the inertia [kg m^2] between the last gear before the sensor and the sensor, and its turns per motor's.

    Infinite where the model has none there: it then flies on at its speed.
    """
    twin = Twin(rig.at(observed.run))
    node = rig.node(gears_to_sensor(rig)[-1].name)
    behind = behind_sensor(twin)
    own = [
        term.inertia
        for term in twin.terms
        if isinstance(term, Inertia) and term.node not in behind and twin.turns.get(term.node) == twin.turns[node]
    ]
    return sum(own) or np.inf, twin.rig.speed_ratios(twin.drives[0].on)[node]
