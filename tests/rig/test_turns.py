"""How fast shafts turn against the motor: through gears, reversed, and where no shaft leads."""

from __future__ import annotations

import pytest

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.rig.turns import turns_per_motor_turn


def chain(ratio: float) -> Rig:
    return Rig(
        (
            Body(name="flywheel", inertia=1.0),  # a shaft of its own, before the motor
            Motor(name="motor", inertia=1e-4, torque_limit=1.0),
            Gear(name="gearbox", after="motor", ratio=ratio, stiffness=1e4, damping=1.0, output_inertia=1e-3),
            Coupling(name="coupling", after="gearbox", stiffness=1e3, damping=0.1),
            Body(name="drum", after="coupling", inertia=1e-3),
            SpeedController(name="controller", kp=0.05, ki=0.0),
        ),
        measured="coupling",
    )


@pytest.mark.parametrize("ratio", [5.0, 2.5, -4.0])
def test_a_shaft_behind_a_gear_turns_by_its_ratio(ratio: float) -> None:
    rig = chain(ratio)
    assert turns_per_motor_turn(rig, "motor") == 1.0
    assert turns_per_motor_turn(rig, "drum") == pytest.approx(1 / ratio)


def test_without_a_drive_the_first_shaft_counts() -> None:
    rig = chain(5.0).without("controller").without("flywheel")
    assert turns_per_motor_turn(rig, "drum") == pytest.approx(0.2)


def test_a_part_that_no_shaft_leads_to_is_refused() -> None:
    with pytest.raises(InputError, match="no shaft leads from 'motor' to 'flywheel'"):
        turns_per_motor_turn(chain(5.0), "flywheel")


def test_a_rig_without_inertia_is_refused() -> None:
    with pytest.raises(InputError, match="no inertia"):
        turns_per_motor_turn(Rig(()), "drum")
