"""Placebo test of a filter chain: the variance that the same notches remove at empty orders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.evaluation.known_angle import with_known_angle
from torquerig.filters.evaluation.order_shift import comb_lines, comb_teeth, empty_order_shifts, order_shifted
from torquerig.filters.evaluation.shifted_chain import shiftable_lines, shifted_chain, widest_half_width
from torquerig.orders.angle.tacho import recorded_motor_angle

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

SHIFTS = 20
_STEP, _FARTHEST = 0.05, 6.0  # [1/rev] step and largest value of the tried shifts
_LEAST_GAP = 0.2  # [1/rev] from a shifted line to any known one, or the chain's half band where that is wider
_LEAKAGE = 1.2  # [1] width of a band with its skirts, relative to its nominal width


@dataclass(frozen=True, kw_only=True)
class Placebo:
    """The variance that a chain removes at its lines, and when shifted to empty orders.

    Parameters
    ----------
    cut : float
        Removed at its lines, as a share of the variance before [1].
    shifts : tuple of float
        Shifts in orders of the output shaft [1/rev].
    cuts : tuple of float
        Removed at each shift, as shares of the variance before [1].
    """

    cut: float
    shifts: tuple[float, ...]
    cuts: tuple[float, ...]

    @property
    def median(self) -> float:
        """The median share removed by the shifted chains [1]."""
        return float(np.median(self.cuts))

    @property
    def beyond(self) -> float:
        """The share removed at the lines beyond this median [1]."""
        return self.cut - self.median

    @property
    def p_value(self) -> float:
        """The p-value of the rank test [1]: share of chains that remove as much; at least 1 / (shifts + 1)."""
        return (1 + sum(one >= self.cut for one in self.cuts)) / (1 + len(self.cuts))

    @property
    def std_cuts(self) -> tuple[float, ...]:
        """The reductions of the standard deviation by the shifted chains [1]."""
        return tuple(1 - float(np.sqrt(max(1 - one, 0.0))) for one in self.cuts)


def placebo(
    chain: Chain, recording: Recording, *, known: Sequence[KinematicLine] = (), most: int = SHIFTS
) -> Placebo | None:
    """Return the variance that ``chain`` removes at its lines and at up to ``most`` shifts; None where it has no lines.

    Parameters
    ----------
    chain : Chain
        All its lines are shifted equally, so that number, width and spacing of the bands do not change.
    recording : Recording
        With a set-point speed.
    known : sequence of KinematicLine
        All lines of the drive, including those that the chain does not remove; shifted lines must not meet them.
    most : int
        Largest number of shifts; the smallest possible ones in either direction.

    Notes
    -----
    Shifted chains overlap where shifts differ by less than a band, so that the shifts are not independent samples.
    Below ten orders the load's spectrum may differ between a line and its shifted place. Source: handbook,
    signatures 8.8 (a placebo notch at an empty neighbouring order) and report audit A, "std as merit".
    """
    if comb_teeth(chain):
        return _of_combs(chain, recording, known=known, most=most)
    lines = shiftable_lines(chain)
    shifts = empty_shifts(chain, known=known or lines, speed=recording.run.speed or 0.0)[:most] if lines else ()
    if not shifts:
        return None
    given = with_known_angle(recording, lines)
    whole = float(given.torque().var())
    if not whole > 0:
        return None
    remaining = [
        float(one.apply(given).torque().var()) for one in (chain, *(shifted_chain(chain, by) for by in shifts))
    ]
    cut, *cuts = (1 - one / whole for one in remaining)
    return Placebo(cut=cut, shifts=shifts, cuts=tuple(cuts))


def _of_combs(chain: Chain, recording: Recording, *, known: Sequence[KinematicLine], most: int) -> Placebo | None:
    """Return the placebo test of a chain with a tooth at every harmonic: the torque is shifted instead of the chain.

    All teeth and single lines are then shifted by the same number of orders.
    """
    lines = (*shiftable_lines(chain), *comb_lines(chain)) or tuple(known)
    turns = empty_order_shifts(chain, known=known or lines)
    given = with_known_angle(recording, lines)
    ratio = lines[0].output_order / lines[0].motor_order if lines else recording.run.gear_ratio or 1.0
    angle = recorded_motor_angle(given, ratio=ratio)
    whole = float(given.torque().var())
    if not turns or angle is None or not whole > 0:
        return None
    # as many as required, evenly over all possible shifts
    chosen = [turns[at] for at in np.unique(np.linspace(0, len(turns) - 1, most).round().astype(int))]
    moved = (order_shifted(given, by, angle=angle.values, ratio=ratio) for by in chosen)
    cuts = tuple(1 - float(chain.apply(one).torque().var()) / float(one.torque().var()) for one in moved)
    cut = 1 - float(chain.apply(given).torque().var()) / whole
    return Placebo(cut=cut, shifts=tuple(chosen), cuts=cuts)


def empty_shifts(chain: Chain, *, known: Sequence[KinematicLine], speed: float) -> tuple[float, ...]:
    """Return the shifts [orders of the output shaft] at which no line of the chain meets a known one, smallest first.

    A shifted band is at least 0.2 orders, or 1.2 times its half width, from every known line.

    Parameters
    ----------
    speed : float
        Of the motor [rad/s]; converts a half width in Hz to orders.
    """
    lines = shiftable_lines(chain)
    hertz, orders = widest_half_width(chain)
    ratio = lines[0].output_order / lines[0].motor_order if lines else 1.0
    if hertz and speed:
        orders = max(orders, hertz * ratio * 2 * pi / abs(speed))
    gap = max(_LEAST_GAP, _LEAKAGE * orders)
    places = np.unique([line.output_order for line in (*known, *lines)])
    moved = np.array([line.output_order for line in lines])
    # whole steps, to avoid 0.30000000000000004
    steps = np.arange(1, round(_FARTHEST / _STEP) + 1)
    signed = [float(sign * step) / round(1 / _STEP) for step in steps for sign in (1, -1)]
    return tuple(by for by in signed if _clear(moved + by, places, gap))


def _clear(moved: np.ndarray, places: np.ndarray, gap: float) -> bool:
    # a line shifted below 0 would be mirrored
    distance = np.abs(moved[:, None] - places[None, :]).min(initial=np.inf)
    return bool(moved.min(initial=np.inf) > gap and distance >= gap - 1e-9)
