"""What a sensor reads of a slow torque, wherever it sits: through gears behind it, and turned the other way round."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.linear_twin.quasi_static import quasi_static, shares_at_sensor
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.simulation.simulator import simulate

SPEED = 40.0  # [rad/s] of the motor


@pytest.mark.parametrize("measured", ["before", "behind"])
@pytest.mark.parametrize("wheel", [60, 10])
def test_the_slow_torque_is_that_of_the_simulator(measured: str, wheel: int, bench: Callable[..., Rig]) -> None:
    """A pair of wheels turns the other way, so that what drives reads as negative behind it and as positive before."""
    rig = bench(measured, wheel=wheel)
    read = float(simulate(rig, duration=2.0, seed=1, sample_rate=2000.0).torque().mean())
    stands = quasi_static(Twin(rig), speed=np.array([SPEED]), acceleration=np.zeros(1))
    assert stands.sensor[0] == pytest.approx(read, rel=2e-3)
    assert np.sign(read) == (1.0 if measured == "before" else -1.0)


def test_a_torque_behind_a_gear_reaches_the_sensor_by_its_lever(bench: Callable[..., Rig]) -> None:
    """Of 60:20 teeth a third of it, over the efficiency; all of it where no gear stands between."""
    for measured, share in (("before", 1 / 3 / 0.9), ("behind", -1.0)):
        rig = bench(measured, wheel=60)
        assert shares_at_sensor(Twin(rig))[rig.node("drum")] == pytest.approx(share)
