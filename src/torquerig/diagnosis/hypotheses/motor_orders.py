"""The orders at which a motor's slots and poles allow cogging."""

from __future__ import annotations

from math import lcm

from torquerig.rig.parts import Motor

STRONG = 100.0  # power over the floor of a line whose harmonics may be smeared until none stands out as a line
BY_SKIRTS = 20.0  # what an effect must gain beside whose line nobody sees: other things leave noise at its order too
_MULTIPLES = 6  # of slots or poles that are looked at, and all of them up to ...
_NATIVE = 3  # ... so many times the native order


def native_order(motor: Motor) -> int:
    """Return the order of cogging that magnets and teeth all alike make: lcm(slots, poles); 0 where not stated."""
    return lcm(motor.slots or 0, 2 * (motor.pole_pairs or 0))


def cogging_orders(motor: Motor) -> tuple[int, ...]:
    """Return the native order, slots and poles, then the multiples of either, rising; none where not stated."""
    native = native_order(motor)
    if not native or motor.slots is None or motor.pole_pairs is None:
        return ()
    counts = (motor.slots, 2 * motor.pole_pairs)
    multiples = {at for n in counts for at in range(n, max(_MULTIPLES * n, _NATIVE * native) + 1, n)}
    return tuple(dict.fromkeys((native, *counts, *sorted(multiples))))
