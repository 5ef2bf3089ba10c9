"""The induction machine: the curve of Kloss, the name plate of a 71M, and the fluxes that settle on both."""

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.machines.induction import InductionMachine, frame_71m_four_pole, induction_from_rating
from torquerig.machines.induction_run import InductionSupply, run_induction

RPM = pi / 30


def test_kloss_at_breakdown_at_standstill_and_mirrored():
    made = InductionMachine(pole_pairs=2, breakdown_torque=5.0, breakdown_slip=0.25)
    assert made.torque(0.25) == pytest.approx(5.0)
    assert made.torque(1.0) == pytest.approx(10.0 / (4 + 0.25))
    assert made.torque(-0.1) == pytest.approx(-made.torque(0.1))
    assert made.torque(0.0) == 0.0


@pytest.mark.parametrize("load", [0.0, 1.0, 2.2, 5.0, -1.0])
def test_slip_under_load_inverts_the_curve(load):
    made = frame_71m_four_pole()
    assert made.torque(made.slip(load)) == pytest.approx(load, abs=1e-12)
    assert abs(made.slip(load)) <= made.breakdown_slip


def test_71m_runs_at_its_name_plate_and_stalls_above_breakdown_motors_4():
    made = frame_71m_four_pole()
    assert made.speed(2.2) == pytest.approx(1385 * RPM)
    assert made.breakdown_torque == pytest.approx(2.4 * 2.2)
    assert made.speed(0.0) == pytest.approx(1500 * RPM)
    with pytest.raises(InputError, match=r"a load of 6 N\*m stalls"):
        made.slip(6.0)


def test_bad_name_plates_are_refused():
    with pytest.raises(InputError, match="lies below 1500 rpm"):
        induction_from_rating(rated_torque=2.0, rated_speed=1600 * RPM, breakdown_ratio=2.0, pole_pairs=2)
    with pytest.raises(InputError, match="write more than 1"):
        induction_from_rating(rated_torque=2.0, rated_speed=1400 * RPM, breakdown_ratio=1.0, pole_pairs=2)


@pytest.mark.parametrize("load", [1.0, 2.2])
def test_fluxes_settle_on_the_curve_where_the_stator_has_no_resistance(load):
    made = frame_71m_four_pole()
    run = run_induction(
        made, InductionSupply(), inertia=1e-3, load_torque=load, duration=0.5, initial_speed=1450 * RPM, step=5e-4
    )
    assert run.speed[-40:].mean() == pytest.approx(made.speed(load), rel=1e-5)


def test_fluxes_settle_on_the_circuit_s_torque_with_stator_resistance():
    """Steady torque of the Gamma circuit by phasors, at the slip that the run ends with."""
    made, supply = frame_71m_four_pole(), InductionSupply(stator_resistance=20.0, magnetising_inductance=1.2)
    run = run_induction(made, supply, inertia=1e-3, load_torque=1.5, duration=1.0, initial_speed=1450 * RPM, step=5e-4)
    pulse, volts = 2 * pi * 50.0, 400.0 * sqrt(2 / 3)
    slip = 1 - run.speed[-40:].mean() / made.synchronous_speed
    leakage = 0.75 * 2 * (volts / pulse) ** 2 / made.breakdown_torque
    rotor = made.breakdown_slip * pulse * leakage / slip + 1j * pulse * leakage
    magnetising = 1j * pulse * 1.2
    gap = volts / (20.0 + rotor * magnetising / (rotor + magnetising)) * (rotor * magnetising / (rotor + magnetising))
    torque = 1.5 * 2 / pulse * abs(gap / rotor) ** 2 * rotor.real
    assert torque == pytest.approx(1.5, rel=3e-4)


@pytest.mark.parametrize("load", [0.5, 2.2])
def test_supply_unbalance_shakes_at_twice_the_supply_whatever_the_slip_signatures_1_8(load):
    made = frame_71m_four_pole()
    run = run_induction(
        made,
        InductionSupply(stator_resistance=10.0, unbalance=0.02),
        inertia=1e-2,
        load_torque=load,
        duration=1.2,
        initial_speed=made.speed(load),
        step=5e-4,
    )
    tail = run.torque[-800:]  # 0.4 s: 20 periods of the supply
    lines = 2 * np.abs(np.fft.rfft(tail)) / len(tail)
    assert int(np.argmax(lines[1:])) + 1 == 40  # 100 Hz in bins of 2.5 Hz
    assert lines[40] > 0.05
