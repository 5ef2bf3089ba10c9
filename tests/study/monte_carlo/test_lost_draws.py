"""Draws at which a speed loop is unstable have no reading error, and the study says how many there are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from torquerig.cases import ThisProcess
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.reporting.study.answers import narrow_loops
from torquerig.reporting.study.draws_text import lost_draws_text
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import scenario_of
from torquerig.study.definition import open_study
from torquerig.study.loop_margin import has_stable_loop
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, drawn_study
from torquerig.study.monte_carlo.running import run_draws
from torquerig.study.planned_drive import planned_drive
from torquerig.study.preflight import margin_of
from torquerig.study.results import StudyRuns

CALM, LIGHT, DRAWS = "ESM013B-152-304", "HDS6A-0104A", 5
# at 14 Hz and 1 kHz the light motor is stable at the first draw and unstable at others
EDITS = (
    f"study.motors=[{CALM}, {LIGHT}]", "study.speed_loop.crossover=14 Hz", "study.seed=7", "study.duration=1 s",
    "study.filters.names=[none]",
)  # fmt: skip


@pytest.fixture(scope="module")
def drawn() -> DrawnStudy:
    document = overridden(read_document(shipped_scenarios() / "shaft_line_design.yaml"), EDITS)
    return drawn_study(open_study(document, load_catalog(shipped_folder())))


def test_the_quick_test_of_stability_is_that_of_the_margin(drawn: DrawnStudy) -> None:
    found = []
    for drive in drawn.drives:
        for seed in range(7, 7 + DRAWS):
            scenario = drawn.scenario(drive, seed=seed)
            margin = margin_of(scenario, drawn.study)
            assert margin is not None
            found.append(has_stable_loop(scenario.rig, rate=scenario.recording.sample_rate))
            assert found[-1] == margin.stable
    assert any(found)
    assert not all(found)


def test_an_unstable_draw_has_no_reading_error_and_is_counted(drawn: DrawnStudy, tmp_path: Path) -> None:
    found = run_draws(drawn, DRAWS, folder=tmp_path / "store", engine=ThisProcess(), seconds=None)
    rows = found.run.rows()
    light = rows[rows["drive"] == LIGHT]
    unstable = light["out_of_reach"].fillna("").str.startswith("its speed loop is unstable at this draw")
    assert 0 < unstable.sum() < DRAWS
    assert light["reading_error_none"][unstable].isna().all()
    assert light["reading_error_none"][~unstable].notna().all()
    assert list(found.lost) == [LIGHT]
    count = int(unstable.sum())
    assert (found.lost[LIGHT].unstable, found.lost[LIGHT].draws) == (count, DRAWS)
    text = " ".join(lost_draws_text(found.lost).split())
    assert text == (
        f"{LIGHT} has an unstable speed loop at {count} ({count / DRAWS:.1%}) of its {DRAWS} draws; these have no "
        "reading error. Lower study: speed_loop: crossover."
    )


def test_compare_leaves_unstable_samples_out_and_says_how_many(drawn: DrawnStudy) -> None:
    study = replace(drawn.study, settings=drawn.study.settings.model_copy(update={"draws": DRAWS - 1}))
    seed = study.settings.seed
    planned = {
        name: planned_drive(one, scenario_of(one, study, seed=seed), study) for name, one in drawn.drives.items()
    }
    light = planned[LIGHT]
    stable = [
        number for number in range(DRAWS)
        if has_stable_loop(drawn.scenario(LIGHT, seed=seed + number).rig, rate=1000.0)
    ]  # fmt: skip
    assert [one.seed - seed for one in light.samples] == stable
    assert light.result.unstable_samples == DRAWS - len(stable) > 0
    assert planned[CALM].result.unstable_samples == 0
    runs = StudyRuns(
        study=study, drives=(light.result, planned[CALM].result), mean_load=1.0, occupancy_percent=5.0,
        particle_size=5e-4, output_speed=1.0,
    )  # fmt: skip
    (sentence,) = narrow_loops(runs)
    assert sentence == (
        f"{LIGHT}: its speed loop is unstable in {light.result.unstable_samples} of {DRAWS} samples of the catalog, "
        "which have no part in its figures; lower study: speed_loop: crossover."
    )


def test_nothing_is_said_where_every_draw_has_a_figure() -> None:
    assert lost_draws_text({}) == ""
