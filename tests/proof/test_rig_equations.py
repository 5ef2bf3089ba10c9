"""The integrated rig against closed forms: balance of torque, modes, lines, and one integrator against another."""

from dataclasses import replace

import numpy as np
import pytest

from proof.rig_program import nominal
from proof.rig_program.effects.gear_mesh import GearMesh
from proof.rig_program.effects.quadratic_drag import QuadraticDrag
from proof.rig_program.effects.stribeck_friction import StribeckFriction
from proof.rig_program.effects.torsional_mode import TorsionalMode
from proof.rig_program.forcing import NO_LIMIT, Forcing
from proof.rig_program.laws import SAME_LAWS, Friction, Integrator
from proof.rig_program.machine import MOTOR, WEAR, machine_of
from proof.rig_program.plan import Profile, Run
from proof.rig_program.recording import move
from proof.rig_program.transfer import gain_of, gain_of_twist, mode_frequencies, to_sensor
from proof.rig_program.true_rig import draw_true_rig
from proof.rig_program.waves import MOTOR_POINTS, OUTPUT_POINTS, slope_of, sum_of

RUN = Run(1000.0, Profile.STEADY, 5.0)
NOMINAL = draw_true_rig(np.random.default_rng(0), spread=0.0)
SMOOTH = machine_of(NOMINAL, SAME_LAWS)._replace(motor_table=np.zeros(1), wear_table=np.zeros(1))
RNG = np.random.default_rng(1)


def steady(samples, *, speed=RUN.motor_speed, load=1.0, push=None):
    nothing = np.zeros(samples)
    return Forcing(
        np.full(samples, speed), np.full(samples, load), nothing if push is None else push,
        np.full(samples, NO_LIMIT), nothing,
    )  # fmt: skip


def amplitude(values, frequency):
    time = np.arange(values.size) / nominal.SAMPLE_RATE
    window = np.hanning(values.size)
    return 2.0 * abs(np.sum(values * window * np.exp(-2j * np.pi * frequency * time))) / window.sum()


@pytest.mark.parametrize("friction", list(Friction))
@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_the_steady_reading_is_what_the_wear_part_asks_for(friction, direction):
    drag, coulomb, speed = 5.0e-4, 0.2, RUN.motor_speed / nominal.RATIO
    machine = QuadraticDrag(drag).on_machine(SMOOTH, RUN, RNG)
    machine = StribeckFriction((coulomb, 0.5, 1.0), (coulomb, 0.5, 1.0)).on_machine(machine, RUN, RNG)
    laws = replace(SAME_LAWS, friction=friction, friction_width=0.02)
    machine = machine._replace(friction=int(friction), friction_width=0.02)
    moved = move(machine, steady(25000, speed=direction * RUN.motor_speed), laws)
    expected = direction * (1.0 + coulomb + NOMINAL["wear_viscous"] * speed + drag * speed**2)
    assert moved[-1, 0] == pytest.approx(expected, abs=1e-6)
    assert moved[-1, 2] == pytest.approx(direction * speed, rel=1e-6)


def test_the_motor_pays_for_the_gears_losses():
    # what the controller holds at steady speed: reading over ratio and efficiency, and the motor's own friction
    from proof.rig_program.kernel import run_machine
    from proof.rig_program.recording import turning_start
    from proof.rig_program.stepping import rule_of

    forcing = steady(50000)
    state = turning_start(SMOOTH, forcing, start_angle=0.0)
    inputs = (forcing.set_point, forcing.load, forcing.push, forcing.coupling_limit, forcing.line_phase)
    moved = run_machine(SMOOTH, state, inputs, rule_of(Integrator.MIDPOINT), 6, nominal.SAMPLE_RATE)
    own = NOMINAL["motor_viscous"] * RUN.motor_speed + NOMINAL["motor_coulomb"]
    assert state[12] == pytest.approx(moved[-1, 0] / nominal.RATIO / nominal.EFFICIENCY + own, rel=1e-5)


def test_the_first_mode_is_that_of_two_masses_on_springs_in_a_row():
    # light gear and sensor masses moved to the ends they hang on: 2 pi f = sqrt(k (1/J1 + 1/J2)), good to 3 %
    motor, gear, wear = NOMINAL["rotor_inertia"] * 25.0, NOMINAL["gear_inertia"], NOMINAL["wear_inertia"]
    springs = (NOMINAL["gear_stiffness"], NOMINAL["sensor_stiffness"], NOMINAL["coupling_stiffness"])
    together = 1.0 / sum(1.0 / k for k in springs)
    two = np.sqrt(together * (1.0 / (motor + gear) + 1.0 / (wear + NOMINAL["sensor_inertia"]))) / (2.0 * np.pi)
    assert mode_frequencies(SMOOTH)[0] == pytest.approx(two, rel=0.03)


def test_a_branch_is_still_where_its_clamped_frequency_lies():
    # an undamped absorber holds its root at its own frequency: Den Hartog, Mechanical Vibrations, sec. 3.2
    machine = TorsionalMode(80.0, 8e-4, 1e-4).on_machine(SMOOTH, RUN, RNG)
    assert gain_of(machine, 80.0, WEAR) < 0.02 * gain_of(SMOOTH, 80.0, WEAR)
    assert mode_frequencies(machine).size == mode_frequencies(SMOOTH).size + 1


