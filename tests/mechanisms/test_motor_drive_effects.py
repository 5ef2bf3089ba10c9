"""Effects of motor phases and inverter: nothing at zero size, their orders at two speeds, sizes of the phase level."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from pydantic import TypeAdapter

from torquerig.document import parse_document, validated
from torquerig.errors import InputError
from torquerig.machines.permanent_magnet import PHASE_LAG, PermanentMagnetMachine
from torquerig.machines.ripple_orders import RippleOrders, ripple_orders
from torquerig.mechanisms import (
    BackEmfHarmonics,
    Cogging,
    DeadTime,
    EncoderError,
    FieldOrientedControl,
    HallMisplacement,
    PhaseUnbalance,
    PwmRipple,
    SixStepCommutation,
)
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, EncoderAngleError, waves_of
from torquerig.rig.parts import (
    Body,
    Coupling,
    Gear,
    Motor,
    MotorEncoder,
    MotorPhases,
    SpeedController,
    TorqueController,
)
from torquerig.rig.steady import steady_torque
from torquerig.rig.terms import HarmonicTorque, Wave
from torquerig.scenario.reading import KINDS
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import twin_of

SPEEDS = pytest.mark.parametrize("speed_rpm", [600.0, 930.0])
PHASES = MotorPhases(
    name="phases",
    pole_pairs=7,
    phase_resistance=0.2,
    phase_inductance=0.3e-3,
    flux_linkage=0.01,
    dc_link=48.0,
    current_loop_bandwidth=1000.0,
)

WRITTEN: dict[str, tuple[str, Part]] = {
    "BackEmfHarmonics": (
        "{kind: back_emf_harmonics, shares: {5: 0.04, 7: -1.0 %}}",
        BackEmfHarmonics(name="it", shares={5: 0.04, 7: -0.01}),
    ),
    "DeadTime": ("{kind: dead_time, dead_time: 1 us}", DeadTime(name="it", dead_time=1e-6)),
    "EncoderError": (
        "{kind: encoder_error, amplitudes: {1: 1.0e-3 rad}, phases: {1: 0.5}}",
        EncoderError(name="it", amplitudes={1: 1e-3}, phases={1: 0.5}),
    ),
    "FieldOrientedControl": (
        "{kind: field_oriented_control, dead_time: 1 us, current_offset: [10 mA, 0 A]}",
        FieldOrientedControl(name="it", dead_time=1e-6, current_offset=(0.01, 0.0)),
    ),
    "HallMisplacement": (
        "{kind: hall_misplacement, shift: [0.05 rad, 0 rad, 0 rad]}",
        HallMisplacement(name="it", shift=(0.05, 0.0, 0.0)),
    ),
    "PhaseUnbalance": (
        "{kind: phase_unbalance, extra_resistance: [20 mohm, 0 ohm, 0 ohm]}",
        PhaseUnbalance(name="it", extra_resistance=(0.02, 0.0, 0.0)),
    ),
    "PwmRipple": ("{kind: pwm_ripple, switching_frequency: 20 kHz}", PwmRipple(name="it", switching_frequency=20e3)),
    "SixStepCommutation": ("{kind: six_step_commutation}", SixStepCommutation(name="it")),
}
NOTHING: tuple[Part, ...] = (
    BackEmfHarmonics(name="it", shares={5: 0.0, 7: 0.0}),
    BackEmfHarmonics(name="it", shares={5: 0.02, 7: 0.02}),  # |e7 - e5|
    DeadTime(name="it", dead_time=0.0),
    EncoderError(name="it", amplitudes={1: 0.0}),
    FieldOrientedControl(name="it"),  # a sinusoidal machine without errors: no 6p unless it emerges
    HallMisplacement(name="it"),
    PhaseUnbalance(name="it"),
)


def driven(*effects: Part, speed_rpm: float, kp: float = 0.05, ki: float = 0.5, phases: MotorPhases = PHASES) -> Rig:
    """5:1 with a viscous load of 1 N m at 930 rpm of the motor."""
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0, current_loop_bandwidth=1000.0, pole_pairs=7),
            phases,
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=11300, damping=2.0, output_inertia=7e-4),
            Coupling(name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5),
            Coupling(name="coupling", after="sensor", stiffness=6500, damping=0.4),
            Body(name="wear_part", after="coupling", inertia=2e-3, viscous=1.0 / (930 * pi / 150)),
            SpeedController(name="controller", kp=kp, ki=ki),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


def lines(made: Recording, *motor_orders: float) -> list[complex]:
    """Lines of the sensor at motor orders, fitted together on the true angle [N m], as ``A exp(j phase)``."""
    angle = made.channels["true_motor_angle_rad"].values
    columns = [np.ones(angle.size), np.linspace(-1, 1, angle.size)]
    for order in motor_orders:
        columns += [np.cos(order * angle), np.sin(order * angle)]
    values = made.channels["true_sensor_torque_Nm"].values
    found = np.linalg.lstsq(np.column_stack(columns), values, rcond=None)[0][2:]
    return [complex(c, -s) for c, s in zip(found[::2], found[1::2], strict=True)]


def gain(rig: Rig, order: float) -> float:
    """The sensor's torque per torque on the rotor at a motor order of the set-point, speed loop closed."""
    frequency = np.array([order * (rig.run.speed or 0.0) / (2 * pi)])
    return float(abs(spring_response(lower(rig, 1), "sensor", frequency, speed_loop=True)["motor"][0]))


