"""A load that is stated as even may vary all the same: how much, and how fast, is then for the fit to say."""

from __future__ import annotations

from dataclasses import replace

import pytest

from torquerig.inference.knobs import HARDLY_ANY, nuisance_knobs, with_free_load
from torquerig.mechanisms import ParticleLoad
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

HITS = ("hit_rms", "hit_decay")
SLOW = ("slow_rms", "slow_cutoff")


def load_of(rig: Rig) -> ParticleLoad:
    return rig.parts_of(ParticleLoad)[0]


def spreads(rig: Rig) -> dict[str, float]:
    knobs = nuisance_knobs(with_free_load(rig), {}, occupancies=(5.0,))
    return {knob.field: knob.spread for knob in knobs if knob.part == load_of(rig).name}


@pytest.mark.parametrize(("none", "free", "held"), [("hit_rms", HITS, SLOW), ("slow_rms", SLOW, HITS)])
def test_what_is_stated_as_none_is_free(
    none: str, free: tuple[str, ...], held: tuple[str, ...], wear_rig: Scenario
) -> None:
    rig = wear_rig.rig
    even = rig.changed(replace(load_of(rig), **{none: 0.0}))
    assert getattr(load_of(with_free_load(even)), none) == HARDLY_ANY, "a factor of nothing would stay nothing"
    stated, now = spreads(rig), spreads(even)
    assert all(now[field] > 2 * stated[field] for field in free)
    assert all(now[field] == stated[field] for field in held)


def test_a_stated_load_stays_as_it_is(wear_rig: Scenario) -> None:
    stated, free = load_of(wear_rig.rig), load_of(with_free_load(wear_rig.rig))
    assert (free.hit_rms, free.slow_rms) == (stated.hit_rms, stated.slow_rms)
