"""Mesh lines out of tooth counts: frequencies of handbook 4.2, sizes by the lever, and what planets cancel."""

from __future__ import annotations

from math import cos, pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.mechanisms import GearMesh, StribeckFriction, ToothMesh
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import KinematicError, StiffnessVariation, waves_of
from torquerig.rig.parts import Body, Coupling, Gear, ImposedMotion, Motor, SpeedController, TorqueSensor
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import twin_of

IN_PHASE, SEQUENTIAL = Planetary(21, 84, 3), Planetary(22, 62, 3)
LEVER = 0.5 * 1e-3 * cos(pi / 9)  # module 1 mm, per tooth


def geared(teeth: Planetary | Spur, *effects: Part, speed_rpm: float = 1000.0) -> Rig:
    gear = Gear(name="gearbox", after="motor", teeth=(teeth,), stiffness=11300, damping=2.0, output_inertia=7e-4)
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            gear,
            Coupling(name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5),
            Body(name="wear_part", after="sensor", inertia=2e-3),
            SpeedController(name="controller", kp=0.01, ki=0.1),  # a mesh in a damper brakes
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


def errors(teeth: Planetary | Spur, mesh: ToothMesh) -> dict[float, float]:
    """Angle error [rad] by output order."""
    return {wave.order: wave.amplitude for wave in waves_of(mesh.changes_in_host(geared(teeth, mesh)), KinematicError)}


def largest(made: Recording) -> float:
    """Frequency [Hz] of the largest line of the sensor."""
    values = made.torque() - made.torque().mean()
    return float(np.argmax(np.abs(np.fft.rfft(values * np.hanning(values.size)))) * made.sample_rate / values.size)


@pytest.mark.parametrize(("speed_rpm", "hertz"), [(1000.0, 280.0), (600.0, 168.0)])
def test_handbook_section_9_21_84_meshes_at_280_and_168_hz(speed_rpm: float, hertz: float) -> None:
    mesh = ToothMesh(name="mesh", module=1e-3, tooth_error=(5e-6,))
    made = simulate(geared(IN_PHASE, mesh, speed_rpm=speed_rpm), duration=1.0, seed=1)
    turned = made.channels["true_motor_speed_rad_s"].values.mean() / (speed_rpm * pi / 30)
    assert turned == pytest.approx(1.0, rel=1e-3)
    assert largest(made) == pytest.approx(hertz, abs=1.0)


def test_a_tooth_mesh_is_the_gear_mesh_of_the_error_that_its_lever_gives() -> None:
    """Sun and ring radii add up where the carrier is the output; the same bytes as the class it is a variant of."""
    mesh = ToothMesh(name="mesh", module=1e-3, tooth_error=(5e-6, 2e-6))
    plain = GearMesh(name="mesh", order_output=84, transmission_error=(5e-6 / (105 * LEVER), 2e-6 / (105 * LEVER)))
    first, second = (simulate(geared(IN_PHASE, one), duration=0.1, seed=1) for one in (mesh, plain))
    assert first.torque() == pytest.approx(second.torque(), rel=1e-9, abs=1e-12)
    assert errors(Spur(20, 50), mesh) == pytest.approx({50.0: 5e-6 / (50 * LEVER), 100.0: 2e-6 / (50 * LEVER)})
    assert errors(Planetary(21, 84, 3, fixed="carrier"), mesh)[84.0] == pytest.approx(5e-6 / (84 * LEVER))


@pytest.mark.parametrize(("teeth", "left"), [(IN_PHASE, {84, 168, 252}), (SEQUENTIAL, {186})])
def test_planets_cancel_harmonics_by_sun_teeth_over_planets(teeth: Planetary, left: set[int]) -> None:
    mesh = ToothMesh(name="mesh", module=1e-3, tooth_error=(5e-6, 5e-6, 5e-6))
    assert set(errors(teeth, mesh)) == left


