"""Old names are still read, each with one notice on standard error."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig import renamed
from torquerig.catalog.ripple import KnownLines
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import COMMANDS, main
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.filters.chains.chain_file import read_chains
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.study.settings import Filters, RequirementRow

DRIVE = Kinematics(pole_pairs=7, slots=12, ratio=5)
OLD = """
filters:
  seed_code:
    - {type: ideal_bandstop, half_width: 0.5 Hz,
       lines: {cogging_as_published: 1..4, unknown_as_published: 1..4, motor: 1..4, shaft: 1..4, electrical: 1..4}}
"""


@pytest.fixture(autouse=True)
def _nothing_noted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(renamed, "_NOTED", set())


def test_a_present_name_gives_no_notice(capsys: pytest.CaptureFixture[str]) -> None:
    assert renamed.current_name("new", {"old": "new"}, what="thing") == "new"
    assert capsys.readouterr().err == ""


def test_an_old_name_gives_one_notice_however_often_it_is_read(capsys: pytest.CaptureFixture[str]) -> None:
    assert [renamed.current_name("old", {"old": "new"}, what="thing") for _ in range(3)] == ["new"] * 3
    assert capsys.readouterr().err == "torquerig: notice: the thing old is now named new\n"


@pytest.mark.parametrize("old", ["seed-results", "seed-decision"])
def test_an_old_command_is_the_present_one(old: str, capsys: pytest.CaptureFixture[str]) -> None:
    present = old.replace("seed", "reference")
    assert present in COMMANDS
    assert old not in COMMANDS
    main([old, "--help"])
    told = capsys.readouterr()
    main([present, "--help"])
    assert told.out == capsys.readouterr().out
    assert told.err == f"torquerig: notice: the command {old} is now named {present}\n"


def test_chains_and_line_families_in_yaml_are_read_under_their_old_names(capsys: pytest.CaptureFixture[str]) -> None:
    shipped = read_chains(shipped_scenarios() / "filters.yaml", kinematics=DRIVE)
    assert capsys.readouterr().err == ""
    read = read_chains(parse_document(OLD, Path("f.yaml")), kinematics=DRIVE)
    assert dict(read) == {"report_filter_code": shipped["report_filter_code"]}
    assert capsys.readouterr().err.splitlines() == [
        "torquerig: notice: the line family cogging_as_published is now named cogging_per_pole",
        "torquerig: notice: the line family unknown_as_published is now named slots_times_pole_pairs",
        "torquerig: notice: the filter chain seed_code is now named report_filter_code",
    ]


def test_a_chain_or_family_under_both_names_is_refused() -> None:
    twice = OLD + "  report_filter_code: []\n"
    with pytest.raises(InputError, match="seed_code is the old name of report_filter_code"):
        read_chains(parse_document(twice, Path("f.yaml")), kinematics=DRIVE)
    twice = OLD.replace("motor: 1..4", "cogging_per_pole: 1..4")
    with pytest.raises(InputError, match="old and its present name"):
        read_chains(parse_document(twice, Path("f.yaml")), kinematics=DRIVE)


def test_a_study_reads_old_chain_names(capsys: pytest.CaptureFixture[str]) -> None:
    filters = Filters.model_validate({"file": "filters.yaml", "names": ["none", "seed_code", "seed_text"]})
    assert filters.names == ("none", "report_filter_code", "report_filter_text")
    assert len(capsys.readouterr().err.splitlines()) == 2


def test_the_old_option_is_hidden_and_still_read(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["filter", "nowhere.csv", "--judge"])
    assert "torquerig: notice: the option --judge is now named --evaluate\n" in capsys.readouterr().err
    main(["filter", "--help"])
    told = capsys.readouterr().out
    assert "--evaluate" in told
    assert "--judge" not in told


def test_the_catalog_reads_an_old_key(capsys: pytest.CaptureFixture[str]) -> None:
    line = {"value": "0.02 N*m", "evidence": "REF", "source": "a rig"}
    old, present = (KnownLines.model_validate({key: {6: line}}) for key in ("cogging_as_published", "cogging_per_pole"))
    assert old == present
    assert capsys.readouterr().err.count("cogging_as_published is now named cogging_per_pole") == 1
    with pytest.raises(ValueError, match="old and its present name"):
        KnownLines.model_validate({"cogging_as_published": {6: line}, "cogging_per_pole": {6: line}})


def test_a_study_reads_the_old_name_of_a_metric(capsys: pytest.CaptureFixture[str]) -> None:
    row = {"metric": "left_disturbance", "unit": "N*m", "max": 0.1, "purpose": "quiet"}
    assert RequirementRow.model_validate(row).metric == "residual_disturbance"
    assert capsys.readouterr().err == (
        "torquerig: notice: the metric left_disturbance is now named residual_disturbance\n"
    )
