"""Each mechanism's own numbers against its equation: blades, particles, Stribeck, branch, cogging."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.mechanisms import (
    Backlash,
    BladePass,
    Cogging,
    CommutationRipple,
    GearMesh,
    ParticleLoad,
    StribeckFriction,
    TorqueRipple,
    TorsionalMode,
)
from torquerig.mechanisms.particle_load import ParticleProcess
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.rig.terms import HarmonicTorque, Load, Spring
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate


def held(*effects: Part, speed: float, run: Run | None = None) -> Rig:
    """A motor whose stiff loop holds the wear part at ``speed`` [rad/s]."""
    return Rig(
        (
            Motor(name="motor", inertia=1.0, torque_limit=1e4),
            Coupling(name="sensor", after="motor", stiffness=1e5, damping=50.0),
            Body(name="wear_part", after="sensor", inertia=1.0),
            SpeedController(name="controller", kp=100.0, ki=1e4),
            *effects,
        ),
        run or Run(speed=speed),
        measured="sensor",
    )


def test_blade_pass_has_the_mean_and_first_harmonic_of_a_half_wave_squared_cosine() -> None:
    """Mean A/4, first harmonic 4 A/(3 pi), over whole turns of the true angle."""
    made = simulate(
        held(BladePass(name="b", order_output=4, amplitude=2.0, phase=0.0), speed=10 * pi), duration=1.0, seed=1
    )
    load = made.channels["true_load_Nm"].values
    angle = 4 * made.channels["true_motor_angle_rad"].values  # the shaft is stiff: both angles agree to 1e-5 rad
    columns = np.column_stack([f(h * angle) for h in range(1, 6) for f in (np.cos, np.sin)] + [np.ones(angle.size)])
    found = np.linalg.lstsq(columns, load, rcond=None)[0]
    assert found[-1] == pytest.approx(2.0 / 4, rel=1e-3)
    assert np.hypot(found[0], found[1]) == pytest.approx(4 * 2.0 / (3 * pi), rel=1e-3)


def process(**changed: float) -> ParticleProcess:
    values = {
        "mean": 2.0,
        "rate": 60.0,
        "decay": 0.004,
        "shape": 1.5,
        "hit_rms": 0.10,
        "slow_rms": 0.06,
        "slow_cutoff": 1.5,
    }
    return ParticleProcess(**{**values, **changed})


def test_hits_have_the_mean_and_rms_of_campbells_theorem() -> None:
    """1000 s at 2 kHz, 60 000 hits: the rms within 2 % (shot noise has heavy tails), the mean within 0.2 %."""
    values = process(slow_rms=0.0).sample(2_000_000, 2000.0, np.random.default_rng(1))
    assert values.mean() == pytest.approx(2.0, rel=2e-3)
    assert values.std() / 2.0 == pytest.approx(0.10, rel=0.02)


def test_hits_keep_their_rms_where_they_overlap() -> None:
    values = process(slow_rms=0.0, rate=2000.0).sample(1_000_000, 2000.0, np.random.default_rng(1))
    assert values.std() / 2.0 == pytest.approx(0.10, rel=0.02)


def test_slow_variation_has_its_rms_and_stays_below_its_cutoff() -> None:
    """2000 s hold 2000 * 2 * 1.67 Hz = 6700 degrees of freedom: rms within 2 sigma = 2 %."""
    values = process(hit_rms=0.0).sample(100_000, 50.0, np.random.default_rng(3))
    assert values.std() / 2.0 == pytest.approx(0.06, rel=0.025)
    powers = np.abs(np.fft.rfft(values - values.mean())) ** 2
    frequencies = np.fft.rfftfreq(values.size, 1 / 50.0)
    assert powers[frequencies > 6].sum() < 0.01 * powers.sum()  # 4th power of the frequency: 1/(3 * 4^3) at 4 cutoffs


def test_both_together_add_in_square_and_are_never_negative() -> None:
    values = process().sample(2_000_000, 2000.0, np.random.default_rng(5))
    assert values.std() / 2.0 == pytest.approx(sqrt(0.10**2 + 0.06**2), rel=0.03)
    wild = process(slow_rms=1.0).sample(200_000, 2000.0, np.random.default_rng(5))
    assert wild.min() == 0.0


def load_at(occupancy: float, size: float | None = None) -> ParticleProcess:
    load = ParticleLoad(name="load", mean_by_occupancy_percent={0: 0.05, 5: 1.0, 11: 2.0, 15: 2.7, 21: 3.8})
    rig = held(load, speed=1.0, run=Run(speed=1.0, occupancy_percent=occupancy, particle_size=size))
    term = next(term for term in rig.terms() if isinstance(term, Load))
    assert isinstance(term.process, ParticleProcess)
    return term.process


@pytest.mark.parametrize(("occupancy", "mean"), [(0, 0.05), (5, 1.0), (8, 1.5), (21, 3.8), (18, 3.25)])
def test_the_mean_is_stated_or_between_the_stated(occupancy: float, mean: float) -> None:
    assert load_at(occupancy).mean == pytest.approx(mean, rel=1e-12)


@pytest.mark.parametrize("occupancy", [-1.0, 21.5, 100.0])
def test_an_occupancy_outside_what_is_known_is_refused(occupancy: float) -> None:
    with pytest.raises(InputError, match=r"outside 0\.\.21 %.*mean_by_occupancy_percent"):
        load_at(occupancy)


@pytest.mark.parametrize(("occupancy", "millimetres"), [(0, 0.5), (5, 0.25), (21, 0.98)])
def test_rate_and_pulse_follow_the_particle_size_as_the_reference_rig_states(
    occupancy: float, millimetres: float
) -> None:
    made = load_at(occupancy, millimetres * 1e-3)
    assert made.rate == pytest.approx(60 * (0.5 / millimetres) ** 1.5 * (0.3 + occupancy / 10))
    assert made.decay == pytest.approx(0.004 * sqrt(millimetres / 0.5))


@pytest.mark.long
def test_as_many_hits_come_as_the_rate_says() -> None:
    """At 5 hits a second of 1 ms nearly every hit stands alone: upward jumps, counted over 2000 s within 3 sigma."""
    values = process(rate=5.0, decay=0.001, slow_rms=0.0).sample(4_000_000, 2000.0, np.random.default_rng(8))
    jumps = np.count_nonzero(np.diff(values) > 1e-6)
    assert jumps == pytest.approx(10_000, abs=3 * sqrt(10_000) + 30)  # and about 25 that share a sample


@pytest.mark.parametrize("speed", [0.5, 2.0, -2.0])
def test_stribeck_friction_is_its_formula(speed: float) -> None:
    """Tc 0.2, Ts 0.5 (backward 0.3, 0.4), ws 1 rad/s; tanh(w / 0.02) is 1 to 1e-16 here."""
    friction = StribeckFriction(
        name="it", coulomb=0.2, static=0.5, stribeck_speed=1.0, coulomb_backward=0.3, static_backward=0.4
    )
    made = simulate(held(friction, speed=speed), duration=0.2, seed=1, settling=2.0)
    slow = speed**2  # over ws^2
    expected = 0.2 + 0.3 * np.exp(-slow) if speed > 0 else -(0.3 + 0.1 * np.exp(-slow))
    assert made.torque().mean() == pytest.approx(expected, rel=1e-3)


def test_backward_friction_is_the_forward_one_unless_stated() -> None:
    friction = StribeckFriction(name="it", coulomb=0.2, static=0.5, stribeck_speed=1.0)
    there, back = (simulate(held(friction, speed=w), duration=0.1, seed=1, settling=2.0) for w in (2.0, -2.0))
    assert back.torque().mean() == pytest.approx(-there.torque().mean(), rel=1e-6)


def test_torsional_mode_clamped_at_its_root_has_its_frequency() -> None:
    """A root of 1e6 times its inertia is a clamp to 5e-7; damping ratio from the real part of the eigenvalue."""
    mode = TorsionalMode(name="it", after="root", frequency=62.5, inertia=5e-4, damping_ratio=0.03)
    system = matrices(lower(Rig((Body(name="root", inertia=500.0), mode), measured="it"), 0))
    assert system.undamped_frequencies()[1] == pytest.approx(62.5, rel=1e-6)
    values = np.linalg.eigvals(system.state_matrix())
    ringing = values[np.argmax(values.imag)]
    assert abs(ringing) == pytest.approx(2 * pi * 62.5, rel=1e-5)
    assert -ringing.real / abs(ringing) == pytest.approx(0.03, rel=1e-5)


@pytest.mark.parametrize(("slots", "pole_pairs", "native"), [(12, 7, 84), (9, 4, 72), (12, 5, 60), (24, 4, 24)])
def test_native_cogging_stands_at_the_least_common_multiple(slots: int, pole_pairs: int, native: int) -> None:
    """LCM(Q, 2p), Zhu & Howe 2000; orders that coincide (24 slots, 8 magnets) add up."""
    made = Cogging(
        name="it", slots=slots, pole_pairs=pole_pairs, native=0.01, unequal_magnets=0.002, unequal_teeth=0.003
    )
    assert made.amplitudes()[native] == pytest.approx(0.012 if native == slots else 0.01)
    assert made.amplitudes()[2 * pole_pairs] == pytest.approx(0.003)


def test_occupancy_relieves_the_lines_of_the_shaft() -> None:
    ripple = TorqueRipple(name="it", at="wear_part", group="mechanical", amplitudes={1: 0.1}, relief_per_percent=0.12)
    term = next(
        term
        for term in held(ripple, speed=1.0, run=Run(speed=1.0, occupancy_percent=21)).terms()
        if isinstance(term, HarmonicTorque)
    )
    assert term.waves[0].amplitude == pytest.approx(0.1 / (1 + 0.12 * 21))


def test_gaps_of_gear_and_effect_add_up() -> None:
    rig = Rig(
        (
            Motor(name="motor", inertia=1e-4, torque_limit=1.0),
            Gear(name="gearbox", after="motor", ratio=5, stiffness=1e3, damping=0, backlash=0.001, output_inertia=1e-3),
            Backlash(name="more", gap=0.002),
        ),
        measured="gearbox",
    )
    assert next(term for term in rig.terms() if isinstance(term, Spring)).gap == pytest.approx(0.003)


@pytest.mark.parametrize(
    ("effect", "said"),
    [
        (GearMesh(name="it", gear="sensor", order_output=84, transmission_error=(1e-5,)), "'sensor' is no gear"),
        (GearMesh(name="it", gear="gearbx", order_output=84, transmission_error=(1e-5,)), "no part 'gearbx'"),
        (Backlash(name="it", gear="motor", gap=1e-3), "'motor' is no gear"),
        (CommutationRipple(name="it", at="wear_part", order_motor=42, depth=0.1), "'wear_part' is no motor"),
    ],
    ids=lambda value: getattr(value, "kind", ""),
)
def test_an_effect_on_a_part_that_cannot_have_it_is_refused_and_not_left_out_in_silence(
    effect: Part, said: str
) -> None:
    with pytest.raises(Exception, match=said):
        held(effect, speed=1.0).terms()


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Cogging(name="it", slots=0, pole_pairs=7, native=0.01), "at least 1"),
        (lambda: TorqueRipple(name="it", at="motor", group="cogging", amplitudes={0: 0.1}), "more than 0"),
        (lambda: ParticleLoad(name="it", mean_by_occupancy_percent={}), "is empty"),
        (lambda: Gear(name="it", ratio=0, stiffness=1, damping=0), "transmits nothing"),
    ],
    ids=["slots", "order", "no means", "ratio"],
)
def test_what_cannot_be_is_refused_when_it_is_made(make: object, said: str) -> None:
    assert callable(make)
    with pytest.raises(ValueError, match=said):
        make()
