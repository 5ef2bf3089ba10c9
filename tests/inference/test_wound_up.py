"""The torque of a shaft that is held while springs wind up: closed forms and shorter steps."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.prediction.wound_up import share_held

TIME = np.linspace(0.0, 4.0, 4001)


@pytest.mark.parametrize("smoothing", [0.01, 0.3, 2.0])
def test_a_steady_speed_holds_the_smoothed_torque(smoothing):
    held = share_held(0.1 * TIME, 0.02, smoothing * 1e-3)
    assert held[-1] == pytest.approx(np.tanh(0.1 / smoothing), abs=1e-3)


@pytest.mark.parametrize("wound", [0.05, 0.4])
def test_after_a_reversal_the_torque_turns_over_twice_the_wind_up(wound):
    angle = 1.0 - np.abs(TIME - 2.0)  # turns back at 2 s with a speed of 1 rad/s
    held = share_held(angle, wound, 1e-9)
    assert held == pytest.approx(np.where(TIME < 2, 1.0, np.maximum(1 - (TIME - 2) / wound, -1.0)), abs=1e-3 / wound)


def test_steps_are_short_enough_for_a_soft_reversal():
    fine = np.linspace(0.0, 4.0, 80_001)
    held = share_held(-np.cos(TIME), 0.03, 0.05e-3)
    assert np.abs(held - share_held(-np.cos(fine), 0.03, 0.05e-3 / 20)[::20]).max() < 0.01
    # the springs carry what the slip leaves of the angle: half way the shaft turns on at the speed of the motor
    assert np.abs(held[TIME.size // 2]) == pytest.approx(np.tanh(np.sin(2.0) / 0.05), abs=1e-3)


def test_each_step_obeys_the_law_of_a_soft_element():
    wound, slip = 0.4, 0.02
    held = share_held(-np.cos(TIME), wound, slip)
    asked = held[:-1] + np.diff(-np.cos(TIME)) / wound
    followed = np.abs(held[1:]) < 0.999
    assert followed.sum() > 1000
    assert (held[1:] + slip / wound * np.arctanh(held[1:] * followed))[followed] == pytest.approx(
        asked[followed], abs=1e-4
    )