def waves(effect: Part, rig: Rig) -> dict[float, complex]:
    """All that an effect does to the torque of the rotor at the set-point, as a share of its mean torque."""
    torque = steady_torque(rig, "motor")
    found: dict[float, complex] = {}

    def add(wave: Wave, share: float) -> None:
        found[wave.order] = found.get(wave.order, 0) + share * wave.amplitude * np.exp(1j * (wave.phase or 0.0))

    for wave in waves_of(effect.changes_in_host(rig), DriveRipple):
        add(wave, 1.0)
    for term in effect.terms(rig):
        assert isinstance(term, HarmonicTorque)
        for wave in term.waves:
            add(wave, 1 / torque)
    for wave in waves_of(effect.changes_in_host(rig), EncoderAngleError):
        add(replace(wave, amplitude=wave.amplitude * answered(rig, wave.order)), 1 / torque)
    return found


def answered(rig: Rig, order: float) -> float:
    """signatures.md 2.5: what the PI behind its current loop answers to an angle error, K_p k w and more [N m/rad]."""
    motor, s = rig.part("motor"), 1j * order * (rig.run.speed or 0.0)
    assert isinstance(motor, Motor)
    loops = [loop.kp * s + loop.ki for loop in rig.parts_of(SpeedController)]
    return float(abs(sum(loops) / (1 + s / (2 * pi * motor.current_loop_bandwidth))))


def at_its_speed(rig: Rig, made: Recording) -> Rig:
    """The rig with the speed that it reached as its set-point: a proportional loop stays below its own."""
    return rig.at(replace(rig.run, speed=made.channels["true_motor_speed_rad_s"].values.mean()))


def as_run(rig: Rig, control: Any, machine: PermanentMagnetMachine, torque: float | None = None) -> RippleOrders:
    """The phase-level run at the rig's set-point."""
    torque = steady_torque(rig, "motor") if torque is None else torque
    return ripple_orders(machine, control, speed=rig.run.speed or 0.0, torque=torque)


def line_of(found: RippleOrders, order: int) -> complex:
    """One line of a phase-level run, as a share of its mean."""
    return next(line.depth * complex(np.exp(1j * line.phase)) for line in found.lines if line.order_motor == order)


@pytest.mark.parametrize("name", sorted(WRITTEN))
def test_each_kind_reads_back_from_yaml_under_its_own_word(name: str) -> None:
    text, meant = WRITTEN[name]
    document = parse_document(text, Path("scenario.yaml"))
    word = get_args(get_type_hints(type(meant))["kind"])[0]
    assert document.data["kind"] == word == meant.kind
    adapter: TypeAdapter[Any] = TypeAdapter(KINDS[word])
    assert validated(document, adapter, data={"name": "it", **document.data}) == meant
    with pytest.raises(InputError, match="unknown key"):
        validated(document, adapter, data={"name": "it", **document.data, "amplitued": 1})