def brute(teeth: Planetary, modulation: tuple[float, ...], shares: tuple[float, ...]) -> NDArray[np.float64]:
    """Amplitude by output order of what the planets, one after the other round the ring, make together."""
    theta = 2 * pi * np.arange(4096) / 4096
    total = np.zeros(4096)
    for k, share in enumerate(shares):
        place = theta + 2 * pi * k / len(shares)
        wave = sum(m * np.cos(s * place) for s, m in enumerate(modulation, start=1))
        total += share * (1 + wave) * np.cos(teeth.mesh_order_out * place)
    return 2 * np.abs(np.fft.rfft(total)) / 4096


@pytest.mark.parametrize("teeth", [IN_PHASE, SEQUENTIAL, Planetary(26, 78, 4)], ids=lambda teeth: teeth.spoken)
@pytest.mark.parametrize("unequal", [False, True])
def test_side_lines_are_those_of_planets_summed_one_by_one(teeth: Planetary, unequal: bool) -> None:
    """McFadden & Smith 1985: of equal planets only multiples of their number are left, whatever modulates them."""
    count = teeth.planets or 1
    shares = tuple(1 / count + (0.1 if k == 0 else -0.1 / (count - 1)) * unequal for k in range(count))
    mesh = ToothMesh(
        name="mesh", module=1e-3, tooth_error=(5e-6,), position_modulation=(0.3, 0.2, 0.1, 0.05),
        planet_shares=shares if unequal else (),
    )  # fmt: skip
    expected = brute(teeth, mesh.position_modulation, shares)
    found = {int(order): e * 1e6 / 5 * teeth.lever_teeth * LEVER for order, e in errors(teeth, mesh).items()}
    assert found == pytest.approx({int(o): expected[o] for o in np.flatnonzero(expected > 1e-9)}, abs=1e-9)
    assert unequal or all(order % count == 0 for order in found)


def test_an_eccentric_wheel_stands_at_its_turn_and_beside_the_mesh_line() -> None:
    """Phase modulation of cos(h z (theta + (off/r) sin theta)): first side lines h off/module, within its square."""
    mesh = ToothMesh(name="mesh", module=1e-3, tooth_error=(5e-6, 4e-6), pinion_eccentricity=3e-5,
                     wheel_eccentricity=2e-5)  # fmt: skip
    found = errors(Spur(20, 50), mesh)
    assert set(found) == {50, 100, 1, 2.5, 49, 51, 47.5, 52.5, 99, 101, 97.5, 102.5}
    assert found[1] == pytest.approx(2e-5 / (50 * LEVER))
    assert found[2.5] == pytest.approx(3e-5 / (50 * LEVER))
    theta = 2 * pi * np.arange(4096) / 4096
    for harmonic in (1, 2):
        shifted = np.cos(harmonic * 50 * (theta + 2e-5 / (0.5 * 50e-3 * 1) * np.sin(theta)))
        side = np.abs(np.fft.rfft(shifted))[harmonic * 50 + 1] * 2 / 4096
        assert found[harmonic * 50 + 1] / found[harmonic * 50] == pytest.approx(side, rel=2e-3)


@pytest.mark.parametrize("harmonic", [8])
@pytest.mark.parametrize("speed_rpm", [6000.0, 6030.0])
def test_a_mesh_harmonic_above_12_5_khz_comes_back_below_it_and_moves_backwards(
    harmonic: int, speed_rpm: float
) -> None:
    """Handbook 6.12: f_a = |f - 25 kHz|; 8 x 84 x 20 Hz = 13 440 Hz reads as 11 560 Hz, less when faster."""
    mesh = ToothMesh(name="mesh", module=1e-3, tooth_error=(*[0.0] * (harmonic - 1), 2e-6))
    rig = geared(IN_PHASE, mesh, speed_rpm=speed_rpm)
    sensor = TorqueSensor(
        name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5, bandwidth=10_000, converter_bits=24
    )
    made = simulate(rig.changed(sensor), duration=0.5, seed=1)
    output = made.channels["true_motor_speed_rad_s"].values.mean() / (2 * pi) / 5
    assert harmonic * 84 * output > 12_500
    assert largest(made) == pytest.approx(25_000 - harmonic * 84 * output, abs=2.0)


