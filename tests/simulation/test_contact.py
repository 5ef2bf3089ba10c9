"""How flanks touch, beside the contact law as it is written, and where within a step that changes."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.simulation.kernel.contact import beyond, overshoot, touch

HALF, STIFFNESS, DAMPING = 2e-3, 700.0, 0.5
STATES = [(twist, rate) for twist in np.linspace(-4e-3, 4e-3, 17) for rate in np.linspace(-5.0, 5.0, 21)]


def test_flanks_never_pull_and_damping_is_at_most_the_springs_torque() -> None:
    for twist, rate in STATES:
        side = np.sign(twist)
        pressed = STIFFNESS * max(abs(twist) - HALF, 0.0)
        damped = float(np.clip(side * DAMPING * rate, -pressed, pressed))
        torque, _ = touch(twist, rate, HALF, STIFFNESS, DAMPING)
        assert torque == pytest.approx(side * (pressed + damped), abs=1e-12)


def test_two_torques_tell_whether_flanks_still_touch_as_they_did() -> None:
    """Of flanks apart both must be above zero for a contact, of others one for its end: as ``touch`` itself says."""
    for before_at in STATES:
        _, before = touch(*before_at, HALF, STIFFNESS, DAMPING)
        for twist, rate in STATES:
            _, now = touch(twist, rate, HALF, STIFFNESS, DAMPING)
            if now * before < 0:  # from one flank to the other within a step: no straight line tells when
                continue
            first, second = beyond(before, twist, rate, HALF, STIFFNESS, DAMPING)
            changed = (first > 0 and second > 0) if before == 0 else (first > 0 or second > 0)
            at_the_edge = min(abs(first), abs(second)) < 1e-12
            assert changed == (now != before) or at_the_edge, (before, now, first, second)


@pytest.mark.parametrize(
    ("touching", "low", "high", "share"),
    [
        (0.0, (-1.0, -2.0), (3.0, 2.0), 0.5),  # apart: until the later of both, at three quarters and at a half
        (2.0, (-1.0, -2.0), (3.0, 2.0), 0.75),  # touching: from the earlier on
        (2.0, (-1.0, -2.0), (-0.5, 6.0), 0.75),
        (2.0, (1.0, -2.0), (0.0, -1.0), 0.5),  # neither tells: the middle
    ],
)
def test_straight_torques_tell_exactly_what_lies_behind_the_change(
    touching: float, low: tuple[float, float], high: tuple[float, float], share: float
) -> None:
    assert overshoot(touching, *low, *high) == pytest.approx(share)


@pytest.mark.parametrize("touching", [0.0, 1.0, 2.0])
@pytest.mark.parametrize("torque", [0.0, 0.7, -0.7])
def test_torques_that_are_alike_at_both_ends_tell_no_moment(touching: float, torque: float) -> None:
    """A damped spring at rest between its flanks: nothing to divide by."""
    assert overshoot(touching, torque, torque, torque, torque) == 0.5
