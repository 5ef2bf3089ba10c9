"""The check of the step during a run: its bits, its warnings, and 100 random rigs against 16 times finer steps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.simulation.random_rigs import random_rig
from torquerig.api.simulated import simulate as simulate_scenario
from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import SimulationError
from torquerig.mechanisms import StribeckFriction
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController, TorqueSensor
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.inputs import Span
from torquerig.simulation.loop_stability import loop_warning
from torquerig.simulation.ready import ready
from torquerig.simulation.simulator import checked, simulate, stepped
from torquerig.simulation.step_watch import ALLOWED, rms, watched

TORQUE = "true_sensor_torque_Nm"
CHAOTIC = 67  # a random rig whose gaps rattle


def driven(*more: Part, kp: float = 0.02, limit: float = 5.0, gap: float = 0.0, speed: float = 40.0) -> Rig:
    motor = Motor(name="motor", inertia=2e-4, torque_limit=limit)
    gear = Gear(
        name="gear", after="motor", ratio=2.0, stiffness=4e3, damping=0.2, backlash=gap, efficiency=0.95,
        output_inertia=1e-4,
    )  # fmt: skip
    sensor = TorqueSensor(name="sensor", after="gear", stiffness=1e3, damping=0.05, inertia=1e-4, bandwidth=1000.0)
    wheel = Body(name="wheel", after="sensor", inertia=4e-3, viscous=1e-2)
    loop = SpeedController(name="loop", kp=kp, ki=10 * kp)
    return Rig((motor, gear, sensor, wheel, loop, *more), Run(speed=speed), measured="sensor")


def warnings_of(rig: Rig, **more: float) -> list[str]:
    made = simulate(rig, **{"duration": 0.5, "seed": 0, "settling": 0.2, "sample_rate": 5000.0, **more})
    return list(made.origin.get("warnings", []))


@pytest.mark.parametrize("gap", [0.0, 0.01], ids=["smooth", "with a gap"])
@pytest.mark.parametrize("profile", ["steady", "reversal"])
def test_a_checked_run_has_the_bits_of_an_unchecked_one(gap: float, profile: str) -> None:
    rig = replace(driven(gap=gap), run=Run(speed=40.0, profile=profile))
    run = ready(rig, Span.of(duration=0.5, settling=0.2, rate=5000.0, seed=1, wander=1e-3))
    one, other = checked(run), stepped(run)
    for name, channel in other.channels.items():
        assert (one.channels[name].values == channel.values).all(), name


def test_a_step_that_is_fine_says_nothing() -> None:
    assert warnings_of(driven()) == []


def test_a_step_that_is_too_coarse_is_said_with_the_steps_to_take() -> None:
    """At 2.5 kHz a mode of 1151 Hz turns 2.9 rad in one step, at the end of stability; a fifth of that is chosen."""
    dry = driven(StribeckFriction(name="dry", at="wheel", coulomb=0.5, static=0.8, stribeck_speed=1.0))
    turned = replace(dry, run=Run(speed=40.0, profile="reversal"))
    run = ready(turned, Span.of(duration=0.5, settling=0.2, rate=2500.0, seed=1, wander=0.0))
    coarse = replace(run, steps=1)
    assert run.steps >= 4
    watch, *_ = watched(coarse, np.empty((len(run.outputs), run.span.samples)))
    (sentence,) = watch.sentences()
    assert watch.change > ALLOWED
    assert "simulate with 4 steps a sample in place of 1" in sentence


def test_a_run_that_fails_within_a_stretch_is_the_same_failure() -> None:
    """Beyond stability the half step of a stretch survives longer than the run; the run's failure counts."""
    run = replace(ready(driven(), Span.of(duration=2.0, settling=0.0, rate=300.0, seed=1, wander=0.0)), steps=1)
    said = []
    for way in (checked, stepped):
        with pytest.raises(SimulationError) as failed:
            way(run)
        said.append(str(failed.value))
    assert said[0] == said[1]


