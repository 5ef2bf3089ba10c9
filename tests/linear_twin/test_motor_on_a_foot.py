"""A motor whose housing a sensor holds: the linear model of the diagnosis and that of the simulation agree."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.inference.rig_under_test import check_rig
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Motor, ReactionTorqueSensor, SpeedController
from torquerig.simulation.twin.linear_twin import twin_of


def bench(measured: str) -> Rig:
    """A soft foot (130 Hz) and a stiff loop, so that the housing, the encoder in it and the shaft all take part."""
    return Rig(
        (
            Motor(name="motor", inertia=2e-4, viscous=2e-3, torque_limit=5.0),
            ReactionTorqueSensor(name="foot", stiffness=2e3, damping=0.5, housing_inertia=3e-3, bandwidth=2000.0),
            Coupling(name="bar", after="motor", stiffness=600.0, damping=0.05, inertia=1e-4),
            Body(name="wheel", after="bar", inertia=2e-3, viscous=0.01),
            SpeedController(name="loop", kp=0.1, ki=1.0),
            TorqueRipple(name="cogging", at="motor", group="cogging", amplitudes={12.0: 0.01}),
        ),
        Run(speed=40.0), measured=measured,
    )  # fmt: skip


@pytest.mark.parametrize("measured", ["bar", "foot"])
def test_a_torque_between_rotor_and_housing_passes_as_in_the_simulation_s_twin(measured: str) -> None:
    frequencies = np.array([2.0, 30.0, 100.0, 129.0, 180.0, 400.0])
    system, output = twin_of(bench(measured)).closed_loop, f"torque in {measured}"
    ends = [system.transfer(f"torque on {node}", output, frequencies) for node in ("motor", "foot")]
    twin = Twin(bench(measured))
    found = twin.shafts.at(twin.torque_on("motor", "foot").response, frequencies)
    assert (
        np.abs(found - (ends[0] - ends[1])).max() < 1e-2 * np.abs(ends[0] - ends[1]).max()
    )  # between the grid's points
    (line,) = twin.lines()
    assert line.owner == "cogging"


def test_a_foot_is_not_compared_and_the_shaft_s_sensor_is() -> None:
    check_rig(bench("bar"))
    with pytest.raises(InputError, match="name the torque_sensor, coupling or gear to compare first under measured:"):
        check_rig(bench("foot"))
