"""The two-node network against closed forms: adiabatic start, steady state, single nodes, scipy's integrator."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from torquerig.thermal.motor_variants import (
    CONSTANT_AT_1NM,
    CONSTANT_EXPONENT,
    RESISTANCE_AT_1NM,
    RESISTANCE_EXPONENT,
    TREND_FACTOR,
    network_of,
)
from torquerig.thermal.two_node import Stretch, TwoNode, eigenvalues

NETWORK = TwoNode(winding_capacity=90.0, housing_capacity=800.0, winding_to_housing=0.35, housing_to_ambient=0.75)
# Wittenstein premo 320 V table [W1], motors.md section 3: T0 N m, I0 Arms, R between phases ohm, Rth K/W, tau min
PREMO = {
    "1C": (0.60, 1.73, 15.1, 1.19, 12.0),
    "2C": (1.17, 2.96, 5.70, 0.94, 15.7),
    "2D": (2.11, 4.04, 3.72, 0.81, 17.4),
    "3F": (6.38, 12.2, 0.53, 0.54, 33.2),
}


def heated(copper: float, iron: float = 0.0, growth: float = 0.0, network: TwoNode = NETWORK) -> Stretch:
    return network.stretch(np.array([copper, iron]), growth)


def test_heat_first_stays_where_it_is_made():
    """Adiabatic: after a time t far below the fast constant the rise is P t / C, off by t / (2 Rwh Cw) of itself."""
    time = 0.01
    rise = heated(60.0, 20.0).after(time, np.zeros(2))
    assert rise[0] == pytest.approx(60.0 * time / 90.0, rel=time / (2 * 0.35 * 90.0) * 1.01)
    assert rise[1] == pytest.approx(20.0 * time / 800.0, rel=1e-3)


def test_steady_rise_is_heat_times_resistance():
    rise = heated(60.0, 20.0).after(1e6, np.zeros(2))
    assert rise == pytest.approx([60 * 0.35 + 80 * 0.75, 80 * 0.75])


def test_copper_that_warms_itself_rises_by_the_closed_form():
    """P = P0 + k x gives x = P0 R / (1 - k R); beyond k R = 1 nothing is steady."""
    growth = 0.3
    rise = heated(60.0, growth=growth).after(1e7, np.zeros(2))
    assert rise[0] == pytest.approx(60 * 1.10 / (1 - growth * 1.10))
    assert eigenvalues(NETWORK.matrix(1 / 1.10 * 1.001))[0] > 0 > eigenvalues(NETWORK.matrix(1 / 1.10 * 0.999))[0]


def test_a_housing_held_at_ambient_leaves_one_exponential():
    """Cw xw' = P - xw / Rwh: rise P R (1 - exp(-t / (R C))), where the housing is a hundred thousand times heavier."""
    one = TwoNode(winding_capacity=90.0, housing_capacity=9e6, winding_to_housing=0.35, housing_to_ambient=1e-6)
    time = np.array([5.0, 31.5, 120.0])
    rise = [heated(60.0, network=one).after(float(t), np.zeros(2))[0] for t in time]
    assert rise == pytest.approx((60 * 0.35 * (1 - np.exp(-time / (0.35 * 90.0)))).tolist(), rel=1e-5)


def test_winding_and_housing_at_one_temperature_are_one_body():
    one = TwoNode(winding_capacity=90.0, housing_capacity=800.0, winding_to_housing=1e-7, housing_to_ambient=0.75)
    time = 400.0
    assert heated(60.0, network=one).after(time, np.zeros(2))[1] == pytest.approx(
        60 * 0.75 * (1 - np.exp(-time / (0.75 * 890.0))), rel=1e-6
    )


@pytest.mark.parametrize("growth", [0.0, 0.4, 1.5], ids=["cold", "warm", "runaway"])
def test_the_step_is_what_an_integrator_finds(growth):
    stretch, start = heated(150.0, 12.0, growth), np.array([40.0, 5.0])
    solved = solve_ivp(
        lambda _, x: stretch.matrix @ x + stretch.source, (0, 300.0), start, method="DOP853", rtol=1e-11, atol=1e-9
    )
    assert stretch.after(300.0, start) == pytest.approx(solved.y[:, -1], rel=1e-8)
    # and it is a step of itself: half and half is the whole
    assert stretch.after(150.0, stretch.after(150.0, start)) == pytest.approx(stretch.after(300.0, start), rel=1e-12)


def test_the_turning_point_is_the_highest():
    """A hot housing first warms the winding further, then both cool."""
    stretch, start = heated(0.0), np.array([30.0, 60.0])
    turn = stretch.turning(500.0, start)
    fine = [stretch.after(t, start)[0] for t in np.linspace(0, 500, 5001)]
    assert turn == pytest.approx(np.linspace(0, 500, 5001)[int(np.argmax(fine))], abs=0.1)
    assert stretch.turning(0.5 * turn, start) is None


@pytest.mark.parametrize(("rth", "minutes"), [row[3:] for row in PREMO.values()], ids=PREMO)
@pytest.mark.parametrize("shares", [(0.2, 0.05), (0.5, 0.2)])
def test_published_time_constants_and_resistances_come_back(rth, minutes, shares):
    """Whatever the split, the slow mode has the published constant and the steady rise the published resistance."""
    made = network_of(resistance=rth, time_constant=60 * minutes, resistance_share=shares[0], capacity_share=shares[1])
    assert made.time_constants()[1] == pytest.approx(60 * minutes)
    assert made.resistance == pytest.approx(rth)
    slow, long = 60 * minutes, 8 * 60 * minutes  # by then the fast mode has died out
    left = [rth - heated(1.0, network=made).after(t, np.zeros(2))[0] for t in (long, long + slow)]
    assert left[1] / left[0] == pytest.approx(np.exp(-1), rel=1e-6)


@pytest.mark.parametrize(("torque", "current", "between", "rth", "minutes"), PREMO.values(), ids=PREMO)
def test_continuous_torque_of_published_motors_means_a_winding_at_its_limit(torque, current, between, rth, minutes):
    """The rule by which copies are made, on four motors whose data are all printed: 125..170 C, classes B to F and H.

    x = Rth P20 (1 + a (40 C + x - 20 C)) at 40 C, P20 = 3 (R / 2) I^2; the trend holds them within its factor.
    """
    cold = 1.5 * between * current**2 * rth
    winding = 40 + cold * (1 + 0.00393 * 20) / (1 - 0.00393 * cold)
    assert 125 < winding < 170
    assert 1 / TREND_FACTOR < RESISTANCE_AT_1NM * torque**RESISTANCE_EXPONENT / rth < TREND_FACTOR
    assert 1 / TREND_FACTOR < CONSTANT_AT_1NM * torque**CONSTANT_EXPONENT / (60 * minutes) < TREND_FACTOR
