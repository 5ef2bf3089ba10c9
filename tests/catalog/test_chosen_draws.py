"""A seed with stated quantiles: those draws follow them, all others are as without."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.catalog.chosen_draws import ChosenDraws, draws_of
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.sampling import sample_entry
from torquerig.catalog.shipped import shipped_folder
from torquerig.parameter import Estimate
from torquerig.recordings.recording import random_for

MOTOR = load_catalog(shipped_folder()).motor("HDS6A-0104A")


def test_without_quantiles_the_draws_are_those_of_the_seed() -> None:
    assert sample_entry(MOTOR, ChosenDraws(3)).values == sample_entry(MOTOR, 3).values


def test_a_stated_quantile_changes_its_value_alone() -> None:
    name = f"{MOTOR.stands_for or MOTOR.name}.rotor_inertia"
    low, high = MOTOR.rotor_inertia.bounds
    for at, wanted in ((0.0, low), (1.0, high)):
        chosen, free = sample_entry(MOTOR, ChosenDraws(3, {name: at})).values, sample_entry(MOTOR, 3).values
        assert chosen["rotor_inertia"] == pytest.approx(wanted)
        assert {key for key in free if chosen[key] != free[key]} == {"rotor_inertia"}


def test_each_kind_of_estimate_is_drawn_at_a_quantile() -> None:
    seed = ChosenDraws(1, {"x": 0.5})
    assert Estimate(low=1.0, high=100.0).draw(draws_of(seed, "x")) == pytest.approx(10.0)
    assert Estimate(low=2.0, high=4.0).draw(draws_of(seed, "x")) == 3.0
    assert Estimate(choices=(1.0, 2.0, 7.0)).draw(draws_of(seed, "x")) == 2.0
    assert Estimate(value=5.0, rel_sd=0.1).draw(draws_of(seed, "x")) == 5.0
    assert draws_of(ChosenDraws(1, {"x": 1.0}), "x").integers(4) == 3


def test_the_draws_that_were_made_are_known_and_stated_values_are_none() -> None:
    seed = ChosenDraws(1)
    Estimate(value=5.0).draw(draws_of(seed, "stated"))
    drawn = Estimate(low=2.0, high=4.0).draw(draws_of(seed, "open"))
    assert list(seed.drawn) == ["open"]
    assert drawn == Estimate(low=2.0, high=4.0).draw(random_for(1, "open"))
    assert np.isfinite(drawn)
