"""What simulations say of a model no longer hangs on what their loads happened to draw."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.expecting.chance_of_load import ChanceOfLoad
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.expecting.simulated import expected_from
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import observed
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.inference.places import order
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import GearMesh, TorsionalMode
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.model import Scenario

Record = Callable[..., Recording]

_SEEDS = (21, 22, 23)
EFFECTS: dict[str, Part | None] = {
    "none": None,
    "mesh": GearMesh(name="effect", order_output=84.0, transmission_error=(6e-5, 2e-5)),
    "branch": TorsionalMode(name="effect", after="wear_part", frequency=85.0, inertia=8e-4, damping_ratio=0.03),
}


def seen(rig: Rig, recording: Recording) -> Features:
    run = observed(recording, shaft_angles([recording], rig)[0], ratio=5.0)
    return features(run, sorted({order(line.order) for line in Twin(rig.at(run.run)).lines()}), held=None)


@pytest.mark.parametrize(
    "name", ["none", *(pytest.param(name, marks=pytest.mark.long) for name in EFFECTS if name != "none")]
)
@pytest.mark.parametrize("rpm", [1000.0, pytest.param(-700.0, marks=pytest.mark.long)])
def test_each_draw_says_the_same(name: str, rpm: float, wear_rig: Scenario, record: Record) -> None:
    """Where the load makes nearly all, draws differ by a decibel, and what is expected by each by a few hundredths."""
    effect = EFFECTS[name]
    rig = wear_rig.rig if effect is None else wear_rig.rig + effect
    runs = [seen(rig, record(rig, seed, rpm=rpm)) for seed in _SEEDS]
    twin = expected(rig, runs[0])
    shown = np.isfinite([run.power for run in runs]).all(axis=0)
    of_load = shown & (twin.load_share > 0.8) & (runs[0].band > 3.0)
    drawn = np.log([run.power for run in runs])[:, of_load]
    told = [expected_from(rig, [runs[0]], [[run.observed]])[0] for run in runs]
    usual = np.log([each.power for each in told])[:, of_load]
    assert np.count_nonzero(of_load) > 20
    assert usual.std(axis=0).mean() < 0.25 * drawn.std(axis=0).mean()
    assert np.abs(usual.mean(axis=0) - np.log(twin.power[of_load])).mean() < 0.1
    for each in told:
        assert each.amplitude == pytest.approx(twin.amplitude, rel=0.08, abs=8e-4)
        assert each.level == pytest.approx(twin.level, rel=0.01)


def test_a_quiet_copy_keeps_the_mean_torque_and_the_lines(wear_rig: Scenario, record: Record) -> None:
    run = seen(wear_rig.rig, record(wear_rig.rig, 21))
    quiet = ChanceOfLoad.of(wear_rig.rig, run.observed).quieted(run.observed)
    assert quiet.torque.mean() == pytest.approx(expected(wear_rig.rig, run).level.mean(), rel=0.01)
    assert quiet.torque.std() < 0.7 * run.observed.torque.std()


def test_what_the_twin_knows_nothing_of_stays(wear_rig: Scenario, record: Record) -> None:
    """Power beside the load's is not taken for a loud load, and a load that does not pass on not for a soft one."""
    run = seen(wear_rig.rig, record(wear_rig.rig, 21))
    twin, chance = expected(wear_rig.rig, run), ChanceOfLoad.of(wear_rig.rig, run.observed)
    usual = chance.usual(run, twin)
    shown = np.isfinite(run.power)
    more = chance.usual(replace(run, power=run.power + 50 * twin.power), twin)
    less = chance.usual(replace(run, power=0.01 * run.power), twin)
    assert (more - 50 * twin.power)[shown] == pytest.approx(usual[shown], rel=0.5)
    assert (less[shown] > 0).all()
    assert less[shown] == pytest.approx(0.01 * usual[shown], rel=0.5)


def test_a_rig_without_a_load_is_left_as_it_is(wear_rig: Scenario, record: Record) -> None:
    parts = tuple(part for part in wear_rig.rig.parts if part.kind != "particle_load")
    idle = replace(wear_rig.rig, parts=parts)
    run = seen(idle, record(idle, 21, rpm=30 * 20 / pi))
    chance = ChanceOfLoad.of(idle, run.observed)
    assert chance.quieted(run.observed).torque == pytest.approx(run.observed.torque)
    assert chance.usual(run, expected(idle, run)) == pytest.approx(run.power, nan_ok=True)
