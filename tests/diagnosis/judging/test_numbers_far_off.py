"""A number that stands where no fit goes further is told; one that is only wrong is not."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import LIMIT
from torquerig.diagnosis.judging.numbers_far_off import number_far_off
from torquerig.inference.knobs import HARDLY_ANY, Knob, turned
from torquerig.mechanisms import ParticleLoad, TorqueRipple
from torquerig.scenario.model import Scenario

INERTIA = Knob("wear_part", "inertia", 0.1)
LEVEL = Knob("load", "mean_by_occupancy_percent", 0.05, key=21.0)


def case_at(wear_rig: Scenario, *positions: float) -> Case:
    runs = [SimpleNamespace(name=f"at{percent:g}", mean_speed=105.0, run=SimpleNamespace(occupancy_percent=percent))
            for percent in (0.0, 21.0)]  # fmt: skip
    knobs, at = (INERTIA, LEVEL), np.array(positions)
    model = SimpleNamespace(knobs=knobs, positions=at, rig=turned(wear_rig.rig, knobs, at))
    nominal: Any = wear_rig.rig
    return cast("Case", SimpleNamespace(runs=runs, model=model, nominal=nominal, nominal_with_accepted=lambda: nominal))


@pytest.mark.parametrize("positions", [(0.0, 0.0), (5.2, -5.2), (-6.5, 3.0)])
def test_a_wrong_number_is_no_missing_physics(positions: tuple[float, float], wear_rig: Scenario) -> None:
    assert number_far_off(case_at(wear_rig, *positions)) is None


def test_a_level_at_its_limit_is_told_with_the_runs_that_have_it(wear_rig: Scenario) -> None:
    found = number_far_off(case_at(wear_rig, 1.0, LIMIT))
    assert found is not None
    sentence, mismatch = found
    assert "load.mean_by_occupancy_percent.21: the fit requires 5.39" in sentence
    assert "states 3.8" in sentence
    assert mismatch.recordings == ("at21",)
    assert mismatch.domain == "level"
    assert mismatch.p_value < 1e-10


@pytest.mark.parametrize("inertia", [0.0, 6.5])
def test_a_number_of_the_load_need_not_be_at_its_limit(inertia: float, wear_rig: Scenario) -> None:
    found = number_far_off(case_at(wear_rig, inertia, 6.2))
    assert found is not None
    assert "or beyond" not in found[0]
    assert "6.2 stated standard deviations" in found[0]


def test_any_other_number_is_of_all_runs(wear_rig: Scenario) -> None:
    found = number_far_off(case_at(wear_rig, -LIMIT, 0.0))
    assert found is not None
    assert "wear_part.inertia" in found[0]
    assert found[1].recordings == ("at0", "at21")


def test_how_slowly_a_load_varies_whose_hits_nobody_knows_may_be_anything(wear_rig: Scenario) -> None:
    """Free hits take the place of a stated slow variation, which then goes to nothing."""
    rig = wear_rig.rig
    load = rig.parts_of(ParticleLoad)[0]
    slow, at = Knob(load.name, "slow_rms", 0.4), np.array([-LIMIT])
    for hits, told in ((load.hit_rms, True), (HARDLY_ANY, False)):
        stated = rig.changed(replace(load, hit_rms=hits))
        model = SimpleNamespace(knobs=(slow,), positions=at, rig=turned(stated, (slow,), at))
        case = SimpleNamespace(**{**vars(case_at(wear_rig, 0.0, 0.0)), "model": model, "nominal": stated,
                                  "nominal_with_accepted": lambda stated=stated: stated})  # fmt: skip
        assert (number_far_off(cast("Case", case)) is not None) == told


@pytest.mark.parametrize(
    ("spread", "position", "told"),
    [(0.25, -LIMIT, False), (0.25, LIMIT, True), (0.1, -LIMIT, True)],
    ids=["weaker", "stronger", "weaker than one well known"],
)
@pytest.mark.parametrize("of_a_line", [True, False], ids=["line", "drag"])
def test_what_is_hardly_known_may_be_as_small_as_it_likes(
    of_a_line: bool, spread: float, position: float, told: bool, wear_rig: Scenario
) -> None:
    """Of a line that is not there a factor's logarithm has no end; one that is far stronger stands in for another."""
    ripple = wear_rig.rig.parts_of(TorqueRipple)[0]
    line = Knob(ripple.name, "amplitudes", spread, key=min(ripple.amplitudes))
    knob, at = line if of_a_line else Knob("wear_part", "viscous", spread), np.array([position])
    runs = [SimpleNamespace(name="one", mean_speed=105.0, run=SimpleNamespace(occupancy_percent=5.0))]
    model = SimpleNamespace(knobs=(knob,), positions=at, rig=turned(wear_rig.rig, (knob,), at))
    nominal = wear_rig.rig
    case: Any = SimpleNamespace(runs=runs, model=model, nominal=nominal, nominal_with_accepted=lambda: nominal)
    assert (number_far_off(case) is not None) is told
