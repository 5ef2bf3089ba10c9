"""Strangers: enough of them, each with a place, a size that counts, and nothing left without it."""

from dataclasses import replace

import numpy as np
import pytest

from proof.fleet.effects import MECHANISMS
from proof.fleet.recording import record
from proof.fleet.rig import draw_rig
from proof.fleet.setting import setting_of
from proof.strangers import STRANGERS
from proof.strangers.draw import stranger_case
from torquerig import mechanisms

DOMAINS = {"order", "frequency", "time", "speed", "level", "distribution"}


@pytest.fixture(scope="module")
def setting():
    kinds = {"motors": ("servo",), "drives": ("one_stage",), "loads": ("brake",)}
    rigs = (draw_rig("rig", (4, seed), plans=("several",), **kinds) for seed in range(40))
    rig = next(one for one in rigs if one.design.angle == "encoder" and one.design.sample_rate == 4000.0)
    return setting_of(replace(rig, runs=tuple(replace(run, duration=4.0) for run in rig.runs)))


def test_there_are_at_least_25_and_none_is_a_mechanism():
    assert len(STRANGERS) >= 25
    assert not set(STRANGERS) & set(MECHANISMS)
    assert not {name for name in STRANGERS if hasattr(mechanisms, "".join(map(str.capitalize, name.split("_"))))}


@pytest.mark.parametrize("kind", sorted(STRANGERS))
def test_each_has_a_place_and_changes_the_recording(kind, setting):
    stranger = STRANGERS[kind].draw(np.random.default_rng(5), setting)
    assert stranger is not None
    (place,) = stranger.places()
    assert place.domain in DOMAINS
    assert stranger.size != 0.0
    rig = replace(setting.rig, effects=(stranger,))
    number = next(i for i, run in enumerate(rig.runs) if run.profile == "ramp")
    with_it, without = record(rig, number), record(rig, number, effects=())
    changed = with_it.motor_angle if stranger.acts_as.startswith("angle") else with_it.volts
    plain = without.motor_angle if stranger.acts_as.startswith("angle") else without.volts
    assert np.any(changed != plain)
    # no size, no change: the same recording to the last code
    nothing = record(replace(setting.rig, effects=(replace(stranger, size=0.0),)), number)
    if kind != "lost_samples":  # its size is a length of at least two samples
        assert np.array_equal(nothing.volts, without.volts)
        assert np.array_equal(nothing.motor_angle, without.motor_angle)


def test_a_line_lies_at_its_order(setting):
    stranger = replace(STRANGERS["irrational_order"].draw(np.random.default_rng(5), setting), size=setting.torque)
    rig = replace(setting.rig, effects=(stranger,))
    angle = record(rig, 0).motor_angle / abs(rig.design.ratio)
    change = record(rig, 0).volts - record(rig, 0, effects=()).volts
    orders = np.arange(1.0, 12.0, 0.02)
    lines = [abs(np.mean(change * np.hanning(change.size) * np.exp(-1j * order * angle))) for order in orders]
    assert orders[int(np.argmax(lines))] == pytest.approx(stranger.at, abs=0.03)


def test_a_drawn_case_counts():
    case = stranger_case("case", (3, 2), "level_step")
    assert case.shown[0].counts
    assert case.rig.effects[0].kind == "level_step"
