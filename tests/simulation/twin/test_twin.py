"""The linear twin: names, agreement with the matrices and with the integrator for small signals, margins, crossings."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi, sqrt

import control
import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import InputError, UnknownNameError
from torquerig.mechanisms import Backlash, GearMesh, QuadraticDrag, StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Ground, Motor, Probe, SpeedController
from torquerig.rig.terms import AppliedTorque, BristleFriction, Sensing, Term
from torquerig.simulation.linear import spring_response
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.crossings import nearest_to
from torquerig.simulation.twin.friction_slope import dry_friction
from torquerig.simulation.twin.linear_twin import twin_of
from torquerig.simulation.twin.loop import sampled_loop
from torquerig.simulation.twin.margins import loop_gain
from torquerig.simulation.twin.system import LinearSystem, sampled


@dataclass(frozen=True)
class Small:
    """A sine that starts at 0.2 s."""

    frequency: float
    amplitude: float
    mean: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        time = np.arange(count) / rate - 0.2
        return np.where(time > 0, self.amplitude * np.sin(2 * pi * self.frequency * time), 0.0)


@dataclass(frozen=True, kw_only=True)
class Shaken(Part):
    """A torque from outside."""

    at: str
    process: Small

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=self.process),)


def rig(*effects: Part, kp: float = 0.05, ki: float = 0.5, speed_rpm: float = 800.0, gap: float = 0.0) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, viscous=1e-3, coulomb=0.02, torque_limit=5.0),
            Gear(name="gear", after="motor", ratio=4.0, stiffness=9e3, damping=2.0, output_inertia=6e-4,
                 efficiency=0.95, backlash=gap),
            Coupling(name="sensor", after="gear", stiffness=1100, damping=0.3, inertia=1e-4),
            Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02),
            SpeedController(name="controller", kp=kp, ki=ki),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )  # fmt: skip


def test_python_control_gets_names_for_all_inputs_outputs_and_states() -> None:
    twin = twin_of(rig(Shaken(name="shaker", at="wheel", process=Small(40.0, 0.1))))
    closed = twin.closed_loop.to_control()
    assert {"torque on motor", "applied shaker", "error of gear", "set-point of controller"} <= set(closed.input_labels)
    assert {"torque in sensor", "speed of motor", "angle of sensor"} <= set(closed.output_labels)
    assert closed.state_labels[-2:] == ["torque of controller", "integral of controller"]
    assert "command of controller" in twin.open_loop.to_control().input_labels
    assert twin.sampled_loop.to_control().dt == pytest.approx(4e-5)
    frequency = np.array([3.0, 37.0, 212.0])
    theirs = closed(2j * pi * frequency)[closed.output_labels.index("torque in sensor"), 0]
    assert twin.closed_loop.transfer("torque on motor", "torque in sensor", frequency) == pytest.approx(theirs)


def test_unknown_names_come_with_close_ones() -> None:
    with pytest.raises(UnknownNameError, match="torque in sensor"):
        twin_of(rig()).open_loop.output("torque in sensors")


def test_twin_without_losses_and_friction_is_that_of_the_matrices() -> None:
    plain = rig(speed_rpm=0.0)
    parts = tuple(
        replace(part, efficiency=1.0) if isinstance(part, Gear) else
        replace(part, coulomb=0.0) if isinstance(part, Motor) else part for part in plain.parts
    )  # fmt: skip
    twin = twin_of(replace(plain, parts=parts))
    frequency = np.array([2.0, 30.0, 150.0, 700.0])
    for closed, system in ((False, twin.open_loop), (True, twin.closed_loop)):
        expected = spring_response(twin.lowered, "sensor", frequency, speed_loop=closed)["gear"]
        assert system.transfer("torque on gear", "torque in sensor", frequency) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("frequency", [11.0, 90.0, 160.0])
def test_small_signal_run_of_the_integrator_agrees_with_the_twin(frequency: float) -> None:
    """0.02 N m on the wheel about the running rig, friction, drag and losses on: gain and phase within 2e-4."""
    effects = (
        QuadraticDrag(name="drag", at="wheel", coefficient=2e-3),
        StribeckFriction(name="dry", at="wheel", coulomb=0.3, static=0.5, stribeck_speed=15.0),
    )
    shaker = Shaken(name="shaker", at="wheel", process=Small(frequency, 0.02))
    shaken = rig(*effects, shaker, Probe(name="speed", quantity="speed", at="motor"))
    seconds = 1.2
    made = simulate(shaken, duration=seconds, seed=1, settling=1.0)
    time = made.time() + 1.0 - 0.2
    twin = twin_of(shaken)
    kept = time > time[-1] - round(0.5 * frequency) / frequency  # whole periods, long after the start
    angle = 2 * pi * frequency * time[kept]
    columns = np.column_stack([np.ones(angle.size), np.sin(angle), np.cos(angle)])
    for effect, channel in (("torque in sensor", "true_sensor_torque_Nm"), ("speed of motor", "speed_rad_s")):
        _, sine, cosine = np.linalg.lstsq(columns, made.channels[channel].values[kept], rcond=None)[0]
        expected = twin.sampled_loop.transfer("applied shaker", effect, np.array([frequency]))[0] * 0.02
        assert abs(complex(sine, cosine) - expected) < 2e-4 * abs(expected), effect


def test_operating_point_is_where_the_integrator_settles() -> None:
    loaded = rig(StribeckFriction(name="dry", at="wheel", coulomb=0.3, static=0.5, stribeck_speed=15.0))
    made = simulate(loaded, duration=0.1, seed=1, settling=2.0)
    point = twin_of(loaded).point
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(point.spring_torques[1], rel=1e-6)
    assert made.channels["true_motor_torque_Nm"].values[-1] == pytest.approx(point.drive_torque, rel=1e-6)


def test_a_loop_without_integrator_settles_below_its_set_point() -> None:
    loaded = rig(ki=0.0)
    made = simulate(loaded, duration=0.1, seed=1, settling=2.0)
    assert made.channels["true_motor_speed_rad_s"].values[-1] == pytest.approx(
        twin_of(loaded).point.speeds[0], rel=1e-7
    )


def test_friction_slope_is_the_derivative() -> None:
    numbers = {"grip": 0.3, "excess": 0.2, "inverse_stribeck": 0.5, "inverse_smoothing": 2.0}
    for speed in (-3.0, -0.2, 0.4, 1.7, 20.0):
        ahead, behind = (dry_friction(speed + step, **numbers)[0] for step in (1e-6, -1e-6))
        assert dry_friction(speed, **numbers)[1] == pytest.approx((ahead - behind) / 2e-6, abs=1e-8)


def test_what_is_left_out_is_said() -> None:
    told = " ".join(twin_of(rig(gap=1e-3)).point.left_out)
    assert "dry friction on 'motor'" in told
    assert "gap of 'gear', taken as closed" in told
    assert "torque limit" in told


def test_two_controllers_have_no_one_operating_point() -> None:
    two = rig(Motor(name="second", after="sensor", inertia=1e-4, torque_limit=1.0),
              SpeedController(name="other", motor="second", kp=0.01, ki=0.1))  # fmt: skip
    with pytest.raises(InputError, match="controller and other"):
        twin_of(two)


def test_sampled_system_with_straight_inputs_is_exact_for_a_ramp() -> None:
    """An integrator chain under a ramp: x = t^3/6 at every sample, whatever the period."""
    chain = LinearSystem(
        np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]]), np.eye(2), np.zeros((2, 1)), ("x", "v"), ("u",),
        ("x", "v"),
    )  # fmt: skip
    made = sampled(chain, 0.1)
    state = np.zeros(2)
    for step in range(30):
        assert (made.C @ state + made.D[:, 0] * step * 0.1)[0] == pytest.approx((step * 0.1) ** 3 / 6, abs=1e-12)
        state = made.A @ state + made.B[:, 0] * step * 0.1


def test_margins_are_those_of_python_control() -> None:
    """A sluggish loop with a finite gain margin: python-control's own search on the same sampled loop."""
    twin = twin_of(rig(kp=0.9, ki=30.0))
    (found,) = twin.margins()
    held = sampled(twin.open_loop, 1 / twin.rate, held=["command of controller"])
    small = held.only(inputs=["command of controller"], outputs=["speed of motor"]).to_control()
    z = control.tf([1, 0], [1, -1], 1 / twin.rate)
    loop = (0.9 + 30.0 / twin.rate * control.ss(z)) * small
    frequency = np.geomspace(1, 12_000, 20_000)
    theirs = control.FRD(loop(np.exp(2j * pi * frequency / twin.rate)), 2 * pi * frequency)
    gain, phase, modulus, _, _, _ = control.stability_margins(theirs)
    assert found.gain_margin == pytest.approx(gain, rel=1e-3)
    assert found.phase_margin == pytest.approx(phase, abs=0.05)
    assert found.modulus_margin == pytest.approx(modulus, rel=1e-3)