def lines_in(values: NDArray[np.float64], angle: NDArray[np.float64], harmonics: int) -> NDArray[np.float64]:
    """Amplitudes of the harmonics of an angle in ``values``."""
    waves = [np.ones(angle.size)] + [f(h * angle) for h in range(1, harmonics + 1) for f in (np.cos, np.sin)]
    window = np.hanning(angle.size)
    found = np.linalg.lstsq(np.column_stack(waves) * window[:, None], values * window, rcond=None)[0][1:]
    return np.hypot(found[::2], found[1::2])


def drag(torque: float) -> StribeckFriction:
    return StribeckFriction(name="drag", coulomb=torque, static=torque, stribeck_speed=1.0)


def turned(gear: Gear, *effects: Part, speed: float) -> Rig:
    """The gear between a motor that turns as it should, whatever that takes, and 2e-3 kg m^2."""
    motor = Motor(name="motor", inertia=1e-4, torque_limit=1.0)
    body = Body(name="wear_part", after="gearbox", inertia=2e-3)
    return Rig((motor, gear, body, ImposedMotion(name="turn"), *effects), Run(speed=speed), measured="gearbox")


@pytest.mark.parametrize("load", [1.0, 3.0])
def test_mesh_stiffness_makes_a_ripple_in_proportion_to_the_load(load: float) -> None:
    """k (1 + s cos(z theta)) under a mean torque T: to first order a torque pair s T, and -k' twist^2/2 on the output.

    Beside the linear twin: its transfers from a torque at the gear's two sides to the sensor, its line by name.
    """
    mesh = ToothMesh(name="mesh", module=1e-3, stiffness_variation=(0.04,))
    rig = geared(IN_PHASE, mesh, drag(load)).changed(SpeedController(name="controller", kp=0.02, ki=0.2))
    made = simulate(rig, duration=0.5, seed=1)
    frequency = 16.8 * made.channels["true_motor_speed_rad_s"].values.mean() / (2 * pi)
    response = spring_response(lower(rig, 1), "sensor", np.array([frequency]), speed_loop=True)
    out, motor = response["gearbox"][0], response["motor"][0]
    expected = 0.04 * load * abs(out - motor / 5 - 0.5j * 84 * load / 11300 * out)
    found = lines_in(made.torque(), 16.8 * made.channels["true_motor_angle_rad"].values, 1)
    assert found[0] == pytest.approx(expected, rel=0.01)
    (line,) = twin_of(rig).order_lines()
    assert (line.cause, line.order, line.enters) == ("mesh", pytest.approx(16.8), "error of gearbox")
    assert line.amplitude == pytest.approx(0.04 * load / 11300, rel=1e-6)


@pytest.mark.full
def test_a_slow_mesh_twists_as_one_over_its_stiffness() -> None:
    """T/K 1/(1 + s cos x) = T/K / sqrt(1 - s^2) (1 + 2 sum (-r)^h cos h x), r = (1 - sqrt(1 - s^2))/s: not s T/K alone.

    One harmonic of stiffness has a row of lines; to first order there would be one.
    """
    load, share = 0.3, 0.5
    mesh = ToothMesh(name="mesh", module=1e-3, stiffness_variation=(share,))
    gear = Gear(name="gearbox", after="motor", teeth=(IN_PHASE,), stiffness=11300, damping=0.5)
    speed = 20 * pi / 30
    rig = turned(gear, mesh, drag(load), speed=speed)
    made = simulate(rig, duration=2.0, seed=1, settling=0.5, sample_rate=10_000)
    rate = speed / 5 - made.channels["true_output_speed_rad_s"].values
    found = lines_in(rate, 16.8 * made.channels["true_motor_angle_rad"].values, 4)
    root, harmonic = np.sqrt(1 - share**2), np.arange(1, 5)
    twists = load / 11300 / root * 2 * ((1 - root) / share) ** harmonic
    # inertia lifts the fourth by (4 z w / w0)^2 = 0.4 %
    assert found == pytest.approx(harmonic * 84 * speed / 5 * twists, rel=0.01)


