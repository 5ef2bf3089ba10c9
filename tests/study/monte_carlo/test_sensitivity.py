"""Sensitivity to open values: indices of closed forms, the value that decides, and designs that repeat nothing."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.reporting.study.sensitivity_text import asked_first_text, spoken, too_few_text
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.monte_carlo.design import Design, Method, _sampled, design_of
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, drawn_study, error_column
from torquerig.study.monte_carlo.ranking import Ranking
from torquerig.study.monte_carlo.sensitivity import Sensitivity, sensitivity

SMALL = (
    "study.motors=[bldc-12n14p, HDS6A-0104A]", "study.gearboxes=[reference-5-1]", "study.filters.names=[none]",
    "study.present.filter=none",
)  # fmt: skip
FIRST, SECOND = "bldc-12n14p 5:1", "HDS6A-0104A 5:1"


@cache
def drawn() -> DrawnStudy:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return drawn_study(open_study(overridden(document, SMALL), load_catalog(shipped_folder())))


def design(method: Method, count: int) -> Design:
    """Two values of the second drive and one of the first."""
    names = ("A.x", "B.y", "B.z")
    return Design(method, names, {FIRST: ("A.x",), SECOND: ("B.y", "B.z")}, _sampled(method, names, count, seed=1))


def found(method: Method, count: int) -> Sensitivity:
    """The first drive has the error x, the second 0.25 + 0.3 y + 0.1 z; the smaller error is best."""
    made = design(method, count)
    x, y, z = made.quantiles.T
    errors = np.array([x, 0.25 + 0.3 * y + 0.1 * z])
    ranking = Ranking(((FIRST, "none"), (SECOND, "none")), -errors.T, {})
    prices = {FIRST: 0.0, SECOND: 700.0}
    return sensitivity(made, {error_column("none"): errors}, ranking, prices=prices)


def test_sobol_indices_are_those_of_a_sum() -> None:
    effects = {(one.drive, one.name): one for one in found("sobol", 1024).effects}
    assert effects.keys() == {(FIRST, "A.x"), (SECOND, "B.y"), (SECOND, "B.z")}
    for key, share, deviation in (
        ((FIRST, "A.x"), 1.0, 1 / np.sqrt(12)),
        ((SECOND, "B.y"), 0.9, 0.3 / np.sqrt(12)),
        ((SECOND, "B.z"), 0.1, 0.1 / np.sqrt(12)),
    ):
        assert effects[key].total == pytest.approx(share, abs=0.03)
        assert effects[key].first == pytest.approx(share, abs=0.05)
        assert effects[key].error == pytest.approx(deviation, rel=0.05)


def test_morris_effects_are_the_slopes_of_a_sum() -> None:
    effects = {one.name: one.error for one in found("morris", 20).effects}
    assert effects == pytest.approx({"A.x": 1.0, "B.y": 0.3, "B.z": 0.1})


def test_the_value_that_decides_is_asked_for_first() -> None:
    """The best drive changes where x and x' are on two sides of c = 0.25 + 0.3 y + 0.1 z: 2 E[c (1 - c)]."""
    made = found("sobol", 1024)
    c = (
        0.25
        + 0.3 * np.random.default_rng(1).uniform(size=100_000)
        + 0.1 * np.random.default_rng(2).uniform(size=100_000)
    )
    assert made.decisive[0].name == "A.x"
    assert made.decisive[0].share == pytest.approx(2 * np.mean(c * (1 - c)), abs=0.02)
    assert made.decisive[0].price == pytest.approx(700)
    text = asked_first_text(made, unit="N*m")
    assert text.startswith("Ask for x of A first: alone it changes which drive is best in")
    assert "700 EUR" in text
    assert too_few_text(made) == ""
    assert "too few" in too_few_text(replace(made, effects=(replace(made.effects[0], total_reach=2.0),)))


def test_a_drive_is_computed_only_where_it_changes() -> None:
    made = design("sobol", 8)
    rows = len(made.quantiles)
    assert rows == 8 * 5
    cases = made.cases(drawn())
    per_drive = [sum(case.values["drive"] == name for case in cases) for name in (FIRST, SECOND)]
    assert per_drive == [8 * 2, 8 * 4]
    values = np.arange(2.0 * rows).reshape(2, rows)
    filled = made.filled({"error": np.where(np.isin(values, _numbers(made)), values, np.nan)})["error"]
    assert np.isfinite(filled).all()
    x = made.quantiles[:, 0]
    for row in range(rows):
        same = np.flatnonzero(x == x[row])
        assert (filled[0, same] == filled[0, row]).all()


def _numbers(made: Design) -> list[float]:
    rows = len(made.quantiles)
    return [at * rows + row for at, name in enumerate(made.of_drive) for row in set(made.source(name).tolist())]


def test_more_base_points_continue_a_sobol_design() -> None:
    few, many = design("sobol", 8), design("sobol", 16)
    assert few.plan == many.plan
    numbers = {case.number: case for case in many.cases(drawn())}
    assert all(numbers[case.number] == case for case in few.cases(drawn()))
    assert design("morris", 8).plan != design("morris", 9).plan


def test_only_values_that_change_the_rig_are_varied() -> None:
    made = design_of(drawn(), "morris", 2)
    assert not any("price" in name for name in made.names)
    assert "HDS6A-0104A.rotor_inertia" in made.of_drive[SECOND]
    assert all(name.startswith(("HDS6A", "bldc")) for name in made.names)
    assert spoken("HDS6A-0104A.ripple.cogging_native") == "ripple cogging native of HDS6A-0104A"


def test_a_count_that_no_sobol_design_has_is_refused() -> None:
    with pytest.raises(InputError, match="needs a power of two; write 8 or 16"):
        design_of(drawn(), "sobol", 12)


def test_a_row_without_an_error_is_said() -> None:
    made = design("sobol", 8)
    errors = np.full((2, len(made.quantiles)), np.nan)
    ranking = Ranking(((FIRST, "none"), (SECOND, "none")), np.zeros((len(made.quantiles), 2)), {})
    with pytest.raises(InputError, match=r"bldc-12n14p 5:1 has no reading error in 40 of 40 rows"):
        sensitivity(made, {error_column("none"): errors}, ranking, prices={})
