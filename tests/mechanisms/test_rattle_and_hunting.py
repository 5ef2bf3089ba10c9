"""What a gap makes of a drive: rattle at idle, and a limit cycle of the speed loop; neither has a line as input."""

from __future__ import annotations

from math import asin, pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.mechanisms import Backlash, StribeckFriction, TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear, Motor, SpeedController
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

RIPPLE = TorqueRipple(name="ripple", at="motor", group="electrical", amplitudes={7.0: 0.05})


def idle(load: float, *effects: Part, speed_rpm: float) -> Rig:
    """A motor with a torque ripple on a 5:1 gear that carries ``load`` [N m] of dry friction."""
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=11300, damping=2.0, output_inertia=7e-4),
            Body(name="wear_part", after="gearbox", inertia=2e-3),
            SpeedController(name="loop", kp=0.02, ki=0.0),
            StribeckFriction(name="drag", coulomb=load, static=load, stribeck_speed=1.0),
            RIPPLE,
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="gearbox",
    )


def harmonics(made: Recording, order: float) -> NDArray[np.float64]:
    """Amplitudes of the first three harmonics of a motor order in the gear's torque [N m]."""
    angle = order * made.channels["true_motor_angle_rad"].values
    waves = [np.ones(angle.size)] + [f(h * angle) for h in (1, 2, 3) for f in (np.cos, np.sin)]
    window = np.hanning(angle.size)
    found = np.linalg.lstsq(np.column_stack(waves) * window[:, None], made.torque() * window, rcond=None)[0][1:]
    return np.hypot(found[::2], found[1::2])


@pytest.mark.parametrize("speed_rpm", [600.0, 800.0])
@pytest.mark.parametrize("share", [0.7, 1.4])
def test_an_idle_gear_rattles_where_its_dynamic_torque_is_more_than_its_load(share: float, speed_rpm: float) -> None:
    """Handbook 3.5: a threshold and no proportion. Below it the flanks part and harmonics of the driving order stand.

    The dynamic torque is the linear twin's (gap closed) for the ripple at its order; the load is a share of it.
    """
    frequency = np.array([7 * speed_rpm / 60])
    response = spring_response(lower(idle(0.1, speed_rpm=speed_rpm), 1), "gearbox", frequency, speed_loop=True)
    dynamic = float(abs(response["motor"][0])) * 0.05
    gap = Backlash(name="gap", gap=3e-3)
    loose, tight = (
        simulate(idle(share * dynamic, *some, speed_rpm=speed_rpm), duration=0.5, seed=1) for some in ((gap,), ())
    )
    plain = harmonics(tight, 7)
    assert plain[0] == pytest.approx(dynamic, rel=0.03)
    assert plain[1:].max() < 0.01 * dynamic
    if share < 1:
        assert np.mean(loose.torque() == 0.0) > 0.02  # in the gap
        assert harmonics(loose, 7)[1:].max() > 0.2 * dynamic
    else:
        assert loose.torque().min() > 0.1 * dynamic
        assert harmonics(loose, 7) == pytest.approx(plain, abs=0.01 * dynamic)


# a loop that is slow enough for its phase to run out: 10 Hz of current loop, control once a millisecond
RATE, LAG = 1000.0, 1 / (2 * pi * 10.0)
MOTOR, LOAD, STIFFNESS, DAMPING = 1.5e-4, 7.5e-4, 110.0, 0.012


def hunting(kp: float, *effects: Part, speed: float = 10.0) -> Recording:
    """A motor with a load of five times its inertia, no load torque, no harmonic anywhere."""
    rig = Rig(
        (
            Motor(name="motor", inertia=MOTOR, torque_limit=1e3, viscous=1e-4, current_loop_bandwidth=10.0),
            Gear(name="gearbox", after="motor", ratio=1.0, stiffness=STIFFNESS, damping=DAMPING),
            Body(name="wear_part", after="gearbox", inertia=LOAD),
            SpeedController(name="loop", kp=kp, ki=0.0),
            *effects,
        ),
        Run(speed=speed),
        measured="gearbox",
    )
    return simulate(rig, duration=4.0, seed=1, sample_rate=RATE, settling=4.0)


