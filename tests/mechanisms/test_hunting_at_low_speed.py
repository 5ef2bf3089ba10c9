"""Limit cycles of a speed loop at low speed, out of friction and out of encoder counts; no line is put in anywhere."""

from __future__ import annotations

from math import exp, pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from torquerig.mechanisms import LugreFriction, StribeckFriction
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear, Motor, MotorEncoder, SpeedController, TorqueController
from torquerig.simulation.simulator import simulate

MOTOR, LOAD = 4e-4, 5e-4
INERTIA = MOTOR + LOAD  # their spring is stiff against all that happens here


def rig(*effects: Part, speed: float, kp: float, ki: float, bandwidth: float = 500.0) -> Rig:
    """A motor and its load under a PI speed loop."""
    return Rig(
        (
            Motor(name="motor", inertia=MOTOR, torque_limit=10.0, current_loop_bandwidth=bandwidth),
            Gear(name="gearbox", after="motor", ratio=1.0, stiffness=1000.0, damping=0.1),
            Body(name="wear_part", after="gearbox", inertia=LOAD),
            SpeedController(name="loop", kp=kp, ki=ki),
            *effects,
        ),
        Run(speed=speed),
        measured="gearbox",
    )


# friction: the integrator winds up while the shaft sticks, breaks it loose, and overshoots
KP, KI, COULOMB = 0.0036, 0.09, 0.01


def stribeck(excess: float) -> StribeckFriction:
    return StribeckFriction(
        name="friction", coulomb=COULOMB, static=COULOMB + excess, stribeck_speed=0.02, smoothing=1e-3
    )


def bristles(excess: float) -> LugreFriction:
    return LugreFriction(
        name="friction", coulomb=COULOMB, static=COULOMB + excess, stribeck_speed=0.02, stiffness=200.0, damping=0.05
    )


def stick_slip_period(speed: float, excess: float) -> float | None:
    """Period of ``J w' = kp (v - w) + ki int(v - w) - Tc``, held at w = 0 up to Ts: exact; None where it never sticks.

    The integral over its balance swings freely, damped, from break-away (z0, z' = v) until the shaft stands (z' = v
    again), and comes back at the rate v: the mass on a belt (Den Hartog, Mechanical Vibrations, section 7.3).
    """
    natural = sqrt(KI / INERTIA)
    fading = KP / (2 * INERTIA)
    swing, start = sqrt(natural**2 - fading**2), (excess - KP * speed) / KI
    other = (speed + fading * start) / swing

    def over(t: float) -> float:
        return float(exp(-fading * t) * (start * np.cos(swing * t) + other * np.sin(swing * t)))

    def rate(t: float) -> float:
        turned = (swing * other - fading * start) * np.cos(swing * t) - (fading * other + swing * start) * np.sin(
            swing * t
        )
        return float(exp(-fading * t) * turned) - speed

    tried = np.linspace(0.01, 1.0, 1000) * 2 * pi / swing
    rates = np.array([rate(t) for t in tried])
    stands = np.flatnonzero((rates[:-1] < 0) & (rates[1:] >= 0))
    if start <= 0 or not stands.size:
        return None
    slipping = brentq(rate, tried[stands[0]], tried[stands[0] + 1])
    return float(slipping + (start - over(slipping)) / speed)


def crept(friction: Part, speed: float) -> NDArray[np.float64]:
    """Speed of the load over 20 s at a set-point [rad/s], after 10 s."""
    made = simulate(rig(friction, speed=speed, kp=KP, ki=KI), duration=20.0, seed=1, sample_rate=1000.0, settling=10.0)
    return made.channels["true_output_speed_rad_s"].values


@pytest.mark.parametrize(("friction", "within"), [(stribeck, 0.01), (bristles, 0.02)], ids=["stribeck", "bristles"])
@pytest.mark.parametrize(("speed", "excess"), [(0.1, 0.01), (0.2, 0.01), (0.1, 0.02)])
def test_a_loop_with_an_integrator_sticks_and_slips_at_the_period_of_the_closed_form(
    friction: type, within: float, speed: float, excess: float
) -> None:
    """Handbook 2.6 (Olsson & Astrom 2001): about (1 + overshoot)(Ts - Tc) / (ki v).

    At twice the speed half as long, with twice the excess double; the pause is the larger part of it.
    """
    turned = crept(friction(excess), speed)
    loose = turned > 0.5 * speed
    starts = np.flatnonzero(~loose[:-1] & loose[1:])
    period = np.diff(starts).mean() / 1000.0
    assert period == pytest.approx(stick_slip_period(speed, excess), rel=within)
    assert np.mean(np.abs(turned) < 0.2 * speed) > 0.3  # it stands a good part of the time
    assert turned[starts[0] : starts[-1]].mean() == pytest.approx(speed, rel=0.02)