@pytest.mark.parametrize("effect", NOTHING, ids=lambda effect: effect.kind)
def test_an_effect_of_zero_size_changes_nothing_bit_for_bit(effect: Part) -> None:
    plain, with_it = (
        simulate(driven(*effects, speed_rpm=600.0), duration=0.05, seed=5, settling=0.1) for effects in ((), (effect,))
    )
    for channel, values in plain.channels.items():
        assert np.array_equal(values.values, with_it.channels[channel].values), channel


@pytest.mark.parametrize("name", [*sorted(set(WRITTEN) - {"PwmRipple"})])
def test_an_effect_without_a_motor_or_its_phases_is_refused(name: str) -> None:
    effect = WRITTEN[name][1]
    rig = driven(effect, speed_rpm=600.0).without("phases")
    if name == "EncoderError":
        assert waves_of(effect.changes_in_host(rig), EncoderAngleError)  # needs no phases, only the loop
        return
    with pytest.raises(InputError, match="add a part of kind motor_phases"):
        effect.terms(rig)


EXPECTED: dict[str, tuple[Part, tuple[int, ...]]] = {
    "six_step": (SixStepCommutation(name="it"), (42, 84, 126)),
    "hall_shift": (HallMisplacement(name="it", shift=(0.1, -0.05, 0.0)), (14, 28)),
    "hall_width": (HallMisplacement(name="it", width=(0.15, 0.0, 0.0)), (7, 14, 21)),
    "dead_time": (DeadTime(name="it", dead_time=1e-6), (42, 84)),
    "back_emf": (BackEmfHarmonics(name="it", shares={5: 0.04, 7: 0.01, 11: 0.01}), (42, 84)),
    "unbalance": (PhaseUnbalance(name="it", extra_resistance=(0.05, 0.0, 0.0)), (14,)),
    "encoder_once": (EncoderError(name="it", amplitudes={1: 0.005}), (1,)),
    "encoder_twice": (EncoderError(name="it", amplitudes={2: 0.005}), (2,)),
    "offset": (FieldOrientedControl(name="it", current_offset=(0.02, 0.0)), (7,)),
    "gain": (FieldOrientedControl(name="it", current_gain=(0.02, -0.02)), (14,)),
    "foc_dead_time": (FieldOrientedControl(name="it", dead_time=1e-6), (42,)),
    "cogging": (
        Cogging(name="it", slots=12, pole_pairs=7, native=0.01, unequal_magnets=0.01, unequal_teeth=0.01),
        (12, 14, 84),
    ),
}


@pytest.mark.long
@SPEEDS
@pytest.mark.parametrize("name", sorted(EXPECTED))
def test_lines_stand_at_the_handbook_s_orders(name: str, speed_rpm: float) -> None:
    """signatures.md 1.1 to 2.5: at its orders the sensor reads far more than beside them, at both speeds.

    The sizes are those of the effect times the linear twin's transfer, within 3 % (the sampled loop is taken as
    continuous there, and the shaft's own swinging moves the angle under the lines); cogging draws its phases.
    """
    effect, orders = EXPECTED[name]
    rig = driven(effect, speed_rpm=speed_rpm)
    made = simulate(rig, duration=1.0, seed=3)
    beside = tuple(order + side for order in orders for side in (-0.4, 0.4))
    found = np.abs(lines(made, *orders, *beside))
    assert (found[: len(orders)] > 20 * found[len(orders) :].reshape(-1, 2).max(axis=1)).all()
    if isinstance(effect, EncoderError):
        rig = at_its_speed(rig, made)
    sizes, torque = waves(effect, rig), steady_torque(rig, "motor")
    expected = [abs(sizes[order]) * torque * gain(rig, order) for order in orders]
    assert found[: len(orders)] == pytest.approx(expected, rel=0.03, abs=3e-3 * max(expected))


