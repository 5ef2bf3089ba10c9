"""What comes and goes in a steady run: told where the recording has it and its finished rig, simulated, has not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging import passing as module
from torquerig.diagnosis.judging.passing import passing
from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import Quantization
from torquerig.rig.assembly import Rig

RATE, LENGTH = 10_000.0, 10.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
THERE = (TIME > 4.0) & (TIME < 4.8)


def rig_with(*parts: Quantization) -> Rig:
    return cast("Rig", SimpleNamespace(of_kind=lambda kind: [part for part in parts if part.kind == kind]))


RIG = rig_with()


@pytest.fixture
def run(by_hand: Callable[..., Observed]) -> Observed:
    noise = 0.01 * np.random.default_rng(4).standard_normal(TIME.size)
    return by_hand(1.0 + noise, 100.0 * TIME, rate=RATE)


def case_of(run: Observed) -> Case:
    return cast("Case", SimpleNamespace(runs=(run,)))


def test_a_steady_run_has_nothing_that_passes(run: Observed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "simulated", lambda *_, **__: pytest.fail("nothing asks for a simulation"))
    assert passing(case_of(run), RIG) == ()


@pytest.mark.parametrize("tone", [True, False])
def test_what_passes_is_placed(tone: bool, run: Observed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "simulated", lambda *_, **__: run)
    added = 0.05 * np.cos(2 * pi * 700 * TIME) if tone else 0.01 * np.random.default_rng(5).standard_normal(TIME.size)
    spoilt = replace(run, torque=run.torque + THERE * added)
    (found,) = passing(case_of(spoilt), RIG)
    assert (found.domain, found.recordings) == ("time", (run.name,))
    assert 3.9 < found.at < found.at + found.width < 4.9
    assert found.p_value < 1e-6
    if not tone:  # as much again of the same noise
        assert found.excess_dB == pytest.approx(3.0, abs=0.7)


def test_what_a_simulation_shows_too_is_the_rigs(run: Observed, monkeypatch: pytest.MonkeyPatch) -> None:
    spoilt = replace(run, torque=run.torque + THERE * 0.05 * np.cos(2 * pi * 700 * TIME))
    later = replace(run, torque=run.torque + np.roll(THERE, 20_000) * 0.05 * np.cos(2 * pi * 700 * TIME))
    monkeypatch.setattr(module, "simulated", lambda *_, **__: later)
    assert passing(case_of(spoilt), RIG) == ()


@pytest.mark.parametrize(("rig", "told"), [(RIG, 1), (rig_with(Quantization(name="codes", step=0.1)), 0)])
def test_a_coarse_code_that_rests_is_no_event(
    rig: Rig, told: int, run: Observed, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One sample in sixty reaches the next code, and for a while none does."""
    swing = np.where(THERE, 0.0, 0.018 * np.random.default_rng(6).standard_normal(TIME.size))
    resting = replace(run, torque=0.1 * np.round((run.torque + swing) / 0.1))
    monkeypatch.setattr(module, "simulated", lambda *_, **__: run)
    assert len(passing(case_of(resting), rig)) == told
