"""An induction motor in a rig: its speed under load is what the slip says, and the phase-level machine's."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.machines.induction_run import InductionSupply, run_induction
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, InductionDrive, Motor
from torquerig.rig.terms import Load, Term
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RPM = pi / 30
DRIVE = InductionDrive(
    name="drive", pole_pairs=2, rated_torque=2.2, rated_speed=1385 * RPM, breakdown_torque=2.4 * 2.2
)  # a 71M of four poles, as motors.md 4 has it
CATALOG = load_catalog(shipped_folder())


@dataclass(frozen=True)
class Stepped:
    """One torque, and from ``moment`` [s] of the sampled time on another one."""

    mean: float
    later: float
    moment: float

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.where(np.arange(count) < self.moment * rate, self.mean, self.later)


@dataclass(frozen=True, kw_only=True)
class Brake(Part):
    """A torque against the body that may change once."""

    torque: float
    later: float | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        later = self.torque if self.later is None else self.later
        return (Load(name=self.name, on=rig.node("body"), process=Stepped(self.torque, later, 1.5)),)


def rig(torque: float, later: float | None = None, *, field: float = 1500 * RPM) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1e-3, torque_limit=10.0),
            Coupling(name="shaft", after="motor", stiffness=700.0, damping=0.05),
            Body(name="body", after="shaft", inertia=1e-3),
            Brake(name="brake", torque=torque, later=later),
            DRIVE,
        ),
        Run(speed=field),
        measured="shaft",
    )


def settled(made: object) -> float:
    return float(made.channels["true_motor_speed_rad_s"].values[-2500:].mean())  # type: ignore[attr-defined]


@pytest.mark.parametrize("load", [0.0, 0.5, 2.2, 4.5])
def test_the_speed_under_load_is_kloss_s(load: float) -> None:
    """Closed form: the stable root of T = 2 Tb / (s/sb + sb/s); 1385 rpm at the rating."""
    assert settled(simulate(rig(load), duration=0.5, seed=1)) == pytest.approx(DRIVE.machine().speed(load), rel=1e-7)
    assert DRIVE.machine().speed(2.2) == pytest.approx(1385 * RPM)


@pytest.mark.parametrize("load", [1.0, 2.2])
def test_the_speed_under_load_is_the_phase_level_machine_s(load: float) -> None:
    """Fluxes without stator resistance settle on the same speed within 1e-5."""
    run = run_induction(
        DRIVE.machine(), InductionSupply(), inertia=2e-3, load_torque=load, duration=0.6,
        initial_speed=DRIVE.machine().speed(load), step=5e-4,
    )  # fmt: skip
    assert settled(simulate(rig(load), duration=0.5, seed=1)) == pytest.approx(run.speed[-40:].mean(), rel=1e-5)


def test_a_load_pulls_the_speed_down_as_the_fluxes_do() -> None:
    """From synchronous speed and no torque into 2.2 N m: at every millisecond within 5 % of the drop.

    The fluxes answer in second order (they ring a little at the slip's own pace), the slip's lag in first order.
    """
    machine = DRIVE.machine()
    made = simulate(rig(2.2), duration=0.1, seed=1, settling=0.0)
    run = run_induction(
        machine, InductionSupply(), inertia=2e-3, load_torque=2.2, duration=0.1,
        initial_speed=machine.synchronous_speed, step=1e-4,
    )  # fmt: skip
    drop = machine.synchronous_speed - machine.speed(2.2)
    shafts = made.channels["true_motor_speed_rad_s"].values + made.channels["true_output_speed_rad_s"].values
    for millisecond in range(1, 100):
        assert abs(0.5 * shafts[25 * millisecond] - run.speed[10 * millisecond]) < 0.05 * drop, millisecond
    assert shafts.min() / 2 < machine.speed(2.2) - 0.02 * drop  # it swings below, as a lag and an inertia do


def test_above_breakdown_it_stalls() -> None:
    made = simulate(rig(2.0, 6.0), duration=0.6, seed=1)
    speed = made.channels["true_motor_speed_rad_s"].values
    assert speed[0] > 0.9 * 1500 * RPM
    assert speed[-1] < 0.5 * speed[0]


def test_an_inverter_moves_the_field_and_keeps_the_slip_speed() -> None:
    """Voltage over frequency: the same torque costs the same slip in rad/s at half the field's speed."""
    slips = [
        field - settled(simulate(rig(2.2, field=field), duration=0.5, seed=1)) for field in (1500 * RPM, 750 * RPM)
    ]
    assert slips[0] == pytest.approx(115 * RPM, rel=1e-6)
    assert slips[1] == pytest.approx(slips[0], rel=1e-6)


RIG = """
operating_point: {motor_speed: 1500 rpm, load: {occupancy: OCCUPANCY %}}
measured: torque_sensor
rig:
  motor: {kind: motor, catalog: GP-71M}
  torque_sensor: {kind: coupling, stiffness: 1000 N*m/rad, damping: 0.1 N*m*s/rad}
  wear_part: {kind: body, inertia: 2.0e-3 kg*m^2}
  supply: {kind: induction_drive, motor: motor, catalog: DRIVE}
  load: {kind: particle_load, at: wear_part, mean_by_occupancy_percent: {0: 0.1 N*m, 20: 1.5 N*m}, hit_rms: 0.0}
"""


def test_the_gp_71m_slips_in_a_scenario() -> None:
    """Drawn from the catalog's intervals: more occupancy, less speed, as its own name plate says."""
    speeds = []
    for occupancy in (0, 20):
        text = RIG.replace("OCCUPANCY", str(occupancy)).replace("DRIVE", "GP-71M")
        made = read_scenario(parse_document(text, Path("slip.yaml")), CATALOG, seed=3)
        motor = made.rig.part("motor")
        drive = made.rig.part("supply")
        assert isinstance(motor, Motor)
        assert isinstance(drive, InductionDrive)
        assert "rated_speed" in str(made.assumed)
        speeds.append(settled(simulate(made.rig, duration=0.5, seed=3)))
        torque = {0: 0.1, 20: 1.5}[occupancy] + motor.coulomb + motor.viscous * speeds[-1]
        assert speeds[-1] == pytest.approx(drive.machine().speed(torque), rel=2e-4)  # class ripple and slow load
    assert 10 * RPM < speeds[0] - speeds[1] < 150 * RPM


def test_a_motor_with_magnets_has_no_slip() -> None:
    text = RIG.replace("OCCUPANCY", "5").replace("DRIVE", "HDS6A-0104A")
    with pytest.raises(InputError, match=r"slip\.yaml:\d+.*has no slip; write a speed_controller"):
        read_scenario(parse_document(text, Path("slip.yaml")), CATALOG, seed=1)


def test_a_name_plate_that_cannot_be_is_refused() -> None:
    with pytest.raises(ValueError, match="lies below 1500 rpm"):
        InductionDrive(name="d", pole_pairs=2, rated_torque=2.0, rated_speed=1600 * RPM, breakdown_torque=5.0)
