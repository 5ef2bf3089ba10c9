"""Load, speed, sensor chain and plans: each against what its text or a theorem says."""

from dataclasses import replace

import numpy as np
import pytest

from proof.rig_program import nominal
from proof.rig_program.laws import SAME_LAWS, Friction, Integrator, Pulse, SlowFilter, draw_laws
from proof.rig_program.load import load_course, particle_hits, pulse_shape, slow_variation
from proof.rig_program.plan import PlanKind, Profile, Run, draw_plan
from proof.rig_program.sensor_chain import add_noise, convert, count
from proof.rig_program.speed import speed_course
from proof.rig_program.true_rig import draw_true_rig

LONG = Run(1000.0, Profile.STEADY, 5.0, duration=120.0)
SAMPLES = 3_000_000  # 120 s: some 5800 hits


@pytest.mark.long
@pytest.mark.parametrize("pulse", list(Pulse))
@pytest.mark.parametrize("shape", [1.0, 3.0])
def test_hits_have_the_mean_and_rms_of_campbells_theorem(pulse, shape):
    laws = replace(SAME_LAWS, pulse=pulse, hit_shape=shape)
    hits = particle_hits(LONG, laws, np.random.default_rng(3), samples=SAMPLES)
    # standard error of the mean: sqrt(2 tau / T), below 0.01; of the rms a few per cent for so spiky a course
    assert hits.mean() == pytest.approx(0.0, abs=0.05)
    assert hits.std() == pytest.approx(1.0, abs=0.05)


def test_both_pulses_carry_the_same_impulse():
    areas = [pulse_shape(pulse, 0.004).sum() / nominal.SAMPLE_RATE for pulse in Pulse]
    assert areas[0] == pytest.approx(0.004, rel=0.01)
    assert areas[1] == pytest.approx(areas[0], rel=0.01)


@pytest.mark.long
@pytest.mark.parametrize("slow_filter", list(SlowFilter))
def test_the_slow_variation_has_unit_rms_and_halves_its_power_at_its_corner(slow_filter):
    laws = replace(SAME_LAWS, slow_filter=slow_filter)
    course = np.concatenate([slow_variation(laws, np.random.default_rng(i), samples=SAMPLES)[::250] for i in range(8)])
    assert course.std() == pytest.approx(1.0, abs=0.05)
    power = np.abs(np.fft.rfft(course)) ** 2
    frequency = np.fft.rfftfreq(course.size, 0.01)
    low = power[(frequency > 0.02) & (frequency < 0.4)].mean()
    at_corner = power[(frequency > 1.35) & (frequency < 1.65)].mean()
    assert at_corner / low == pytest.approx(0.5, abs=0.12)  # some 290 bins at the corner: 6 % by chance


def test_the_load_has_its_mean_and_never_pulls():
    course = load_course(LONG, SAME_LAWS, np.random.default_rng(2), mean=2.7, samples=SAMPLES)
    assert course.mean() == pytest.approx(2.7, rel=0.01)
    assert course.std() == pytest.approx(2.7 * np.hypot(0.10, 0.06), rel=0.06)
    assert course.min() >= 0.0


@pytest.mark.long
def test_profiles_go_as_the_contract_says():
    rng = np.random.default_rng(1)
    first = round(nominal.SETTLING * nominal.SAMPLE_RATE)
    ramp = speed_course(Run(1400.0, Profile.RAMP, 0.0), rng, speed_error=0.0)
    top = 1400.0 * 2.0 * np.pi / 60.0
    assert ramp[first] == pytest.approx(0.1 * top)
    assert ramp[first + 135000] == pytest.approx(0.55 * top, rel=1e-3)
    assert np.all(ramp[first + 270001 :] == top)
    turning = speed_course(Run(600.0, Profile.REVERSAL, 0.0), rng, speed_error=0.01)[first:]
    assert turning.max() == pytest.approx(1.01 * 600.0 * 2.0 * np.pi / 60.0)
    assert np.sum(np.diff(np.sign(turning[1:-1])) != 0) == 3  # two full periods
    steady = speed_course(Run(700.0, Profile.STEADY, 0.0, duration=300.0), rng, speed_error=-0.01)
    assert steady.mean() == pytest.approx(0.99 * 700.0 * 2.0 * np.pi / 60.0, rel=2e-4)
    assert steady.std() / steady.mean() == pytest.approx(2e-4, rel=0.25)


@pytest.mark.parametrize("colour", [-0.2, 0.0, 0.3])
def test_noise_keeps_its_rms_and_has_its_colour(colour):
    noise = add_noise(np.zeros(400000), np.random.default_rng(5), rms=0.005, colour=colour)
    assert noise.std() == pytest.approx(0.005, rel=0.01)
    assert np.corrcoef(noise[1:], noise[:-1])[0, 1] == pytest.approx(colour, abs=0.01)


def test_the_converter_has_16_bits_over_20_volts_and_ends():
    assert convert(np.array([0.0, 0.00016, 11.0, -11.0])) == pytest.approx(
        [0.0, 20.0 / 65536.0, 10.0 - 20.0 / 65536.0, -10.0]
    )


def test_the_encoder_counts_a_turn_and_goes_below_zero():
    assert count(np.array([0.0, 2.0 * np.pi * 1.00001, -0.0001])).tolist() == [0, 16384, -1]


@pytest.mark.long
def test_rigs_scatter_as_the_reference_says():
    rng = np.random.default_rng(9)
    rigs = [draw_true_rig(rng) for _ in range(800)]
    for name, (value, rel_sd) in nominal.QUANTITIES.items():
        logs = np.log([rig[name] / value for rig in rigs])
        assert logs.std() == pytest.approx(rel_sd, rel=0.12)  # 2.5 % by chance
    assert max(abs(rig.speed_error) for rig in rigs) <= 0.01
    assert draw_true_rig(rng, spread=0.0).quantities == {n: v for n, (v, _) in nominal.QUANTITIES.items()}


def test_every_law_is_drawn():
    rng = np.random.default_rng(4)
    laws = [draw_laws(rng) for _ in range(60)]
    assert {law.friction for law in laws} == set(Friction)
    assert {law.integrator for law in laws} == set(Integrator)
    assert {law.delay for law in laws} == {0, 1}
    assert {law.tustin for law in laws} == {False, True}
    assert {law.fourth_mass is None for law in laws} == {False, True}
    tanh = [law.friction_width for law in laws if law.friction is Friction.TANH]
    assert min(tanh) >= 0.01
    assert max(tanh) <= 0.05


@pytest.mark.parametrize("kind", list(PlanKind))
def test_plans_have_four_runs_and_differ_where_they_should(kind):
    plans = [draw_plan(np.random.default_rng(seed), kind) for seed in range(20)]
    assert {len(plan) for plan in plans} == {4}
    if kind is PlanKind.ONE_SPEED:
        assert all(len({run.speed for run in plan}) == 1 for plan in plans)
    elif kind is PlanKind.OTHER:
        assert all(max(run.speed for run in plan) > 1.2 * min(run.speed for run in plan) for plan in plans)
    else:
        assert len(set(plans)) == 1
