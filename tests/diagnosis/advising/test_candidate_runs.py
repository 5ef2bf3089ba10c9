"""The menu of runs that might be done next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np

from torquerig.diagnosis.advising.candidate_runs import candidate_runs
from torquerig.diagnosis.looking.observed import Observed
from torquerig.scenario.model import Scenario

RATE = 500.0


def run_at(by_hand: Callable[..., Observed], rpm: float, *, occupancy: float, profile: str = "steady") -> Observed:
    angle = rpm / 60 * 2 * pi * np.arange(1500) / RATE
    made = by_hand(np.zeros(1500), angle, rate=RATE, profile=profile)
    return replace(made, recording=replace(made.recording, run=replace(made.run, occupancy_percent=occupancy)))


def test_a_menu_goes_from_least_effort_to_most(by_hand: Callable[..., Observed], wear_rig: Scenario) -> None:
    menu = candidate_runs(wear_rig.rig, [run_at(by_hand, 1000, occupancy=5.0)])
    words = [one.words for one in menu]
    assert words[:4] == [
        "Repeat at 720 rpm",
        "Repeat at 1290 rpm",
        "Repeat at 1000 rpm at idle",
        "Repeat at 1000 rpm with an occupancy of 11 %",
    ]
    assert words[-2].startswith("Record a ramp up to 1000 rpm")
    assert words[-1].startswith("Record a reversal with an amplitude of 1000 rpm")
    assert len(set(words)) == len(words)
    assert [one.run.profile for one in menu[-3:]] == ["steady", "ramp", "reversal"]


def test_what_was_done_is_not_asked_again(by_hand: Callable[..., Observed], wear_rig: Scenario) -> None:
    done = [
        run_at(by_hand, 1000, occupancy=5.0),
        run_at(by_hand, 1000, occupancy=0.0),
        run_at(by_hand, 725, occupancy=5.0),
        run_at(by_hand, 1000, occupancy=5.0, profile="ramp"),
    ]
    words = [one.words for one in candidate_runs(wear_rig.rig, done)]
    assert "Repeat at 720 rpm" not in words
    assert "Repeat at 1000 rpm at idle" not in words
    assert not [text for text in words if "ramp" in text]
    assert "Repeat at 720 rpm at idle" in words
