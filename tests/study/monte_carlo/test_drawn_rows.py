"""Draws of a study: the figures of compare's samples, whatever the blocks; more draws are added to those there."""

from __future__ import annotations

import pickle
import shutil
from functools import cache
from pathlib import Path

import pytest

from torquerig.cases import ThisProcess
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import Study, open_study
from torquerig.study.monte_carlo.drawn_case import drawn_rows
from torquerig.study.monte_carlo.drawn_study import cases_of_draws, drawn_study
from torquerig.study.monte_carlo.running import run_draws
from torquerig.study.run_study import run_drive

CATALOG = load_catalog(shipped_folder())
SMALL = (
    "study.motors=[bldc-12n14p, HDS6A-0104A]", "study.gearboxes=[reference-5-1]", "study.draws=2",
    "study.duration=0.2 s", "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip


@cache
def study(*further: str) -> Study:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return open_study(overridden(document, (*SMALL, *further)), CATALOG)


@pytest.mark.long
def test_the_first_draws_are_the_samples_of_compare() -> None:
    drawn = drawn_study(study())
    name = "HDS6A-0104A 5:1"
    rows = drawn_rows(drawn, [case for case in cases_of_draws(drawn, 3) if case.values["drive"] == name])
    compared = run_drive(drawn.drives[name], study())
    for metric, figure in (
        ("disturbance", compared.disturbance),
        ("reading_error_low_pass_20Hz", compared.chains["low_pass_20Hz"].truth_error),
    ):
        values = sorted(float(row[metric]) for row in rows)  # type: ignore[index, arg-type]
        assert values == [figure.low, figure.value, figure.high]


@pytest.mark.long
def test_the_rows_do_not_depend_on_the_blocks() -> None:
    drawn = drawn_study(study())
    cases = cases_of_draws(drawn, 3)
    assert drawn_rows(drawn, cases) == [row for case in cases for row in drawn_rows(drawn, [case])]


@pytest.mark.long
def test_more_draws_are_added_to_those_that_are_there(tmp_path: Path) -> None:
    drawn = drawn_study(study())
    first = run_draws(drawn, 1, folder=tmp_path / "store", engine=ThisProcess(), seconds=None)
    more = run_draws(drawn, 2, folder=tmp_path / "store", engine=ThisProcess(), seconds=None)
    assert (first.run.computed, more.run.computed) == (2, 2)
    assert (more.tables["disturbance"][:, :1] == first.tables["disturbance"]).all()
    again = run_draws(drawn, 1, folder=tmp_path / "store", engine=ThisProcess(), seconds=None)
    assert again.run.computed == 0
    assert again.tables["disturbance"].shape == (2, 1)


@pytest.mark.parametrize(
    ("edit", "said"),
    [
        ("study.duration=0.3 s", "its study.duration is 0.2 s, this study's is 0.3 s"),
        ("study.seed=2", "its study.seed is 1, this study's is 2"),
        ("operating_point.load.occupancy=7 %", "its operating_point.load"),
        ("study.motors=[bldc-12n14p]", "its drives is"),
    ],
)
def test_a_store_of_another_study_is_refused(tmp_path: Path, edit: str, said: str) -> None:
    for asked in (study(), study(edit)):
        identity = drawn_study(asked).identity("draws")
        there = tmp_path / "study.json"
        if not there.exists():
            there.write_text(identity.as_json())
            continue
        from torquerig.cases.identity import refuse_other

        with pytest.raises(InputError, match=f"holds another study: {said}"):
            refuse_other(there.read_text(), identity, folder=tmp_path)


def test_a_weight_may_change_without_new_cases() -> None:
    first, other = (
        drawn_study(study(edit)).identity("draws") for edit in ("study.draws=2", "study.criteria.price.weight=0.3")
    )
    assert first == other


def test_what_is_drawn_of_each_drive_is_known_before() -> None:
    drawn = drawn_study(study())
    names = drawn.unknown["HDS6A-0104A 5:1"]
    assert "HDS6A-0104A.rotor_inertia" in names
    assert not any(name.startswith("bldc") for name in names)
    assert len(set(names)) == len(names)


@pytest.mark.long
def test_a_worker_needs_no_file_and_sees_no_change_of_one(tmp_path: Path) -> None:
    """What is kept of a drive comes from the files as the study read them, here and in a process that unpickles it."""
    copied = tmp_path / "shipped"
    shutil.copytree(shipped_folder(), copied / "catalogs")
    shutil.copytree(shipped_folder().parent / "scenarios", copied / "scenarios")
    document = overridden(read_document(copied / "scenarios" / "wear_rig.yaml"), SMALL)
    drawn = drawn_study(open_study(document, load_catalog(copied / "catalogs")))
    cases = cases_of_draws(drawn, 2)
    first = drawn_rows(drawn, cases)
    sent = pickle.dumps(drawn)
    shutil.rmtree(copied)
    assert drawn_rows(drawn, cases) == first
    assert drawn_rows(pickle.loads(sent), cases) == first
    assert drawn_rows(drawn_study(study()), cases) == first
