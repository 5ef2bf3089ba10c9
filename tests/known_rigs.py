"""Fixtures of several folders: the wear rig, runs of it recorded at 5 kHz, and a bench with two torque sensors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RATE = 5000.0  # [Hz] a fifth of the real rig's, so that a run costs a fifth
DURATION = 6.0  # [s]
OFF = 1.004  # a real speed is off its set-point
FREE = ("wear_part.inertia", "coupling.stiffness", "wear_part.viscous", "motor.inertia", "torque_sensor.noise_rms")

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

Record = Callable[..., Recording]


@pytest.fixture(scope="session")
def wear_rig() -> Scenario:
    """The shipped scenario."""
    return read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=1)


@pytest.fixture(scope="session")
def known_rig(wear_rig: Scenario) -> Scenario:
    """The same with five uncertain numbers instead of forty: what each test of a whole diagnosis can afford."""
    rig = wear_rig.rig
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitude_rel_sd=0.0))
    return replace(wear_rig, rig=rig, uncertainties={name: wear_rig.uncertainties[name] for name in FREE})


@pytest.fixture(scope="session")
def record() -> Record:
    """One run as a laboratory would hand it over: what was measured, and the sheet with the set-point."""

    def recorded(
        rig: Rig, seed: int, *, rpm: float = 1000.0, occupancy: float = 5.0, profile: str = "steady",
        duration: float = DURATION, rate: float = RATE, encoder: bool = True,
    ) -> Recording:  # fmt: skip
        speed = rpm * pi / 30
        run = replace(rig.run, speed=speed * OFF, occupancy_percent=occupancy, profile=profile)  # type: ignore[arg-type]
        made = simulate(rig.at(run), duration=duration, seed=seed, sample_rate=rate, wander=2e-4).without_truth()
        channels = {name: one for name, one in made.channels.items() if encoder or one.quantity == "torque"}
        name = f"{rpm:g}rpm_{occupancy:g}percent_{profile}.parquet"
        return replace(made, name=name, channels=channels, run=replace(made.run, speed=speed))

    return recorded


@pytest.fixture(scope="session")
def bench() -> Callable[..., Rig]:
    """A pair of 20 and ``wheel`` teeth with a torque sensor ``before`` and one ``behind`` it, one of them measured."""

    def made(measured: str, *, wheel: int) -> Rig:
        document = parse_document(BENCH.format(measured=measured, wheel=wheel), Path("bench.yaml"))
        return read_scenario(document, load_catalog(shipped_folder()), seed=1).rig

    return made