@pytest.mark.parametrize("friction", [stribeck, bristles])
def test_without_static_excess_or_above_a_speed_nothing_hunts(friction: type) -> None:
    """Above the speed at which the closed form never stands again; Coulomb friction alone damps at any speed."""
    limit = brentq(lambda speed: (stick_slip_period(speed, 0.01) is not None) - 0.5, 0.1, 2.0, xtol=1e-3)
    assert limit == pytest.approx(0.41, abs=0.01)
    assert stick_slip_period(0.1, 0.0) is None
    assert crept(friction(0.01), 0.5 * limit).std() > 0.3 * limit
    assert crept(friction(0.01), 1.5 * limit).std() < 1e-6
    assert crept(friction(0.0), 0.1).std() < 1e-6


# counts: the torque that is needed lies between what two neighbouring counts demand
COUNTED_RATE, PROPORTIONAL, INTEGRAL = 4000.0, 0.02, 0.2


def counted(
    share: float,
    *,
    counts: int = 1000,
    lag: float = 10.0,
    smoothed: float = 5e-3,
    speed: float = 0.0,
    fed: bool = True,
) -> Recording:
    """The loop against a steady torque of ``share`` counts of its integral; no friction."""
    encoder = MotorEncoder(
        name="encoder", counts_per_rev=counts, controller="loop" if fed else "", speed_filter=smoothed
    )
    load = TorqueController(name="load", torque=share * INTEGRAL * 2 * pi / counts, beside="loop")
    held = rig(encoder, load, speed=speed, kp=PROPORTIONAL, ki=INTEGRAL, bandwidth=lag)
    return simulate(held, duration=8.0, seed=1, sample_rate=COUNTED_RATE, settling=4.0)


def opened(frequency: float, lag: float, smoothed: float) -> complex:
    """From the read angle back to the angle: PI, filter, current loop, inertia, and a sample of difference and hold."""
    s = 2j * pi * frequency
    lags = (1 + s / (2 * pi * lag)) * (1 + smoothed * s)
    return complex((PROPORTIONAL * s + INTEGRAL) / (INERTIA * s**2 * lags) * np.exp(-s / COUNTED_RATE))


@pytest.mark.parametrize(
    "changed", [{}, {"counts": 4000}, {"smoothed": 20e-3}, {"lag": 40.0}], ids=["as is", "finer", "smoother", "faster"]
)
def test_a_loop_hunts_between_two_counts_where_its_phase_has_run_out(changed: dict[str, float]) -> None:
    """One step of a quantizer is a relay of half a count (Gelb & Vander Velde 1968, appendix B): ``N = 2 d / (pi A)``.

    Frequency where the loop's phase is -180 degrees, whatever the counts; size ``2 d |L| / pi``. Within 5 %, as the
    function leaves harmonics and the place of the samples out.
    """
    made = counted(0.5, **changed)  # type: ignore[arg-type]
    lag, smoothed = changed.get("lag", 10.0), changed.get("smoothed", 5e-3)
    expected = brentq(lambda f: np.angle(-opened(f, lag, smoothed)), 2.0, 300.0)
    values = made.channels["true_motor_speed_rad_s"].values
    lines = np.abs(np.fft.rfft((values - values.mean()) * np.hanning(values.size)))
    assert np.argmax(lines) / 8.0 == pytest.approx(expected, rel=0.05)
    wide = 2 / pi * 2 * pi / changed.get("counts", 1000) * abs(opened(expected, lag, smoothed))
    assert values.std() * sqrt(2) == pytest.approx(2 * pi * expected * wide, rel=0.05)


def test_without_a_torque_between_two_counts_or_without_counts_it_stands_still() -> None:
    still, low, half = (counted(share).channels["true_motor_speed_rad_s"].values.std() for share in (0.0, 0.3, 0.5))
    assert still == 0.0
    assert min(low, half) > 0.02
    assert counted(0.5, fed=False).channels["true_motor_speed_rad_s"].values.std() < 1e-9


def test_counts_that_pass_fast_against_the_loop_leave_no_cycle() -> None:
    """At 1 rad/s 159 counts pass in a second, ten times the frequency at which the loop would hunt."""
    slow, fast = (counted(0.5, speed=speed).channels["true_motor_speed_rad_s"].values for speed in (0.0, 1.0))
    assert fast.std() < 0.05 * slow.std()