def test_gain_margin_is_where_the_loop_becomes_unstable() -> None:
    (found,) = twin_of(rig(kp=0.3, ki=3.0)).margins()
    assert found.gain_margin is not None
    for factor, stable in ((0.999 * found.gain_margin, True), (1.001 * found.gain_margin, False)):
        assert twin_of(rig(kp=0.3 * factor, ki=3.0 * factor)).stable is stable


def test_crossover_of_a_stiff_rig_is_kp_over_the_whole_inertia() -> None:
    """L = kp / (J s + c) well below the modes: 1 at sqrt(kp^2 - c^2) / (2 pi J), all of the rig at the motor."""
    (found,) = twin_of(rig(kp=0.02, ki=0.0)).margins()
    J, c = 1.5e-4 + 2.7e-3 / 16 / 0.95, 1e-3 + 0.02 / 16 / 0.95
    assert found.crossovers[0] == pytest.approx(sqrt(0.02**2 - c**2) / (2 * pi * J), rel=0.01)


def test_loop_gain_is_the_closed_loop_turned_inside_out() -> None:
    twin = twin_of(rig())
    frequency = np.array([5.0, 60.0, 400.0])
    gain = loop_gain(twin.open_loop, twin.lowered, rate=twin.rate)(frequency)
    tracking = sampled_loop(twin.open_loop, twin.lowered, rate=twin.rate).transfer(
        "set-point of controller", "speed of motor", frequency
    )
    assert tracking == pytest.approx(gain / (1 + gain), rel=1e-8)


