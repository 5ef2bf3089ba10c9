"""What a real current loop makes of a smooth machine: no ripple by itself, and each error its own order."""

from cmath import phase
from itertools import pairwise
from math import exp, pi, sqrt

import numpy as np
import pytest

from torquerig.machines.back_emf import HarmonicEmf
from torquerig.machines.demand import TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.field_oriented import FieldOriented
from torquerig.machines.permanent_magnet import PHASE_LAG, PermanentMagnetMachine
from torquerig.machines.ripple_orders import ripple_orders
from torquerig.machines.shaft import ImposedSpeed

SLOW = 10.0  # rad/s: 70 rad/s electrical, far below the loop's 6283 rad/s


def machine(**amplitudes):
    harmonics = {1: 1.0} | {int(name[1:]): amplitude for name, amplitude in amplitudes.items()}
    return PermanentMagnetMachine(
        pole_pairs=7, phase_resistance=0.2, phase_inductance=0.3e-3, flux_linkage=0.01, back_emf=HarmonicEmf(harmonics)
    )


def control(**errors):
    return FieldOriented(dc_link=48.0, **errors)


@pytest.mark.parametrize("speed", [SLOW, 100.0, -100.0])
def test_sinusoidal_machine_has_no_ripple_and_the_torque_demanded(speed):
    found = ripple_orders(machine(), control(), speed=speed, torque=0.5)
    assert found.above(1e-6) == ()
    assert found.mean_torque == pytest.approx(0.5, rel=1e-6)


@pytest.mark.long
def test_emf_harmonics_give_the_sixth_order_of_their_difference_simulators_6_4():
    """Where the loop is fast enough to hold the currents sinusoidal; the rest is what the loop lets through."""
    found = ripple_orders(machine(e5=0.04, e7=0.015), control(), speed=1.0, torque=0.5)
    assert found.depth(6 * 7) == pytest.approx(0.025, rel=0.01)
    assert found.above(1e-3)[0].order_motor == 42
    faster = ripple_orders(machine(e5=0.04, e7=0.015), control(), speed=100.0, torque=0.5)
    assert abs(faster.depth(42) - 0.025) > 0.005


@pytest.mark.long
@pytest.mark.parametrize("offset", [(0.05, 0.0), (0.0, 0.05), (0.05, -0.02)])
def test_current_offset_gives_order_p_whatever_the_load_signatures_2_1(offset):
    """Two sensors a and b: the offset's space vector is 2/sqrt(3) sqrt(a^2 + a b + b^2), held against the rotor."""
    a, b = offset
    expected = 1.5 * 7 * 0.01 * 2 / sqrt(3) * sqrt(a * a + a * b + b * b)
    for torque in (0.2, 0.8):
        found = ripple_orders(machine(), control(current_offset=offset), speed=SLOW, torque=torque)
        assert found.amplitude(7) == pytest.approx(expected, rel=2e-3)
        assert [line.order_motor for line in found.above(1e-6)] == [7]


@pytest.mark.parametrize("torque", [0.2, 0.8])
def test_current_gain_gives_order_2p_in_proportion_to_torque_signatures_2_2(torque):
    found = ripple_orders(machine(), control(current_gain=(0.004, -0.002)), speed=SLOW, torque=torque)
    assert found.depth(2 * 7) == pytest.approx(0.006 / sqrt(3), rel=5e-3)
    assert found.above(1e-4)[0].order_motor == 14


@pytest.mark.parametrize("speed", [20.0, 40.0])
def test_dead_time_gives_order_6p_of_its_fifth_and_seventh_voltage_signatures_2_3(speed):
    """No harmonic goes in. A square wave has 4/pi (1/5 - 1/7) on the q axis; s/((Ls+R)(s+a)) of it becomes current."""
    made, volts = machine(), 48.0 * 1e-6 / 40e-6
    s, pole = 6j * 7 * speed, 2 * pi * 1000.0
    admittance = s / ((0.3e-3 * s + 0.2) * (s + pole))
    expected = 1.5 * 7 * 0.01 * 4 / pi * volts * (1 / 5 - 1 / 7) * abs(admittance)
    for torque in (2.0, 5.0):
        found = ripple_orders(made, control(dead_time=1e-6), speed=speed, torque=torque)
        assert found.amplitude(42) == pytest.approx(expected, rel=0.05)
        assert {line.order_motor % 42 for line in found.above(1e-5)} == {0}
        assert found.above(1e-5)[0].phase == pytest.approx(phase(admittance), abs=0.1)
    none = ripple_orders(made, control(dead_time=0.0), speed=speed, torque=2.0)
    assert none.depth(42) < 1e-9


@pytest.mark.parametrize("speed", [0.0, 200.0])
def test_a_step_of_demand_follows_as_a_lag_of_the_bandwidth(speed):
    """``1 - exp(-a (t - T))``: one period of computing; the two axes stay apart at speed."""
    made, loop = machine(), control(period=10e-6, bandwidth=500.0)
    run = run_drive(
        made, loop, shaft=ImposedSpeed(speed=speed), demand=TorqueDemand(torque=0.5), duration=2e-3, substeps=2
    )
    for sample in (30, 60, 120):
        expected = 1 - exp(-2 * pi * 500.0 * (sample - 1) * 10e-6)
        assert run.torque[sample] / 0.5 == pytest.approx(expected, abs=0.03)
    electrical = 7 * run.angle[:, None] - PHASE_LAG
    along = -2 / 3 * (run.currents * np.cos(electrical)).sum(axis=1)
    assert np.abs(along).max() < 0.01 * 0.5 / loop.torque_per_ampere(made)


def test_angle_error_costs_torque_by_its_cosine_and_makes_no_ripple():
    found = ripple_orders(machine(), control(angle_error=0.2), speed=SLOW, torque=0.5)
    assert found.mean_torque == pytest.approx(0.5 * 0.9800665778, rel=1e-6)
    assert found.above(1e-6) == ()


def test_the_dc_link_limits_the_torque_that_is_reached():
    """At 390 rad/s the EMF of 27.3 V and the drop of 1 V together need more than 48 V / sqrt(3)."""
    found = ripple_orders(machine(), control(period=20e-6), speed=390.0, torque=0.5)
    assert found.mean_torque < 0.45
    assert ripple_orders(machine(), control(period=20e-6), speed=350.0, torque=0.5).mean_torque == pytest.approx(0.5)


def test_halving_the_period_converges():
    """Bandwidth held: what is left over is the delay's, of first order, so that the changes halve."""
    depths = [
        ripple_orders(machine(e5=0.04, e7=0.015), control(period=period), speed=100.0, torque=0.5).depth(42)
        for period in (40e-6, 20e-6, 10e-6, 5e-6)
    ]
    changes = [abs(after - before) for before, after in pairwise(depths)]
    assert changes[1] < 0.65 * changes[0]
    assert changes[2] < 0.65 * changes[1]
    assert changes[2] < 0.04 * depths[-1]


def test_a_loop_too_fast_for_its_period_is_refused():
    with pytest.raises(ValueError, match="write at most 2500 Hz or shorten the period"):
        control(bandwidth=3000.0)
    with pytest.raises(ValueError, match="leaves nothing of a period"):
        control(dead_time=30e-6)
