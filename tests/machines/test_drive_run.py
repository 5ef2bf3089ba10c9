"""Machine, control and two masses together: momentum, sameness, convergence and the spring's own frequency."""

import numpy as np
import pytest

from torquerig.errors import SimulationError
from torquerig.machines.back_emf import HarmonicEmf, TrapezoidalEmf
from torquerig.machines.demand import SpeedDemand, TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.field_oriented import FieldOriented
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.shaft import ImposedSpeed, TwoMasses
from torquerig.machines.six_step import SixStep

SHAFT = TwoMasses(rotor_inertia=5e-3, load_inertia=5e-3, stiffness=700.0, damping=0.01, load_torque=0.3)
HOLD = SpeedDemand(speed=100.0, proportional=0.3, integral=3.0, torque_limit=2.0)
CONTROLS = [FieldOriented(dc_link=48.0, dead_time=1e-6), SixStep(dc_link=48.0)]


def machine(back_emf):
    return PermanentMagnetMachine(
        pole_pairs=7, phase_resistance=0.2, phase_inductance=0.3e-3, flux_linkage=0.01, back_emf=back_emf
    )


@pytest.mark.long
@pytest.mark.parametrize("control", CONTROLS)
def test_momentum_is_the_integral_of_torque_less_load(control):
    run = run_drive(machine(TrapezoidalEmf()), control, shaft=SHAFT, demand=HOLD, duration=1.0, substeps=2)
    momentum = SHAFT.rotor_inertia * run.speed + SHAFT.load_inertia * run.load_speed
    given = np.trapezoid(run.torque - SHAFT.load_torque, dx=run.period)
    assert momentum[-1] - momentum[0] == pytest.approx(given, rel=2e-4)


@pytest.mark.parametrize("control", CONTROLS)
def test_speed_is_held_and_the_spring_carries_the_load(control):
    run = run_drive(machine(HarmonicEmf()), control, shaft=SHAFT, demand=HOLD, duration=2.0)
    assert run.load_speed[-5000:].mean() == pytest.approx(100.0, rel=1e-4)
    assert run.shaft_torque[-5000:].mean() == pytest.approx(0.3, rel=1e-3)


@pytest.mark.parametrize("control", CONTROLS)
def test_same_inputs_give_the_same_bytes(control):
    first, second = (
        run_drive(machine(HarmonicEmf({1: 1.0, 5: 0.04})), control, shaft=SHAFT, demand=HOLD, duration=0.1)
        for _ in range(2)
    )
    assert first.rows.tobytes() == second.rows.tobytes()


def test_two_masses_ring_at_their_own_frequency_simulators_6_1_d():
    """J 0.005, 0.005; k 700: 84.217 Hz; a torque step on the rotor shakes the spring freely."""
    run = run_drive(
        machine(HarmonicEmf()),
        FieldOriented(dc_link=48.0),
        shaft=TwoMasses(rotor_inertia=5e-3, load_inertia=5e-3, stiffness=700.0),
        demand=TorqueDemand(torque=0.2),
        duration=1.0,
    )
    swing = run.shaft_torque - run.shaft_torque.mean()
    rising = np.flatnonzero((swing[:-1] < 0) & (swing[1:] >= 0))
    instants = rising - swing[rising] / (swing[rising + 1] - swing[rising])
    frequency = (len(instants) - 1) / ((instants[-1] - instants[0]) * run.period)
    assert frequency == pytest.approx(84.217, abs=0.02)


def test_runge_kutta_converges_in_the_period():
    """A smooth machine: the coarsest step is already good to 1e-6, and four steps bring it 100 times closer."""
    ends = [
        run_drive(
            machine(HarmonicEmf({1: 1.0, 5: 0.04})),
            FieldOriented(dc_link=48.0),
            shaft=SHAFT,
            demand=HOLD,
            duration=0.3,
            substeps=substeps,
        ).currents[-1, 0]
        for substeps in (1, 4, 16)
    ]
    assert abs(ends[0] - ends[2]) < 1e-4
    assert abs(ends[1] - ends[2]) < 0.02 * abs(ends[0] - ends[2])


def test_a_run_that_blows_up_says_when():
    with pytest.raises(SimulationError, match=r"leaves the finite numbers at .* s"):
        run_drive(
            machine(HarmonicEmf()),
            FieldOriented(dc_link=48.0),
            shaft=TwoMasses(rotor_inertia=1e-11, load_inertia=1e-11, stiffness=1e9),
            demand=TorqueDemand(torque=0.2),
            duration=0.1,
        )


def test_unloaded_machine_at_no_demand_makes_no_torque():
    run = run_drive(
        machine(HarmonicEmf()),
        FieldOriented(dc_link=48.0),
        shaft=ImposedSpeed(speed=50.0),
        demand=TorqueDemand(torque=0.0),
        duration=0.2,
    )
    assert np.abs(run.torque[-1000:]).max() < 1e-9