@SPEEDS
@pytest.mark.parametrize("k", [1, 2])
def test_dead_time_s_closed_form_is_what_the_phases_make_of_it(speed_rpm: float, k: int) -> None:
    """No harmonic in the input on either side. Size within 5 % and phase within 0.15 rad at 6p, twice that at 12p."""
    rig = driven(DeadTime(name="it", dead_time=1e-6), speed_rpm=speed_rpm / 4)
    run = as_run(rig, PHASES.field_oriented(dead_time=1e-6), PHASES.machine(), torque=3.0)
    expected = waves(rig.part("it"), rig)[42.0 * k] * steady_torque(rig, "motor") / 3.0
    assert abs(expected) > 3e-4
    assert abs(line_of(run, 42 * k) - expected) < 0.15 * k * abs(expected)


@pytest.mark.long
@SPEEDS
@pytest.mark.parametrize("shares", [{5: 0.04, 7: 0.015}, {5: -0.01, 7: 0.03, 11: 0.01}])
def test_back_emf_harmonics_are_what_the_phases_make_of_them(speed_rpm: float, shares: dict[int, float]) -> None:
    """Load and loop together, in size and phase: within 5 % of the static share while the loop is fast."""
    rig = driven(BackEmfHarmonics(name="it", shares=shares), speed_rpm=speed_rpm / 10)
    stated = replace(PHASES, emf_harmonics=shares)
    run = as_run(rig, stated.field_oriented(), stated.machine())
    for order, expected in waves(rig.part("it"), rig).items():
        assert abs(line_of(run, int(order)) - expected) < 0.05 * abs(shares.get(7, 0.0) - shares[5])


def test_back_emf_harmonics_of_equal_fifth_and_seventh_cancel_simulators_6_4() -> None:
    assert BackEmfHarmonics(name="it", shares={5: 0.04, 7: 0.015}).differences() == {6: pytest.approx(-0.025)}
    assert BackEmfHarmonics(name="it", shares={5: 0.02, 7: 0.02, 13: 0.01}).differences() == {12: 0.01}


@SPEEDS
def test_unequal_resistances_are_what_the_phases_make_of_them(speed_rpm: float) -> None:
    """Order 2p of the phase-level machine with the same three resistances, in size and phase within 6 %."""
    extra = (0.02, 0.0, -0.01)
    rig = driven(PhaseUnbalance(name="it", extra_resistance=extra), speed_rpm=speed_rpm / 3)
    share = tuple(ohms / PHASES.phase_resistance for ohms in extra)
    run = as_run(rig, PHASES.field_oriented(), PHASES.machine(resistance_unbalance=share))
    expected = waves(rig.part("it"), rig)[14.0]
    assert abs(line_of(run, 14) - expected) < 0.06 * abs(expected)
    assert {line.order_motor for line in run.above(3e-5)} == {14}


def test_extra_inductance_is_the_negative_sequence_of_its_drop() -> None:
    """Against the drops themselves, ``v_x = dL_x d/dt i_x``, projected on the axis of the torque over one turn."""
    extra = (0.0, 1e-5, 3e-5)
    rig = driven(PhaseUnbalance(name="it", extra_inductance=extra), speed_rpm=600.0)
    electrical = 7 * 600.0 * pi / 30
    angle = np.arange(64) / 64 * 2 * pi
    shapes = np.sin(angle[:, None] - PHASE_LAG)
    drops = electrical * np.array(extra) * np.cos(angle[:, None] - PHASE_LAG)  # of one ampere
    against = -2 / 3 * (shapes * drops).sum(axis=1)  # volts on the axis of the torque
    second = 2 * np.fft.fft(against)[2] / 64
    expected = waves(rig.part("it"), rig)[14.0]
    assert expected == pytest.approx(second * PHASES.admittance(electrical / pi), rel=1e-9)


def test_equal_extras_of_all_phases_make_no_line() -> None:
    rig = driven(PhaseUnbalance(name="it", extra_resistance=(0.1, 0.1, 0.1)), speed_rpm=600.0)
    (wave,) = waves_of(rig.part("it").changes_in_host(rig), DriveRipple) or (Wave(order=14.0, amplitude=0.0),)
    assert wave.amplitude < 1e-12


