"""What a scenario must have before its recordings can be diagnosed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from torquerig.errors import InputError
from torquerig.inference.rig_under_test import check_rig
from torquerig.rig.parts import ImposedMotion
from torquerig.scenario.model import Scenario

MOTION = ImposedMotion(name="moved", at="motor", channel="motor_angle")


def test_a_rig_that_nothing_drives_is_said(wear_rig: Scenario) -> None:
    still = wear_rig.rig.without("speed_controller")
    with pytest.raises(InputError, match="nothing in the scenario drives a motor; add a speed_controller"):
        check_rig(still)
    with pytest.raises(InputError, match=r"imposes the motion 'moved' but measures 'torque_sensor'.*measured: moved"):
        check_rig(still + MOTION)


def test_a_measured_part_that_no_torque_passes_is_said(wear_rig: Scenario) -> None:
    with pytest.raises(InputError, match="measures 'wear_part', which transmits no torque"):
        check_rig(replace(wear_rig.rig, measured="wear_part"))


def test_a_rig_that_is_driven_may_have_a_motion_imposed_beside(wear_rig: Scenario) -> None:
    check_rig(wear_rig.rig)
    check_rig(wear_rig.rig + MOTION)
