"""Every cell of a study leads back to the catalog, and what is told of it is what the engines used."""

from __future__ import annotations

from functools import cache

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.decide.trace import CellTrace
from torquerig.document import read_document
from torquerig.errors import UnknownNameError
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.planned_drive import settling_of
from torquerig.study.rated_drives import feasible_combinations, rated_drives
from torquerig.study.run_study import drives_of, run_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.settings import SpeedLoopRule
from torquerig.study.trace import check_traced, traced_cell, traced_combinations, traced_drives
from torquerig.study.verdict import Verdict, verdict

CATALOG = load_catalog(shipped_folder())
SMALL = (
    "study.duration=1 s", "study.draws=1", "study.motors=[bldc-12n14p, HDS6A-0104A, GP-71M]",
    "study.gearboxes=[reference-5-1, economy-20-1]", "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip
NEW = "HDS6A-0104A 5:1"


def study(*settings: str) -> Study:
    return open_study(overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), (*SMALL, *settings)), CATALOG)


@cache
def small() -> tuple[Decided, Verdict]:
    decided = decide(run_study(study()))
    return decided, verdict(decided)


def of(alternative: str, name: str) -> CellTrace:
    return traced_cell(*small(), alternative, name)


@pytest.mark.long
def test_every_cell_has_its_way_and_every_rating_comes_from_the_catalog_or_says_why_not() -> None:
    traced = traced_combinations(*small())
    cells = [cell for one in traced for cell in (*one.criteria, *one.requirements)]
    assert len(traced) == 4 * 2 + 2  # GP-71M is no servo motor, and out of reach at 20:1
    assert len(cells) == 8 * 6 + 10 * 4
    for cell in cells:
        assert cell.texts("metric"), cell
        assert cell.texts("decision"), cell
        assert cell.texts("catalog") or cell.criterion in ("new parts", "price"), cell
    assert of("bldc-12n14p 5:1", "servo motor").texts("catalog") == ("whether bldc-12n14p is a servo motor: ?",)


@pytest.mark.long
def test_a_simulated_figure_rests_on_every_catalog_value_of_the_rig_with_interval_evidence_and_source() -> None:
    cell = of(f"{NEW} | low_pass_20Hz", "reading error")
    told = cell.texts("catalog")
    entry = CATALOG.motor("HDS6A-0104A")
    scenario = scenario_of(next(one for one in candidates(study()) if one.name == NEW), study(), seed=1)
    assert len(told) == len(scenario.taken)
    inertia = next(text for text in told if text.startswith("rotor inertia of HDS6A-0104A"))
    assert f"{entry.rotor_inertia.shown()}, in the first sample" in inertia
    assert f"[{entry.rotor_inertia.evidence}], from {entry.rotor_inertia.source}" in inertia
    assert any(text.startswith("ripple: cogging native of HDS6A-0104A") for text in told)
    assert any(text.startswith("stiffness of reference-5-1") for text in told)
    assert "behind the filter low_pass_20Hz" in cell.texts("metric")[0]


def test_the_values_taken_are_those_of_the_parts_and_what_the_scenario_states_is_not_among_them() -> None:
    for candidate in candidates(study()):
        scenario = scenario_of(candidate, study(), seed=1)
        for key, one in scenario.taken.items():
            part, _, field = key.partition(".")
            value = getattr(scenario.rig.part(part), field, None)
            if isinstance(value, float) and key != "motor.torque_limit":  # lowered for the sensor
                assert one.used == pytest.approx(value, rel=1e-9), key
    present = scenario_of(candidates(study())[0], study(), seed=1)
    assert "motor.torque_limit" not in present.taken  # stated in the scenario: 2 N m


def test_points_and_what_they_add_are_those_of_the_engine() -> None:
    decided, answer = small()
    result = decided.overall
    for name in result.alternatives:
        row = result.alternatives.index(name)
        added = 0.0
        for column, criterion in enumerate(result.criteria):
            cell = traced_cell(decided, answer, name, criterion)
            assert cell.texts("points")[0].startswith(f"{result.middle[row, column]:.3g}")
            added += float(cell.texts("weight")[0].rpartition("adds ")[2].removesuffix(" to T"))
        assert added == pytest.approx(result.total[row], abs=0.02)  # each term is told with three digits
        assert f"T {result.total[row]:.4g} of {result.ideal:.4g}" in cell.texts("total")[0]


def test_a_drive_alone_stands_for_its_best_filter_and_a_demand_for_the_drive() -> None:
    decided, _ = small()
    best = next(one for one in decided.ranked() if one.startswith(NEW))
    assert of(NEW, "price").alternative == best
    assert of(NEW, "servo motor").alternative == NEW
    price = of(NEW, "price")
    assert [text.partition(":")[0] for text in price.texts("catalog")] == [
        "price of HDS6A-0104A", "price of the drive of HDS6A-0104A",
    ]  # fmt: skip
    assert price.texts("value") == ("340..1300 [EUR]",)
    out = of("GP-71M 20:1", "speed reserve")
    assert out.texts("requirement")[0].startswith("- speed reserve >= 1")
    assert out.texts("decision") == ("eliminate",)


def test_the_catalog_values_of_a_drive_stand_once_with_all_that_rests_on_them() -> None:
    for one in traced_drives(*small()):
        names = [origin.name for origin, _ in one.origins]
        assert len(set(names)) == len(names)
        used = {origin.name: used for origin, used in one.origins}
        if one.drive == NEW:
            assert used["rated torque of HDS6A-0104A"] == ("torque reserve", "continuous torque")
            assert set(used["peak torque of HDS6A-0104A"]) == {"reading error", "disturbance", "sensor torque"}


@pytest.mark.parametrize(
    ("alternative", "name", "said"),
    [
        ("HDS6A-104B 5:1", "price", "did you mean 'HDS6A-0104A 20:1' or 'HDS6A-0104A 5:1'"),
        (NEW, "prize", "did you mean 'price'"),
        (f"{NEW} | low_pas_20Hz", "price", "did you mean 'low_pass_20Hz'"),
    ],
)
def test_an_unknown_cell_is_refused_before_the_study_runs_and_after_it(alternative: str, name: str, said: str) -> None:
    with pytest.raises(UnknownNameError, match=said):
        check_traced(study(), [(alternative, name)], drives_of(study()))
    with pytest.raises(UnknownNameError, match=said):
        of(alternative, name)


def test_an_eliminated_drive_has_no_points_to_trace() -> None:
    with pytest.raises(UnknownNameError, match="is eliminated and has no 'price'"):
        of("GP-71M 20:1", "price")


def test_one_engine_gives_the_verdict_of_a_study_and_of_some_of_its_drives() -> None:
    decided, answer = small()
    rated = rated_drives(decided, feasible_combinations(decided))
    assert (rated.verdict.certainty_if_met, rated.verdict.best_shares) == (answer.certainty, answer.best_shares)
    assert sum(answer.shares.values()) == pytest.approx(1)
    new = [name for name in feasible_combinations(decided) if not name.startswith("bldc")]
    others = rated_drives(decided, new)
    assert set(others.matrix.alternatives) <= set(new)
    assert "servo motor" in [one.name for one in others.matrix.criteria]


@pytest.mark.parametrize(("crossover", "corner", "seconds"), [(30, 1.5, 0.8), (3, 0.5, 2.4), (3, 0, 0.4)])
def test_a_slow_loop_gets_more_time_to_settle(crossover: float, corner: float, seconds: float) -> None:
    written = {"crossover": f"{crossover} Hz", "integral_corner": f"{corner} Hz"}
    assert settling_of(SpeedLoopRule.model_validate(written)) == seconds
