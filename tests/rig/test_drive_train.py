"""The mean torque that a motor gives: each kind of load by hand, and as the simulator's own run comes to it."""

from __future__ import annotations

from math import exp

import pytest

from torquerig.mechanisms import (
    BladePass,
    GranularDrag,
    LugreFriction,
    QuadraticDrag,
    SixStepCommutation,
    StribeckFriction,
)
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.drive_train import drive_train
from torquerig.rig.parts import Body, Gear, Motor, MotorPhases, SpeedController, TorqueController
from torquerig.rig.steady import steady_torque, steady_torque_in
from torquerig.simulation.simulator import simulate

RATIO, EFFICIENCY, SPEED = 4.0, 0.9, 40.0
TURNING = SPEED / RATIO  # of the wear part
GRIP = 0.2 + 0.1 * exp(-((TURNING / 8.0) ** 2))  # part of Stribeck's peak is left at this speed

LOADS: dict[str, tuple[Part, float]] = {
    "stribeck": (StribeckFriction(name="it", coulomb=0.2, static=0.3, stribeck_speed=8.0), GRIP),
    "bristles": (
        LugreFriction(name="it", coulomb=0.2, static=0.3, stribeck_speed=8.0, stiffness=1000.0, damping=0.1), GRIP,
    ),
    "quadratic": (QuadraticDrag(name="it", coefficient=2e-3), 2e-3 * TURNING**2),
    "blades": (BladePass(name="it", order_output=6, amplitude=0.1), 0.025),
    "pump": (BladePass(name="it", order_output=6, amplitude=0.1, one_way=True), 0.025),
    "bed": (GranularDrag(name="it", mean_by_occupancy_percent={0.0: 0.5}), 0.5),
}  # fmt: skip


def rig(*effects: Part) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=RATIO, stiffness=1000.0, damping=1.0, efficiency=EFFICIENCY),
            Body(name="wear_part", after="gearbox", inertia=2e-3),
            SpeedController(name="loop", kp=0.05, ki=1.0),
            *effects,
        ),
        Run(speed=SPEED),
        measured="gearbox",
    )


@pytest.mark.parametrize("name", sorted(LOADS))
def test_steady_torque_by_hand_and_as_the_run_has_it(name: str) -> None:
    effect, at_wear_part = LOADS[name]
    asked = steady_torque(rig(effect), "motor")
    assert asked == pytest.approx(at_wear_part / (RATIO * EFFICIENCY), rel=1e-9)
    made = simulate(rig(effect), duration=2.0, seed=1, settling=2.0)
    assert made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(asked, rel=0.02)
    assert steady_torque_in(rig(effect), "gearbox", motor="motor") == pytest.approx(at_wear_part, rel=1e-9)


def test_a_motion_that_passes_through_rest_is_not_charged_with_the_peak_of_friction() -> None:
    train = drive_train(rig(LOADS["stribeck"][0]), "motor")
    assert train.torque(0.0, 0.0) == pytest.approx(0.2 / (RATIO * EFFICIENCY))
    assert train.steady_torque(0.0) == 0.0


def test_a_motor_in_torque_mode_with_lines_of_its_phases_does_not_ask_itself() -> None:
    phases = MotorPhases(
        name="phases", pole_pairs=7, phase_resistance=0.2, phase_inductance=0.3e-3, flux_linkage=0.01, dc_link=48.0,
        current_loop_bandwidth=1000.0,
    )  # fmt: skip
    drag = StribeckFriction(name="drag", coulomb=0.5, static=0.5, stribeck_speed=1.0)
    driven = rig(phases, SixStepCommutation(name="it"), drag).without("loop")
    driven += TorqueController(name="controller", torque=0.5 / (RATIO * EFFICIENCY))
    (drive,) = (term for term in driven.terms() if hasattr(term, "ripple"))
    assert max(wave.amplitude for wave in drive.ripple) > 0.01