def test_equal_shift_of_all_halls_keeps_the_sectors_equal_and_unequal_ones_do_not() -> None:
    """signatures.md 1.5: an equal shift changes 6p only; unequal shifts bring 2p and 4p, unequal widths p and 3p."""
    shifts = {
        "equal": HallMisplacement(name="it", shift=(0.15, 0.15, 0.15)),
        "unequal": HallMisplacement(name="it", shift=(0.15, 0.0, -0.1)),
        "wide": HallMisplacement(name="it", width=(0.15, 0.0, 0.0)),
    }
    orders = {}
    for name, effect in shifts.items():
        found = waves(effect, driven(effect, speed_rpm=600.0))
        orders[name] = {order for order, line in found.items() if abs(line) > 1.5e-3}
    assert 42.0 in orders["equal"]
    assert {order % 42 for order in orders["equal"]} == {0.0}
    assert {14.0, 28.0} <= orders["unequal"]
    assert {order % 14 for order in orders["unequal"]} == {0.0}
    assert {7.0, 14.0, 21.0} <= orders["wide"]


def test_six_step_and_misplaced_halls_together_are_the_misplaced_machine() -> None:
    both = SixStepCommutation(name="six"), HallMisplacement(name="it", shift=(0.1, 0.0, 0.0))
    rig = driven(*both, speed_rpm=600.0)
    together: dict[float, complex] = {}
    for effect in both:
        for order, line in waves(effect, rig).items():
            together[order] = together.get(order, 0) + line
    rounded = driven(*both, speed_rpm=600.0)
    run = ripple_orders(
        PHASES.machine(),
        PHASES.six_step(hall_shift=(0.1, 0.0, 0.0)),
        speed=float(f"{rounded.run.speed:.4g}"),
        torque=float(f"{steady_torque(rounded, 'motor'):.3g}"),
    )
    for order in (14, 28, 42, 84):
        assert together[float(order)] == pytest.approx(line_of(run, order), abs=2e-5)


@pytest.mark.parametrize("ki", [0.0, 0.5])
def test_encoder_error_grows_with_speed_and_gain(ki: float) -> None:
    """K_p a_k k w_m (signatures.md 2.5) behind the loop's own transfer; the error alone is given, not its line."""
    error, found = EncoderError(name="it", amplitudes={2: 1e-3}), []
    for rpm, kp in ((600.0, 0.05), (300.0, 0.05), (600.0, 0.025)):
        rig = driven(error, speed_rpm=rpm, kp=kp, ki=ki * kp)
        assert not any(isinstance(term, HarmonicTorque) for term in rig.terms())
        made = simulate(rig, duration=0.5, seed=3, settling=1.0)
        reached = at_its_speed(rig, made)
        line = abs(lines(made, 2.0)[0]) / gain(reached, 2.0)
        assert line == pytest.approx(1e-3 * answered(reached, 2.0), rel=0.02)
        found.append(line / (1e-3 * 2 * (reached.run.speed or 0.0)))
    assert found == pytest.approx([0.05, 0.05, 0.025], rel=0.03)


def test_without_a_speed_loop_an_encoder_error_has_only_the_lines_of_the_current_vector() -> None:
    """``cos(p e)``: about p^2 a e0 at k and (p a)^2 / 4 at 2k; both lines are gone where no pole pairs are known."""
    error = EncoderError(name="it", amplitudes={1: 0.02}, offset=0.01)
    rig = driven(error, speed_rpm=600.0).without("controller").without("phases")
    torque = steady_torque(rig, "motor")
    rig += TorqueController(name="controller", torque=torque)
    found = np.abs(lines(simulate(rig, duration=1.0, seed=3), 1.0, 2.0))
    assert found == pytest.approx([torque * abs(waves(error, rig)[k]) * gain(rig, k) for k in (1.0, 2.0)], rel=0.03)
    motor = rig.part("motor")
    assert isinstance(motor, Motor)
    unknown = rig.changed(replace(motor, pole_pairs=None))
    bare, with_it = (simulate(one, duration=0.1, seed=3, settling=0.5) for one in (unknown.without("it"), unknown))
    assert np.array_equal(bare.torque(), with_it.torque())