@pytest.mark.parametrize(("off", "variation"), [(1.0, 0.3), (1.0, 0.06), (1.3, 0.3)], ids=["in", "small", "beside"])
def test_a_mesh_at_twice_a_mode_drives_itself(off: float, variation: float) -> None:
    """J x'' + c x' + k (1 + s cos 2 w t) x: grows by s w/4 - c/2J where s > 2 c/(J w), and not beside the resonance.

    Nayfeh & Mook 1979, Nonlinear Oscillations, 5.3; its tongue is 2 w (1 +- s/4).
    """
    damping, mode = 0.4, np.sqrt(11300 / 2e-3)
    gear = Gear(name="gearbox", after="motor", teeth=(IN_PHASE,), stiffness=11300, damping=damping)
    mesh = ToothMesh(name="mesh", module=1e-3, stiffness_variation=(variation,))
    speed = off * 5 * 2 * mode / 84
    made = simulate(turned(gear, mesh, drag(1e-3), speed=speed), duration=0.1, seed=1, settling=0.0, substeps=4)
    time, swing = made.time(), np.abs(made.torque() - 1e-3)
    early, late = (swing[(time > t) & (time < t + 0.02)].max() for t in (0.04, 0.08))
    expected = variation * mode / 4 - damping / (2 * 2e-3)
    if off == 1.0 and expected > 0:
        assert np.log(late / early) / 0.04 == pytest.approx(expected, rel=0.03)
    else:
        assert late < 1.5 * variation * 1e-3  # what the load alone makes of it, s T


def test_planets_cancel_the_stiffness_variation_as_they_cancel_the_error() -> None:
    mesh = ToothMesh(name="mesh", module=1e-3, stiffness_variation=(0.04, 0.02, 0.01))
    rig = geared(SEQUENTIAL, mesh)
    assert {
        wave.order: wave.amplitude for wave in waves_of(mesh.changes_in_host(rig), StiffnessVariation)
    } == pytest.approx({186: 0.01})
    assert rig.changes_in("sensor") == ()


@pytest.mark.parametrize(
    ("teeth", "mesh", "told"),
    [
        (IN_PHASE, ToothMesh(name="it", module=1e-3, wheel_eccentricity=1e-5), "needs a fixed-axis pair"),
        (IN_PHASE, ToothMesh(name="it", module=1e-3, planet_shares=(0.5, 0.5)), "write one per planet of gearbox"),
        (Spur(20, 50), ToothMesh(name="it", module=1e-3, planet_shares=(1.0,)), "has no planets"),
        (IN_PHASE, ToothMesh(name="it", gear="sensor", module=1e-3), "'sensor' is no gear"),
    ],
    ids=["eccentric planetary", "two shares", "no planets", "no gear"],
)
def test_a_mesh_that_its_gear_cannot_have_is_refused(teeth: Planetary | Spur, mesh: ToothMesh, told: str) -> None:
    with pytest.raises(InputError, match=told):
        geared(teeth, mesh).terms()


def test_a_gear_without_teeth_has_no_tooth_mesh() -> None:
    rig = geared(IN_PHASE, ToothMesh(name="it", module=1e-3, tooth_error=(1e-6,)))
    bare = Gear(name="gearbox", after="motor", ratio=5, stiffness=11300, damping=2.0, output_inertia=7e-4)
    with pytest.raises(InputError, match=r"gearbox states no teeth, .* write teeth of one stage"):
        rig.changed(bare).terms()