def test_a_gap_that_rattles_is_called_chaotic_and_its_samples_do_depend_on_the_step() -> None:
    rig, rate = random_rig(CHAOTIC)
    settings = {"duration": 1.0, "seed": CHAOTIC, "settling": 0.5, "sample_rate": rate}
    made = simulate(rig, **settings)
    assert any("chaotic" in sentence for sentence in made.origin["warnings"])
    finer = simulate(rig, **settings, substeps=2 * made.origin["substeps"]).channels[TORQUE].values
    coarse = made.channels[TORQUE].values
    assert np.std(finer - coarse) > 0.1 * np.std(coarse)
    assert np.std(finer) == pytest.approx(np.std(coarse), rel=0.3)


def test_a_stalled_motor_is_said() -> None:
    dry = StribeckFriction(name="dry", at="wheel", coulomb=3.0, static=3.0, stribeck_speed=1.0, smoothing=0.2)
    (sentence,) = warnings_of(driven(dry, limit=1.0), settling=0.5)
    assert "the motor stalls" in sentence
    assert "1 N*m, the torque limit" in sentence


def test_a_motor_that_stays_at_its_limit_is_said_and_is_not_called_stalled() -> None:
    """Viscous load of 0.2 N m at 20 rad/s behind the gear, 0.11 N m at the motor; the limit holds it to 0.08."""
    (sentence,) = warnings_of(driven(limit=0.08), settling=0.5)
    assert "is at 0.08 N*m, the torque limit" in sentence
    assert "stalls" not in sentence


def test_a_short_time_at_the_limit_is_not_said() -> None:
    assert warnings_of(replace(driven(limit=2.0), run=Run(speed=40.0, profile="reversal")), duration=2.0) == []


def test_an_unstable_sampled_loop_is_said_with_a_gain_that_is_stable() -> None:
    assert loop_warning(driven(), rate=5000.0) == ""
    sentence = loop_warning(driven(kp=30.0), rate=5000.0)
    assert "the speed loop is unstable" in sentence
    assert "lower kp and ki" in sentence


def test_the_rate_of_the_loop_decides_its_stability() -> None:
    """All inertia at the motor is 1.3e-3 kg m^2, so that the loop crosses at 230 1/s: slow at 25 kHz, not at 50 Hz."""
    rig = driven(kp=0.3)
    assert loop_warning(rig, rate=25_000.0) == ""
    assert "unstable" in loop_warning(rig, rate=50.0)


def test_the_shipped_rig_warns_of_nothing_and_a_wild_one_warns_in_python(tmp_path: Path) -> None:
    path = shipped_scenarios() / "wear_rig.yaml"
    assert "warnings" not in simulate_scenario(path, duration=0.2).origin
    document = overridden(read_document(path), ("speed_controller.kp=20 N*m*s/rad",))
    made = read_scenario(document, catalog_for(path, ()), seed=1)
    with pytest.warns(UserWarning, match="the speed loop is unstable"):
        simulate_scenario(made, duration=0.2)


def test_a_bar_without_anything_at_its_end_needs_no_drive_to_be_watched() -> None:
    bar = Coupling(name="bar", after="wheel", stiffness=400.0, damping=1.0, inertia=0.01)
    rig = Rig((*driven().parts[:4], bar, *driven().parts[4:]), Run(speed=0.0), measured="bar")
    assert warnings_of(rig) == []


def agree_or_warn(seed: int) -> tuple[float, bool]:
    """Return the change by 16 times finer steps over the rms of the torque, and whether the run warned of its step."""
    rig, rate = random_rig(seed)
    settings = {"duration": 1.0, "seed": seed, "settling": 0.5, "sample_rate": rate}
    made = simulate(rig, **settings)
    fine = simulate(rig, **settings, substeps=16 * made.origin["substeps"]).channels[TORQUE].values
    size, moved = rms(fine), rms(made.channels[TORQUE].values - fine)
    change = moved / size if moved else 0.0  # a sensor with nothing behind it reads nothing
    said = made.origin.get("warnings", [])
    return change, any("too coarse" in one or "chaotic" in one for one in said)


@pytest.mark.long
@pytest.mark.parametrize("seed", [0, 4, 10, 18, 22, 25, 30, 58, 75, 103])
def test_random_rigs_agree_with_16_times_finer_steps_or_warn(seed: int) -> None:
    change, warned = agree_or_warn(seed)
    assert change <= ALLOWED or warned, (seed, change)
