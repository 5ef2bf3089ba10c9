"""Of which runs the distribution of values alone tells how good a model is."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.judging import untold_runs
from torquerig.diagnosis.judging.untold_runs import flat_in_the_model_alone, of_untold_loads
from torquerig.diagnosis.looking.features import Features
from torquerig.errors import SimulationError
from torquerig.mechanisms import Clipping, ParticleLoad
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario


@pytest.mark.parametrize(
    ("occupancies", "rebuilt", "untold"),
    [
        ((5.0, 0.0), True, {"run1"}),
        ((5.0, 15.0), True, set()),
        ((5.0, 15.0), False, {"run1"}),
        ((0.0, 0.0), True, set()),
    ],
)
def test_a_load_is_untold_where_all_that_was_fitted_ran_without_or_a_limit_took_much_of_it(
    occupancies: tuple[float, ...], *, rebuilt: bool, untold: set[str]
) -> None:
    held = [
        cast(
            "Features",
            SimpleNamespace(observed=SimpleNamespace(name=name, run=Run(occupancy_percent=at), rebuilt=mended)),
        )
        for name, at, mended in zip(("run1", "run2"), occupancies, (rebuilt, False), strict=True)
    ]
    assert of_untold_loads(held, fitted={"run2"}) == untold


def limited(rig: Rig, limit: float, *, load: float) -> Rig:
    """The rig with another mean of its load, read by what stops at a limit [V]."""
    (own,) = rig.parts_of(ParticleLoad)
    means = {percent: mean * load for percent, mean in own.mean_by_occupancy_percent.items()}
    heavier = rig.changed(replace(own, mean_by_occupancy_percent=means))
    return Candidate(mechanism="clipping", parts=(Clipping(name="rail", limit=limit),), knobs=()).added_to(heavier)


def highest(held: tuple[Features, ...]) -> float:
    """The furthest from zero that any of the recordings comes [V]."""
    return max(float(np.abs(each.observed.recording.torque_values()).max()) for each in held)


@pytest.mark.long
@pytest.mark.parametrize(("load", "limit", "flat"), [(3.0, 1.2, True), (1.0, 1.2, False), (3.0, 0.8, False)])
def test_a_model_may_stand_at_a_limit_that_the_recording_never_reaches(
    load: float, limit: float, *, flat: bool, wear_rig: Scenario, held: tuple[Features, ...]
) -> None:
    """With three times the load it stands there; a recording that reaches the limit is compared as it is."""
    rig = wear_rig.rig
    names = {each.observed.name for each in held}
    assert flat_in_the_model_alone(rig, limited(rig, limit * highest(held), load=load), held) == (
        names if flat else set()
    )


def test_without_a_limit_of_its_own_none_is_simulated(
    wear_rig: Scenario, held: tuple[Features, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object, **__: object) -> None:
        raise AssertionError("simulated")

    monkeypatch.setattr(untold_runs, "simulated_runs", refused)
    clipped = limited(wear_rig.rig, 1.0, load=1.0)
    assert not flat_in_the_model_alone(wear_rig.rig, wear_rig.rig, held)
    assert not flat_in_the_model_alone(clipped, clipped, held)


def test_what_cannot_be_simulated_is_left_to_the_twins(
    wear_rig: Scenario, held: tuple[Features, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object, **__: object) -> None:
        raise SimulationError("the shaft stands still")

    monkeypatch.setattr(untold_runs, "simulated_runs", failing)
    assert not flat_in_the_model_alone(wear_rig.rig, limited(wear_rig.rig, 1.2 * highest(held), load=3.0), held)