def test_the_twin_knows_the_line_of_an_encoder_error_by_what_the_loop_answers() -> None:
    rig = driven(EncoderError(name="it", amplitudes={2: 1e-3}), speed_rpm=600.0).without("phases")
    motor = rig.part("motor")
    assert isinstance(motor, Motor)
    twin = twin_of(rig.changed(replace(motor, pole_pairs=None)))
    (line,) = twin.order_lines()
    assert (line.order, line.enters) == (2.0, "demand of controller")
    passed = twin.closed_loop.transfer(line.enters, "torque in sensor", np.array([20.0]))[0]
    reached = rig.at(replace(rig.run, speed=twin.motor_speed_rpm * pi / 30))
    expected = 1e-3 * answered(reached, 2.0) * gain(reached, 2.0)
    assert (line.amplitude or 0.0) * abs(passed) == pytest.approx(expected, rel=0.01)
    assert any("error of the encoder" in told for told in twin.point.left_out)


@pytest.mark.parametrize("controller", ["", "controller"])
def test_one_encoder_errs_once_and_its_counts_show_it(controller: str) -> None:
    error = EncoderError(name="wobble", amplitudes={2: 1e-3}, phases={2: 0.4})
    counting = MotorEncoder(name="encoder", counts_per_rev=1_000_000, controller=controller)
    made = simulate(driven(error, counting, speed_rpm=600.0), duration=0.3, seed=3, settling=0.5)
    angle = made.channels["true_motor_angle_rad"].values
    counted = made.channels["encoder_count"].in_si()
    assert counted == pytest.approx(angle + 1e-3 * np.sin(2 * angle + 0.4), abs=2 * pi / 1_000_000)
    twice = replace(counting, angle_error={1.0: 1e-3})
    with pytest.raises(InputError, match=r"wobble: encoder has an angle_error already.*'motor' would err twice"):
        driven(error, twice, speed_rpm=600.0).terms()


def test_a_misplaced_current_vector_leaves_the_cosine_by_bessel_functions() -> None:
    """cos(z sin x) = J0 + 2 sum J_2n cos 2nx (Abramowitz & Stegun 9.1.42), z = p a; J2(0.5)/J0(0.5) = 0.0305."""
    from scipy.special import jv

    error = EncoderError(name="it", amplitudes={1: 0.5 / 7})
    found = {w.order: w.amplitude for w in waves_of(error.changes_in_host(driven(error, speed_rpm=600.0)), DriveRipple)}
    assert found == pytest.approx({2.0 * n: 2 * abs(jv(2 * n, 0.5) / jv(0, 0.5)) for n in (1, 2, 3)}, rel=1e-3)


def test_pwm_ripple_is_nothing_at_the_sensor() -> None:
    """signatures.md 2.7: mechanically negligible. 10 mN m on the rotor, a ten-thousandth of it at the sensor."""
    effect = PwmRipple(name="it", switching_frequency=20e3)
    rig = driven(effect, speed_rpm=600.0)
    assert effect.motor_torque(rig) == pytest.approx(1.5 * 7 * 0.01 * 48 / (8 * 0.3e-3 * 20e3))
    assert effect.sensor_torque(rig) < 1e-4 * effect.motor_torque(rig)
    direct = spring_response(lower(rig, 1), "sensor", np.array([20e3]))["motor"][0]
    assert effect.sensor_torque(rig) == pytest.approx(abs(direct) * effect.motor_torque(rig), rel=1e-9)


def test_pwm_ripple_folds_into_the_samples() -> None:
    """20 kHz in samples of 25 kHz stands at 5 kHz, with the size that the shafts leave of it."""
    effect = PwmRipple(name="it", switching_frequency=20e3)
    plain, with_it = (
        simulate(driven(*effects, speed_rpm=600.0), duration=0.2, seed=5, settling=0.1) for effects in ((), (effect,))
    )
    added = with_it.torque() - plain.torque()
    spectrum = 2 * np.abs(np.fft.rfft(added)) / added.size
    assert int(np.argmax(spectrum)) == round(5000 * 0.2)
    assert spectrum.max() == pytest.approx(effect.sensor_torque(driven(speed_rpm=600.0)), rel=1e-6)