def test_modes_are_told_by_who_turns_against_whom() -> None:
    first, second = twin_of(rig()).modes()
    assert "sensor + wheel against" in first.words or "against sensor + wheel" in first.words
    assert "twist in sensor" in first.words
    assert "twist in gear" in second.words


def test_crossing_stands_where_order_times_speed_is_the_mode() -> None:
    """Two masses on both springs in series: f = sqrt(k (1/J1 + 1/J2)) / 2 pi; order 6 meets it at 60 f / 6 rpm."""
    ripple = TorqueRipple(name="cogging", at="motor", group="cogging", amplitudes={6: 0.02, 12: 0.001})
    twin = twin_of(rig(ripple))
    found = twin.crossings(twin.order_lines(), top_speed=4000 * pi / 30)
    assert [one.torque for one in found] == sorted((one.torque for one in found), reverse=True)
    strongest = found[0]
    J1, J2, k = 16 * 1.5e-4 + 6e-4, 2.1e-3, 1 / (1 / 1100 + 1 / 9e3)
    assert strongest.frequency == pytest.approx(sqrt(k * (1 / J1 + 1 / J2)) / (2 * pi), rel=0.03)  # three masses
    assert (strongest.line.cause, strongest.line.order, strongest.mode) == ("cogging", 6, 1)
    assert strongest.speed_rpm == pytest.approx(60 * strongest.frequency / 6)
    gain = abs(twin.closed_loop.transfer("torque on motor", twin.sensor, np.array([strongest.frequency]))[0])
    assert strongest.torque == pytest.approx(0.02 * gain)
    assert nearest_to(strongest.speed * 1.01, found) is strongest


