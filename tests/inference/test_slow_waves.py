"""Tones that are too slow for blocks: found in whole runs, and in the written model."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.inference.features.run_features import run_features
from torquerig.inference.features.slow_waves import slow_waves
from torquerig.inference.places import order


def found(runs, *, known=()):
    seen = [run_features(run, []) for run in runs]
    return slow_waves(seen, [np.ones(each.level.size) for each in seen], [], known)


@pytest.mark.parametrize("at", [1.13, 2.34])  # 1.1 and 2.3 periods in a block of a second
def test_a_tone_of_which_a_block_has_too_few_periods_is_found(at):
    runs = [drawn_run(seed, speed=steady(600, duration=6.0), tones={at: 0.05}) for seed in (1, 2)]
    assert [line.place.at for line in found(runs)] == pytest.approx([at], rel=0.01)


def test_it_is_found_where_the_speed_changes():
    run = drawn_run(1, speed=ramp(600, duration=16.0), tones={2.66: 0.05})
    assert [line.place.at for line in found([run])] == pytest.approx([2.66], rel=0.01)


def test_noise_alone_has_no_slow_tone():
    for seed in range(20):
        assert not found([drawn_run(seed, speed=steady(600, duration=6.0)), drawn_run(99 + seed, speed=ramp(600))])


def test_a_line_of_the_rig_is_no_tone():
    runs = [drawn_run(1, speed=steady(600, duration=6.0), orders={0.2: 0.05})]
    assert found(runs)
    assert not found(runs, known=[order(0.2).at])


@pytest.mark.long
def test_a_load_that_swells_is_in_the_written_model(tmp_path):
    scenario = pump_scenario(tmp_path)
    swell = mechanisms.GainRipple(name="swell", frequency=1.63, depths=(0.2,))
    data = as_json(diagnose(scenario, recorded(scenario, swell, speeds=(600.0, 800.0, 1000.0, 1200.0))))
    assert data["verdict"] == "unexplained"
    assert not data["findings"]
    unnamed = data["unnamed"][0]
    assert (unnamed["kind"], unnamed["axis"], unnamed["minor"]) == ("tone", "Hz", False)
    assert unnamed["at"] == pytest.approx(1.63, rel=0.01)
    before, after = (data["fit"][one]["heldout_misfit"] for one in ("before", "after"))
    assert after < 1.2
    assert before - after > 0.7 * (before - 1.0)
