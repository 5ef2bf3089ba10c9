"""Contact in a gap: its state, and the moment within a step at which it changes.

Flanks that touch pull nothing: a damper that would pull is let go, and one that would push harder than the spring is
held to the spring's own torque. How they touch is 0 where they are apart or let go, the side where the damper is held,
twice the side between. From one to another the torque goes without a jump, with a kink.
"""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import where
from torquerig.simulation.kernel.fast import FAST


@njit(fastmath=FAST, inline="always")
def touch(twist, rate, half, stiffness, damping):
    """Return the torque of a spring with a gap of ``half`` to either side, and how its flanks touch."""
    side = where(twist > 0.0, 1.0, -1.0)
    pressed = stiffness * (side * twist - half)
    damped = side * damping * rate
    held, bearing = damped > pressed, (pressed > 0.0) & (damped > -pressed)
    torque = where(bearing, side * where(held, 2.0 * pressed, pressed + damped), 0.0)
    return torque, where(bearing, where(held, side, 2.0 * side), 0.0)


@njit(fastmath=FAST, inline="always")
def beyond(touching, twist, rate, half, stiffness, damping):
    """Return two torques: flanks touch as they did until one of them is above zero; flanks apart, until both are."""
    apart, held = touching == 0.0, abs(touching) == 1.0
    side = where(where(apart, twist, touching) > 0.0, 1.0, -1.0)
    pressed = stiffness * (side * twist - half)
    damped = side * damping * rate
    first = where(apart, pressed, where(held, pressed - damped, damped - pressed))
    second = where(apart, pressed + damped, where(held, -pressed, -pressed - damped))
    return first, second


@njit(fastmath=FAST, inline="always")
def overshoot(touching, first_low, second_low, first_high, second_high):
    """Return the share of an interval that lies behind the change within it: both torques taken as straight there."""
    first = _behind(first_low, first_high)
    second = _behind(second_low, second_high)
    earlier, later = where(first > second, first, second), where(first > second, second, first)
    share = where(touching == 0.0, later, earlier)
    return where((share > 0.0) & (share < 1.0), share, 0.5)


@njit(fastmath=FAST, inline="always")
def _behind(low, high):
    """Return the share of an interval in which a torque is above zero; nothing where it is not at the end."""
    crosses = (high > 0.0) & (low < 0.0)
    share = high / where(crosses, high - low, 1.0)  # both ends may be alike
    return where(crosses, share, where(high > 0.0, 1.0, 0.0))


@njit(fastmath=FAST, inline="always")
def narrow(springs, stiffness, damping, work, kinked, searching, behind_twice, before_twice):
    """Return the share of the narrowed interval that lies behind the first change of a contact.

    The interval in which it lies ends now where a step ``kinked``, else it begins there. Of an end that stays for the
    second time the torques are halved, so that the other end does not creep (the Illinois rule: Dowell and Jarratt
    1971, BIT 11).
    """
    share, gaps = 0.0, work.gaps
    first_low, second_low, first_high, second_high = work.first_low, work.second_low, work.first_high, work.second_high
    for g in range(gaps.size):
        gap = gaps[g]
        before, half, k, c = work.contact_before[gap], springs.half_gap[gap], stiffness[gap], damping[gap]
        first, second = beyond(before, work.twisted[gap], work.twisting[gap], half, k, c)
        first_start, second_start = beyond(before, work.twisted_before[gap], work.twisting_before[gap], half, k, c)
        stays = where(kinked, where(behind_twice, 0.5, 1.0), 1.0)
        first_low[gap] = where(kinked, where(searching, stays * first_low[gap], first_start), first)
        second_low[gap] = where(kinked, where(searching, stays * second_low[gap], second_start), second)
        changed = work.contact[gap] != before
        stays = where(before_twice, 0.5, 1.0)
        # zero stands for a contact that does not change within the interval
        first_high[gap] = where(kinked, where(changed, first, 0.0), stays * first_high[gap])
        second_high[gap] = where(kinked, where(changed, second, 0.0), stays * second_high[gap])
        there = (first_high[gap] != 0.0) | (second_high[gap] != 0.0)
        own = overshoot(before, first_low[gap], second_low[gap], first_high[gap], second_high[gap])
        share = where(there & (own > share), own, share)
    return where(share > 0.0, share, 0.5)