def test_mesh_lines_enter_as_error_and_kinematic_lines_without_amplitude() -> None:
    mesh = GearMesh(name="mesh", gear="gear", order_output=84, transmission_error=(1e-5,))
    (line,) = twin_of(rig(mesh)).order_lines()
    assert (line.order, line.enters, line.amplitude) == (21.0, "error of gear", 1e-5)


def test_gap_and_backlash_leave_the_modes_as_they_are() -> None:
    plain, gapped = (twin_of(one).modes() for one in (rig(), rig(Backlash(name="gap", gear="gear", gap=1e-3))))
    assert [mode.undamped for mode in gapped] == [mode.undamped for mode in plain]


@dataclass(frozen=True, kw_only=True)
class Bristles(Part):
    """LuGre friction on the wheel."""

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        friction = BristleFriction(
            name=self.name, on=rig.node("wheel"), stiffness=200.0, damping=0.5, coulomb_forward=0.3,
            coulomb_backward=0.4, static_forward=0.5, static_backward=0.6, stribeck=15.0, viscous=0.01,
        )  # fmt: skip
        return (friction,)


def test_sliding_bristles_settle_where_the_integrator_does() -> None:
    made = simulate(rig(Bristles(name="lugre")), duration=0.1, seed=1, settling=2.0)
    point = twin_of(rig(Bristles(name="lugre"))).point
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(point.spring_torques[1], rel=1e-5)


@dataclass(frozen=True, kw_only=True)
class SeenThrough(SpeedController):
    """A speed loop behind a filter of 1 ms."""

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        (drive,) = super().terms(rig)
        return (replace(drive, sensing=Sensing(filter_time=1e-3)),)


def test_a_speed_filter_costs_phase_margin_and_the_integrator_agrees() -> None:
    """At the crossover f filter and difference lag by atan(2 pi f 1 ms) and half a sample, 180 f T degrees."""
    parts = tuple(
        SeenThrough(name="controller", kp=0.05, ki=0.5) if isinstance(part, SpeedController) else part
        for part in rig().parts
    )
    through = replace(rig(), parts=parts)
    (plain,), (filtered,) = twin_of(rig(kp=0.02)).margins(), twin_of(with_gain(through, 0.02)).margins()
    at = plain.phase_at or 0.0
    lag = np.degrees(np.arctan(2 * pi * at * 1e-3)) + 180 * at * 4e-5
    assert plain.phase_margin is not None
    assert filtered.phase_margin == pytest.approx(plain.phase_margin - lag, abs=0.5)
    shaker = Shaken(name="shaker", at="wheel", process=Small(60.0, 0.02))
    made = simulate(through + shaker, duration=1.0, seed=1, settling=1.0)
    time = made.time() + 0.8
    kept = time > time[-1] - 0.5
    columns = np.column_stack([np.ones(kept.sum()), np.sin(2 * pi * 60 * time[kept]), np.cos(2 * pi * 60 * time[kept])])
    _, sine, cosine = np.linalg.lstsq(columns, made.channels["true_sensor_torque_Nm"].values[kept], rcond=None)[0]
    twin = twin_of(through + shaker)
    expected = twin.sampled_loop.transfer("applied shaker", twin.sensor, np.array([60.0]))[0] * 0.02
    assert abs(complex(sine, cosine) - expected) < 3e-4 * abs(expected)


def with_gain(through: Rig, kp: float) -> Rig:
    controller = through.part("controller")
    return through.changed(replace(controller, kp=kp))


def test_friction_on_a_locked_shaft_does_no_harm():
    held = (
        Motor(name="motor", inertia=1.5e-4, torque_limit=5.0),
        Gear(name="gear", after="motor", ratio=4.0, stiffness=9e3, damping=2.0, coulomb=5.0),
        Ground(name="wall", after="gear"),
    )
    (mode,) = twin_of(Rig(held, measured="gear")).modes()
    assert mode.undamped == pytest.approx(sqrt(9e3 / 16 / 1.5e-4) / (2 * pi), rel=1e-9)
