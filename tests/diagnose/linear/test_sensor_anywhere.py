"""What a sensor reads of a slow torque, wherever it sits: through gears behind it, and turned the other way round."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.diagnose.linear.quasi_static import quasi_static, shares_at_sensor
from torquerig.diagnose.linear.twin import Twin
from torquerig.document import parse_document
from torquerig.rig.rig import Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulate.simulate import simulate

SPEED = 40.0  # [rad/s] of the motor
BENCH = """
scenario: bench
operating_point: {{motor_speed: 40 rad/s, load: {{occupancy: 5 %, particle_size: 0.5 mm}}}}
measured: {measured}
rig:
  motor: {{kind: motor, inertia: 4.0e-4 kg*m^2, viscous: 2.0e-4 N*m*s/rad, torque_limit: 30 N*m}}
  before: {{kind: torque_sensor, stiffness: 12000 N*m/rad, damping: 0.5 N*m*s/rad, inertia: 3 kg*cm^2,
           bandwidth: 500 Hz, noise_rms: 0.001 V}}
  gears: {{kind: fixed_axis_gear, teeth: {{pinion: 20, wheel: {wheel}}}, stiffness: 9000 N*m/rad, damping: 3 N*m*s/rad,
          efficiency: 0.9, output_inertia: 6 kg*cm^2}}
  behind: {{kind: torque_sensor, stiffness: 12000 N*m/rad, damping: 0.5 N*m*s/rad, inertia: 3 kg*cm^2,
           bandwidth: 500 Hz, noise_rms: 0.001 V}}
  drum: {{kind: body, inertia: 0.01 kg*m^2, viscous: 0.02 N*m*s/rad}}
  fan: {{kind: quadratic_drag, at: drum, coefficient: 1.0e-4 N*m*s^2/rad^2}}
  speed_controller: {{kind: speed_controller, motor: motor, kp: 0.2 N*m*s/rad, ki: 2 N*m/rad}}
"""


def bench(measured: str, wheel: int) -> Rig:
    text = BENCH.format(measured=measured, wheel=wheel)
    document = parse_document(text, Path("bench.yaml"))
    return read_scenario(document, load_catalog(shipped_folder()), seed=1).rig


@pytest.mark.parametrize("measured", ["before", "behind"])
@pytest.mark.parametrize("wheel", [60, 10])
def test_the_slow_torque_is_that_of_the_simulator(measured: str, wheel: int) -> None:
    """A pair of wheels turns the other way, so that what drives reads as negative behind it and as positive before."""
    rig = bench(measured, wheel)
    read = float(simulate(rig, duration=2.0, seed=1, sample_rate=2000.0).torque().mean())
    stands = quasi_static(Twin(rig), speed=np.array([SPEED]), acceleration=np.zeros(1))
    assert stands.sensor[0] == pytest.approx(read, rel=2e-3)
    assert np.sign(read) == (1.0 if measured == "before" else -1.0)


def test_a_torque_behind_a_gear_reaches_the_sensor_by_its_lever() -> None:
    """Of 60:20 teeth a third of it, over the efficiency; all of it where no gear stands between."""
    shares = shares_at_sensor(Twin(bench("before", 60)))
    assert shares[bench("before", 60).node("drum")] == pytest.approx(1 / 3 / 0.9)
    assert shares_at_sensor(Twin(bench("behind", 60)))[bench("behind", 60).node("drum")] == pytest.approx(-1.0)
