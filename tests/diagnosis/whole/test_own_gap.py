"""A gap that the scenario states: closed for the search, opened again as it was found, and no finding."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from torquerig.diagnosis.own_gap import closed
from torquerig.mechanisms import Backlash
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Gear
from torquerig.scenario.model import Scenario

STATED, FOUND = (arcmin * pi / 180 / 60 for arcmin in (4.0, 6.5))


def with_gap(rig: Rig, *, in_gear: bool) -> Rig:
    gear = rig.part("gearbox")
    assert isinstance(gear, Gear)
    return rig.changed(replace(gear, backlash=STATED)) if in_gear else rig + Backlash(name="play", gap=STATED)


def width(rig: Rig) -> float:
    gear = rig.part("gearbox")
    assert isinstance(gear, Gear)
    return gear.backlash + sum(part.gap for part in rig.parts_of(Backlash))


@pytest.mark.parametrize("in_gear", [True, False], ids=["in the gear", "a part of its own"])
def test_closed_and_opened_again_where_it_was(in_gear: bool, wear_rig: Scenario) -> None:
    rig = with_gap(wear_rig.rig, in_gear=in_gear)
    shut, gap = closed(rig)
    assert gap is not None
    assert (width(shut), gap.stated, gap.told(shut)) == (0.0, STATED, None)
    again = gap.reopened(shut)
    assert {part.name: part for part in again.parts} == {part.name: part for part in rig.parts}
    assert width(gap.reopened(shut, width=FOUND)) == pytest.approx(FOUND)


@pytest.mark.parametrize("in_gear", [True, False], ids=["in the gear", "a part of its own"])
def test_a_width_that_was_found_takes_the_place_of_the_stated_one(in_gear: bool, wear_rig: Scenario) -> None:
    shut, gap = closed(with_gap(wear_rig.rig, in_gear=in_gear))
    assert gap is not None
    found = shut + Backlash(name="backlash", gap=FOUND)
    assert gap.told(found) == FOUND
    opened = gap.reopened(found)
    assert width(opened) == pytest.approx(FOUND)
    assert "backlash" not in {part.name for part in opened.parts}
    assert "4.0 arcmin" in gap.sentence(found)
    assert "6.5 arcmin" in gap.sentence(found)
    assert "do not determine another width" in gap.sentence(shut + Backlash(name="backlash", gap=STATED))


def test_a_gear_without_a_gap_has_none(wear_rig: Scenario) -> None:
    assert closed(wear_rig.rig) == (wear_rig.rig, None)