@pytest.mark.parametrize("frequency", [40.0, 125.0, 310.0])
def test_a_small_torque_at_the_wear_part_reads_as_the_linear_rig_says(frequency):
    time = np.arange(50000) / nominal.SAMPLE_RATE
    push = 0.01 * np.cos(2.0 * np.pi * frequency * time)
    moved = move(SMOOTH, steady(50000, push=push), SAME_LAWS)[25000:, 0]
    # held over each sample the torque loses sinc(f / fs), below 3e-4 here; the sampled loop comes half a sample late
    assert amplitude(moved, frequency) == pytest.approx(0.01 * gain_of(SMOOTH, frequency, WEAR), rel=1e-2)


def test_a_motor_line_reads_as_the_linear_rig_says():
    order, frequency = 21, 21 * RUN.motor_speed / (2.0 * np.pi)
    line = NOMINAL.motor_lines[0].__class__(order, 0.01, 0.3)
    machine = SMOOTH._replace(motor_table=sum_of([line], points=MOTOR_POINTS))
    moved = move(machine, steady(75000), SAME_LAWS)[25000:, 0]
    expected = 0.01 * nominal.RATIO * gain_of(SMOOTH, frequency, MOTOR)
    assert amplitude(moved, frequency) == pytest.approx(expected, rel=5e-3)


def test_the_mesh_line_lies_at_the_teeth_and_reads_as_the_linear_rig_says():
    mesh = GearMesh(teeth=84, errors=(2e-5,), phases=(0.4,), modulation=0.0, reading=0.0)
    moved = move(mesh.on_machine(SMOOTH, RUN, RNG), steady(75000), SAME_LAWS)[25000:, 0]
    assert amplitude(moved, 280.0) == pytest.approx(2e-5 * gain_of_twist(SMOOTH, 280.0), rel=5e-3)
    assert amplitude(moved, 283.4) < 0.01 * amplitude(moved, 280.0)


def test_the_planets_modulation_makes_side_lines_of_half_its_share():
    mesh = GearMesh(teeth=84, errors=(2e-5,), phases=(0.4,), modulation=0.2, reading=0.0)
    moved = move(mesh.on_machine(SMOOTH, RUN, RNG), steady(75000), SAME_LAWS)[25000:, 0]
    assert amplitude(moved, 290.0) == pytest.approx(0.1 * 2e-5 * gain_of_twist(SMOOTH, 290.0), rel=2e-2)


@pytest.mark.parametrize(("integrator", "steps"), [(Integrator.EULER, 8), (Integrator.DORMAND_PRINCE, 4)])
def test_the_integrators_agree_on_the_rig_as_it_is(integrator, steps):
    machine = machine_of(NOMINAL, SAME_LAWS)
    fine = move(machine, steady(25000), replace(SAME_LAWS, integrator=Integrator.DORMAND_PRINCE, steps=12))[:, 0]
    other = move(machine, steady(25000), replace(SAME_LAWS, integrator=integrator, steps=steps))[:, 0]
    # Euler at 5 microseconds shifts the 125 Hz mode by its order of 1e-3; the fifth-order rule is exact here
    assert np.std(other - fine) < (5e-3 if integrator is Integrator.EULER else 1e-6) * np.std(fine)


def test_the_loop_holds_low_frequencies_and_lets_high_ones_through():
    forces = np.zeros(6, dtype=complex)
    forces[MOTOR] = 1.0
    assert abs(to_sensor(SMOOTH, 1.0, forces)) < 0.2 * abs(to_sensor(SMOOTH, 1.0, forces, loop=False))
    open_loop = abs(to_sensor(SMOOTH, 300.0, forces, loop=False))
    assert abs(to_sensor(SMOOTH, 300.0, forces)) == pytest.approx(open_loop, rel=0.1)


def test_a_tables_slope_is_its_derivative():
    table = sum_of(NOMINAL.wear_lines, points=OUTPUT_POINTS)
    step = 2.0 * np.pi / OUTPUT_POINTS
    assert slope_of(table) == pytest.approx((np.roll(table, -1) - np.roll(table, 1)) / (2.0 * step), abs=1e-7)


def test_a_gap_takes_the_torque_away_until_it_is_crossed():
    machine = SMOOTH._replace(half_gap=1e-3)
    moved = move(machine, steady(50000, load=0.0, speed=0.0), SAME_LAWS)
    assert moved[-1, 0] == pytest.approx(0.0, abs=1e-9)
    loaded = move(machine, steady(50000), SAME_LAWS)
    assert loaded[-1, 0] == pytest.approx(move(SMOOTH, steady(50000), SAME_LAWS)[-1, 0], abs=1e-4)


def test_a_coupling_that_slips_carries_no_more_than_its_limit():
    forcing = steady(50000, load=2.0)
    limit = forcing.coupling_limit.copy()
    limit[25000:25500] = 0.5
    moved = move(SMOOTH, replace(forcing, coupling_limit=limit), SAME_LAWS)[:, 0]
    assert moved[25250:25500].mean() < 1.0 < moved[:25000].mean()
    assert moved[-1] == pytest.approx(moved[24999], abs=1e-3)
