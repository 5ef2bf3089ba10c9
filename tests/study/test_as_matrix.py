"""A study written as a matrix: read back it is the same case, it can be edited, and every cell keeps its way."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.decide.case import MatrixCase
from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.excel_matrix import read_excel_matrix
from torquerig.decide.matrix_io.matrix_file import matrix_from
from torquerig.decide.trace import trace
from torquerig.decide.verdict import Certainty
from torquerig.document import read_document
from torquerig.reporting.matrix.files import write_matrix
from torquerig.scenario.overrides import overridden
from torquerig.study.as_matrix import as_matrix
from torquerig.study.definition import open_study
from torquerig.study.run_study import run_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.verdict import verdict

WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")
SMALL = (
    "study.duration=1 s", "study.draws=1", "study.motors=[bldc-12n14p, HDS6A-0104A, GP-71M]",
    "study.gearboxes=[reference-5-1]", "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip
BEST, DATUM = "bldc-12n14p 5:1 | low_pass_20Hz", "bldc-12n14p 5:1 | none"


@cache
def small() -> Decided:
    study = open_study(overridden(read_document(Path(WEAR_RIG)), SMALL), load_catalog(shipped_folder()))
    return decide(run_study(study))


def case() -> MatrixCase:
    return as_matrix(small(), name="wear rig", seed=1)


@pytest.mark.long
def test_each_drive_that_is_left_stands_in_it_with_its_best_filter_and_the_present_one_as_datum() -> None:
    made = case()
    assert made.baseline == DATUM
    assert len(made.matrix.alternatives) == 3
    assert {BEST, DATUM} < set(made.matrix.alternatives)
    assert [one.name for one in made.matrix.criteria][-4:] == [
        "speed reserve", "sensor torque", "continuous torque", "servo motor",
    ]  # fmt: skip


def test_it_says_what_the_study_says() -> None:
    worked, answer = analyse_matrix(case()), verdict(small())
    # the matrix does not know that its baseline is on the rig, where its open requirement holds a fact and no choice
    assert worked.verdict.certainty is Certainty.OPEN
    assert worked.verdict.certainty_if_met is answer.certainty
    assert worked.verdict.winners == (answer.winner,)
    assert worked.missing[0].fact == answer.facts[0].fact == "whether bldc-12n14p is a servo motor"


@pytest.mark.parametrize("ending", [".yaml", ".xlsx"])
def test_what_is_written_is_the_same_case_with_the_same_way_of_each_cell(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"drives{ending}"
    worked = analyse_matrix(case())
    write_matrix(worked, path)
    again = analyse_matrix(matrix_from(read_excel_matrix(path) if ending == ".xlsx" else read_document(path)))
    assert again.overall.total == pytest.approx(worked.overall.total, rel=1e-12)
    for criterion in ("reading error", "price", "servo motor"):
        told = trace(again, BEST, criterion)
        assert told == trace(worked, BEST, criterion)
    assert len(trace(again, BEST, "reading error").texts("catalog")) > 20


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--matrix", "drives.pdf"), "drives.pdf: a matrix is written as .html, .md, .xlsx, .yaml"),
        (("--matrix", "there.yaml"), "there.yaml: is there already"),
        (("--matrix", "drives.yaml", "--all-points"), "remove --all-points"),
        (
            ("--trace", "bldc-12n14p 5:1", "prize"),
            "the study has no criterion or requirement 'prize'; did you mean 'price'",
        ),
    ],
)
def test_a_bad_call_is_one_sentence_before_anything_is_simulated(
    arguments: tuple[str, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    Path("there.yaml").write_text("kept")
    with pytest.raises(SystemExit) as stopped:
        main(["compare", WEAR_RIG, *arguments])
    assert stopped.value.code == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    assert said in told.err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["there.yaml"]
    assert Path("there.yaml").read_text() == "kept"