def swing(made: Recording) -> NDArray[np.float64]:
    values = made.channels["true_motor_speed_rad_s"].values
    return np.asarray(values - values.mean())


def spectrum(made: Recording) -> NDArray[np.float64]:
    values = swing(made)
    return np.asarray(np.abs(np.fft.rfft(values * np.hanning(values.size))))


def loop_gain(kp: float, frequency: float, stiff: float) -> complex:
    """The speed loop, opened, with ``stiff`` of the spring left by the gap: lag, hold, two masses."""
    s = 2j * pi * frequency
    spring = stiff * (STIFFNESS + DAMPING * s)
    control = kp / (1 + LAG * s) * np.exp(-0.5 * s / RATE)
    return complex(control * s / (MOTOR * s**2 + spring * LOAD * s**2 / (LOAD * s**2 + spring)))


def predicted(kp: float) -> tuple[float, float]:
    """Frequency [Hz] and share of the stiffness at which ``1 + L = 0``: harmonic balance with a dead zone."""
    from scipy.optimize import fsolve

    def balance(x: NDArray[np.float64]) -> list[float]:
        left = 1 + loop_gain(kp, x[0], x[1])
        return [left.real, left.imag]

    found, _, solved, _ = fsolve(balance, [120.0, 0.5], full_output=True)
    assert solved == 1
    return float(found[0]), float(found[1])


def dead_zone(ratio: float) -> float:
    """Describing function of a dead zone for a swing of ``ratio`` half gaps (Gelb & Vander Velde 1968, appendix B)."""
    return 1 - 2 / pi * (asin(1 / ratio) + sqrt(1 - 1 / ratio**2) / ratio)


GAP = Backlash(name="gap", gap=2e-3)


def test_a_loop_that_is_stable_without_a_gap_hunts_with_one_above_a_gain() -> None:
    """Handbook 2.6. In the gap the motor is alone; its own loop is unstable above 0.31 N m s/rad, with the load 0.6."""
    from scipy.optimize import brentq

    crossover = brentq(lambda f: np.angle(-loop_gain(1.0, f, 0.0)), 20.0, 120.0)
    limit = 1 / abs(loop_gain(1.0, crossover, 0.0))
    assert limit == pytest.approx(0.31, abs=0.01)
    assert swing(hunting(1.3 * limit)).std() < 1e-6
    assert swing(hunting(0.8 * limit, GAP)).std() < 1e-2
    assert swing(hunting(1.15 * limit, GAP)).std() > 0.5


@pytest.mark.parametrize("kp", [0.36, 0.40, 0.45])
@pytest.mark.parametrize("speed", [10.0, 33.0])
def test_the_limit_cycle_has_the_frequency_of_harmonic_balance_at_any_speed(kp: float, speed: float) -> None:
    """Within 3 % of the describing function, which leaves harmonics out; the gain sets it, the speed does not.

    The second harmonic is missing: the gap is the same both ways (odd harmonics, handbook 2.6).
    """
    made = hunting(kp, GAP, speed=speed)
    lines = spectrum(made)
    frequency, _ = predicted(kp)
    found = float(np.argmax(lines)) / 4.0
    assert found == pytest.approx(frequency, rel=0.03)
    second, third = (lines[round(h * found * 4) - 8 : round(h * found * 4) + 9].max() for h in (2, 3))
    assert second < 0.1 * third


@pytest.mark.parametrize("gap", [1e-3, 4e-3])
def test_the_limit_cycle_is_as_large_as_the_gap_says(gap: float) -> None:
    """The swing of the twist in half gaps is where the dead zone leaves the predicted stiffness, within 10 %."""
    from scipy.optimize import brentq

    frequency, stiff = predicted(0.45)
    wide = brentq(lambda ratio: dead_zone(ratio) - stiff, 1.01, 100.0) * gap / 2
    made = hunting(0.45, Backlash(name="gap", gap=gap))
    spring = stiff * (STIFFNESS + DAMPING * 2j * pi * frequency)
    turned = (2 * pi * frequency) ** 2 * LOAD
    motor = wide / abs(1 - spring / (spring - turned))  # of the motor's angle, for that twist
    assert swing(made).std() * sqrt(2) == pytest.approx(2 * pi * frequency * motor, rel=0.10)
