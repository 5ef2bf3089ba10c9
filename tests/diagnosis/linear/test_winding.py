"""Dry loads near standstill: the element in closed form, the shafts' stiffness, and the simulator's own reversals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.linear.kernel import elastic_plastic
from torquerig.diagnosis.linear.winding import compliance, wound_torque
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.parts import Coupling, Gear, TorqueSensor
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate


def test_an_element_turned_to_and_fro_draws_its_parallelogram() -> None:
    """With k = 2, limits 1 and 0.6: up to 1, back by 1.6 over a twist of 0.8, held at -0.6, and up again."""
    angle = np.concatenate([np.linspace(0, 2, 201), np.linspace(2, 0, 201)[1:], np.linspace(0, 2, 201)[1:]])
    twist = np.diff(angle, prepend=0.0)
    ones = np.ones(angle.size)
    torque = elastic_plastic(twist, 2.0, 1.0 * ones, 0.6 * ones, 0.0)
    up, down, again = torque[:201], torque[200:401], torque[400:]
    assert up == pytest.approx(np.minimum(2 * angle[:201], 1.0), abs=1e-12)
    assert down == pytest.approx(np.maximum(1.0 - 2 * (2 - angle[200:401]), -0.6), abs=1e-12)
    assert again == pytest.approx(np.minimum(-0.6 + 2 * angle[400:], 1.0), abs=1e-12)


def test_a_node_gives_way_by_the_springs_between_it_and_the_motor(wear_rig: Scenario) -> None:
    """Springs in a row: 1 / k adds up, all of the wear rig's being stated behind its gear."""
    loaded = wear_rig.rig.node("wear_part")
    springs = [wear_rig.rig.part(name) for name in ("gearbox", "torque_sensor", "coupling")]
    stiffness = [part.stiffness for part in springs if isinstance(part, Gear | TorqueSensor | Coupling)]
    assert compliance(Twin(wear_rig.rig), loaded) == pytest.approx(sum(1 / each for each in stiffness), rel=1e-12)
    assert compliance(Twin(wear_rig.rig), wear_rig.rig.node("motor")) == 0.0


@pytest.mark.parametrize("static", [0.3, 0.6])
def test_a_simulated_reversal_reads_as_it_is_wound(static: float, wear_rig: Scenario) -> None:
    """Rms within 0.08 N m of the simulator, whose contact creeps by a tanh, and near standstill nearer than unwound."""
    rig = wear_rig.rig + StribeckFriction(name="friction", coulomb=0.3, static=static, stribeck_speed=1.0)
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitudes={}))
    rig = rig.at(Run(**{**vars(rig.run), "speed": 10 * np.pi, "occupancy_percent": 0.0, "profile": "reversal"}))
    made = simulate(rig, duration=8.0, seed=3, sample_rate=5000.0)
    angle = made.channels["true_motor_angle_rad"].values
    rate, step = made.sample_rate, 0.005
    size = int(rate * step)
    speed = np.gradient(angle, 1 / rate)[: angle.size // size * size].reshape(-1, size).mean(axis=1)
    torque = made.torque()[: speed.size * size].reshape(-1, size).mean(axis=1)
    found = wound_torque(
        Twin(rig), speed=speed, acceleration=np.gradient(speed, step), step=step, start=float(torque[0])
    )
    assert np.sqrt(np.mean((found.torque - torque) ** 2)) < 0.08
    slow = np.abs(speed) < 1.0
    rigid = np.sign(speed) * np.abs(found.torque)
    assert np.sqrt(np.mean((found.torque - torque)[slow] ** 2)) < 0.75 * np.sqrt(np.mean((rigid - torque)[slow] ** 2))
