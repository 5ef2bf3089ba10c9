"""A rig in the phases of a run: those of its lines are found, and what is held out has no say in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.expecting.phased import phases_tell, with_phases_of
from torquerig.diagnosis.expecting.simulated import simulated
from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import Backlash, TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Gear
from torquerig.scenario.model import Scenario

RATE = 5000.0
AT = 1.1  # [rad] of order 1 of the output shaft


def phases(rig: Rig) -> dict[tuple[str, float], float]:
    return {(each.name, at): phase for each in rig.parts_of(TorqueRipple) for at, phase in each.phases.items()}


@pytest.fixture
def turned(known_rig: Scenario) -> tuple[Rig, tuple[str, float]]:
    """The rig with the strongest line of its wear part at a phase of its own."""
    ripple = max(known_rig.rig.parts_of(TorqueRipple), key=lambda each: max(each.amplitudes.values()))
    strongest = max(ripple.amplitudes, key=lambda at: ripple.amplitudes[at])
    return known_rig.rig.changed(replace(ripple, phases={**ripple.phases, strongest: AT})), (ripple.name, strongest)


def test_the_phases_of_a_run_are_found(turned: tuple[Rig, tuple[str, float]], by_hand: Callable[..., Observed]) -> None:
    rig, key = turned
    sheet = by_hand(np.zeros(int(6 * RATE)), 104.7 * np.arange(int(6 * RATE)) / RATE, rate=RATE)
    run = simulated(rig, replace(sheet, recording=replace(sheet.recording, run=rig.run)), seed=3)
    told = phases(with_phases_of(rig, run, held=False))
    assert np.angle(np.exp(1j * (told[key] - AT))) == pytest.approx(0.0, abs=0.1)
    other = run.torque.copy()
    other[run.mask(held=True)] = np.random.default_rng(1).standard_normal(int(run.mask(held=True).sum()))
    assert phases(with_phases_of(rig, replace(run, torque=other), held=False)) == pytest.approx(told)
    assert phases(with_phases_of(rig, replace(run, torque=other))) != pytest.approx(told)


@pytest.mark.parametrize("in_gear", [True, False], ids=["in the gear", "a part of its own"])
def test_phases_tell_where_flanks_part(in_gear: bool, known_rig: Scenario) -> None:
    rig = known_rig.rig
    gear = rig.part("gearbox")
    assert isinstance(gear, Gear)
    parting = rig.changed(replace(gear, backlash=1e-3)) if in_gear else rig + Backlash(name="play", gap=1e-3)
    assert (phases_tell(rig), phases_tell(parting)) == (False, True)
