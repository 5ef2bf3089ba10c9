"""What no fit has seen is foretold best by the rig itself, not by one that calls all of it chance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import robust_squares
from torquerig.diagnosis.judging import held_out as judged
from torquerig.diagnosis.judging.held_out import held_out
from torquerig.diagnosis.looking.features import Features
from torquerig.errors import SimulationError
from torquerig.mechanisms import ParticleLoad
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario


def loaded(rig: Rig, *, by: float = 1.0, chance: float = 1.0) -> Rig:
    """The rig with another mean of its load, and another part of it called chance."""
    (load,) = rig.parts_of(ParticleLoad)
    means = {percent: mean * by for percent, mean in load.mean_by_occupancy_percent.items()}
    return rig.changed(replace(load, mean_by_occupancy_percent=means, slow_rms=load.slow_rms * chance))


def test_a_wide_guess_foretells_less(
    wear_rig: Scenario, held: tuple[Features, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A wrong mean that three times as much chance excuses misses less than the rig itself, and is no better."""

    def refused(*_: object, **__: object) -> None:
        raise SimulationError("the shaft stands still")

    monkeypatch.setattr(judged, "simulated_runs", refused)
    true, wide = wear_rig.rig, loaded(wear_rig.rig, by=1.1, chance=3.0)
    missed = [sum(robust_squares(run.all()).sum() for run in misfits_of(rig, held)) for rig in (true, wide)]
    fit = held_out(true, true, wide, held, seed=1)
    assert fit.by_twin
    assert missed[1] < missed[0]
    assert fit.after > fit.before == fit.nominal


@pytest.mark.long
def test_the_improvement_is_of_the_mean_squares(wear_rig: Scenario, held: tuple[Features, ...]) -> None:
    true = wear_rig.rig
    fit = held_out(true, loaded(true, by=1.5), true, held, seed=1)
    assert fit.after == fit.nominal
    assert fit.improvement[0] == pytest.approx(1 - fit.after / fit.before)
    assert fit.improvement[1] < fit.improvement[0] < fit.improvement[2]


@pytest.mark.long
def test_a_run_of_a_load_that_no_fit_has_seen_is_judged_by_its_values_alone(
    wear_rig: Scenario, held: tuple[Features, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its spectrum would compare nothing but the guess at its load: here one is wrong by half."""
    monkeypatch.setattr(judged, "SEEDS", (101,))
    wrong, untold = loaded(wear_rig.rig, by=1.5), [each.observed.name for each in held[1:]]
    told, _ = judged._by_simulation(wrong, held, flying=False, untold=untold)
    every, _ = judged._by_simulation(wrong, held, flying=False, untold=())
    first, _ = judged._by_simulation(wrong, held[:1], flying=False, untold=())
    assert told[: first.size] == pytest.approx(every[: first.size])
    assert told.size == first.size + 3 * len(untold), "the distribution of values has three features"
    assert told.mean() < every.mean()


@pytest.mark.parametrize("blown", [[], [40_000]])
def test_blows_leave_bands_of_a_steady_run_and_lines_of_a_ramp_to_chance_wherever_the_run_shows_them(
    blown: list[int], wear_rig: Scenario, held: tuple[Features, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Shown where fits may see them alone, they are chance of what is held out as well, for every model alike."""
    monkeypatch.setattr(judged, "blows", lambda _, *, held: blown if held is None else [])
    steady, model = held[0], expected(wear_rig.rig, held[0])
    recording = steady.observed.recording
    moving = replace(steady.observed, recording=replace(recording, run=replace(recording.run, profile="ramp")))
    widened = judged._left_to_blows(model, steady, copies=2)
    assert bool(np.all(widened.power_tolerance > 1.0)) == bool(blown)
    freed = judged._left_to_blows(model, replace(steady, observed=moving), copies=2)
    assert bool(np.all(freed.variance > model.variance)) == bool(blown)
    assert np.array_equal(freed.power_tolerance, model.power_tolerance)
