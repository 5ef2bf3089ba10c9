"""What the same chain cuts at empty orders beside its own: a reduction that any so many notches would give."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.evaluation.known_angle import with_known_angle
from torquerig.filters.evaluation.moved_chain import movable_lines, moved_chain, widest_half_width
from torquerig.filters.evaluation.turned import comb_lines, comb_teeth, empty_turns, turned_on
from torquerig.orders.angle.measured_angle import measured_motor_angle

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

SHIFTS = 20
_STEP, _FARTHEST = 0.05, 6.0  # [1/rev] shifts are tried in these steps up to so far
_LEAST_GAP = 0.2  # [1/rev] from a moved line to any known one, or the chain's own half band where that is wider
_LEAKAGE = 1.2  # a band's skirts reach so much farther than its edge


@dataclass(frozen=True, kw_only=True)
class Placebo:
    """The variance that a chain cuts, and what it cuts when moved to empty orders.

    Parameters
    ----------
    cut : float
        By the chain where it belongs, as a share of the variance before [1].
    shifts : tuple of float
        By how many orders of the output shaft it was moved [1/rev].
    cuts : tuple of float
        What it cut there, as shares of the variance before [1].
    """

    cut: float
    shifts: tuple[float, ...]
    cuts: tuple[float, ...]

    @property
    def median(self) -> float:
        """What a chain of this shape cuts of anything [1]: the median of the moved ones."""
        return float(np.median(self.cuts))

    @property
    def beyond(self) -> float:
        """What the chain cuts beyond that [1]: the share of the variance that stands out at its own lines."""
        return self.cut - self.median

    @property
    def p_value(self) -> float:
        """How often a moved chain cuts as much [1]: rank of the chain among all; never under 1 / (shifts + 1)."""
        return (1 + sum(one >= self.cut for one in self.cuts)) / (1 + len(self.cuts))

    @property
    def std_cuts(self) -> tuple[float, ...]:
        """The cuts of the moved chains counted in standard deviation [1]."""
        return tuple(1 - float(np.sqrt(max(1 - one, 0.0))) for one in self.cuts)


def placebo(
    chain: Chain, recording: Recording, *, known: Sequence[KinematicLine] = (), most: int = SHIFTS
) -> Placebo | None:
    """Return what ``chain`` cuts at its lines and, moved, at up to ``most`` places beside; None where it cannot move.

    Parameters
    ----------
    chain : Chain
        Whose lines are moved all by the same shift, so that number, width and spacing of the bands stay.
    recording : Recording
        With a set-point speed.
    known : sequence of KinematicLine
        All lines of the drive, also those that the chain leaves alone: the places beside must be empty of them.
    most : int
        How many shifts; the nearest free ones either way.

    Notes
    -----
    Moved chains overlap where shifts differ by less than a band, so that the shifts are no independent draws; and
    below ten orders the load's own spectrum may slope from the line to the place beside it. Source: handbook,
    signatures 8.8 (a placebo notch at an empty neighbouring order) and report audit A, "std as merit".
    """
    if comb_teeth(chain):
        return _of_combs(chain, recording, known=known, most=most)
    lines = movable_lines(chain)
    shifts = empty_shifts(chain, known=known or lines, speed=recording.run.speed or 0.0)[:most] if lines else ()
    if not shifts:
        return None
    given = with_known_angle(recording, lines)
    whole = float(given.torque().var())
    if not whole > 0:
        return None
    left = [float(one.apply(given).torque().var()) for one in (chain, *(moved_chain(chain, by) for by in shifts))]
    cut, *cuts = (1 - one / whole for one in left)
    return Placebo(cut=cut, shifts=shifts, cuts=tuple(cuts))


def _of_combs(chain: Chain, recording: Recording, *, known: Sequence[KinematicLine], most: int) -> Placebo | None:
    """Return the placebo of a chain with a tooth at every harmonic: the torque is turned on instead of the chain.

    So all of its teeth, and any single lines, stand the same number of orders beside.
    """
    lines = (*movable_lines(chain), *comb_lines(chain)) or tuple(known)
    turns = empty_turns(chain, known=known or lines)
    given = with_known_angle(recording, lines)
    ratio = lines[0].output_order / lines[0].motor_order if lines else recording.run.gear_ratio or 1.0
    angle = measured_motor_angle(given, ratio=ratio)
    whole = float(given.torque().var())
    if not turns or angle is None or not whole > 0:
        return None
    # as many as asked for, spread over all there are
    chosen = [turns[at] for at in np.unique(np.linspace(0, len(turns) - 1, most).round().astype(int))]
    moved = (turned_on(given, by, angle=angle.values, ratio=ratio) for by in chosen)
    cuts = tuple(1 - float(chain.apply(one).torque().var()) / float(one.torque().var()) for one in moved)
    cut = 1 - float(chain.apply(given).torque().var()) / whole
    return Placebo(cut=cut, shifts=tuple(chosen), cuts=cuts)


def empty_shifts(chain: Chain, *, known: Sequence[KinematicLine], speed: float) -> tuple[float, ...]:
    """Return the shifts [orders of the output shaft] at which no line of the chain meets a known one, nearest first.

    A moved band keeps clear of every known line by 0.2 orders, or by 1.2 times its half width where that is more.

    Parameters
    ----------
    speed : float
        Of the motor [rad/s]; turns a half width in Hz into orders, and is not needed for one in orders.
    """
    own = movable_lines(chain)
    hertz, orders = widest_half_width(chain)
    ratio = own[0].output_order / own[0].motor_order if own else 1.0
    if hertz and speed:
        orders = max(orders, hertz * ratio * 2 * pi / abs(speed))
    gap = max(_LEAST_GAP, _LEAKAGE * orders)
    places = np.unique([line.output_order for line in (*known, *own)])
    moved = np.array([line.output_order for line in own])
    # in whole steps, so that 0.3 is 0.3 and not 0.30000000000000004
    steps = np.arange(1, round(_FARTHEST / _STEP) + 1)
    signed = [float(sign * step) / round(1 / _STEP) for step in steps for sign in (1, -1)]
    return tuple(by for by in signed if _clear(moved + by, places, gap))


def _clear(moved: np.ndarray, places: np.ndarray, gap: float) -> bool:
    # what is moved below 0 would come back from the other side
    apart = np.abs(moved[:, None] - places[None, :]).min(initial=np.inf)
    return bool(moved.min(initial=np.inf) > gap and apart >= gap - 1e-9)
