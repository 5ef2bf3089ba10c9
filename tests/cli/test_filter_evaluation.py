"""``torquerig filter --evaluate``: what it prints, the panels it draws, and what it refuses."""

import pytest

from torquerig.cli import main
from torquerig.recordings.files import write_recording


@pytest.fixture
def reading(tmp_path, monkeypatch):
    from pathlib import Path

    from torquerig.catalog.search import catalog_for
    from torquerig.document import read_document
    from torquerig.scenario.reading import read_scenario
    from torquerig.simulation.simulator import simulate
    from torquerig.simulation.true_lines import with_true_lines

    monkeypatch.chdir(tmp_path)
    scenario = Path(__file__).resolve().parents[2] / "scenarios" / "wear_rig.yaml"
    made = read_scenario(read_document(scenario), catalog_for(scenario, ()), seed=1)
    recording = with_true_lines(simulate(made.rig, duration=3.0, seed=1), made.rig, seed=1)
    write_recording(recording, tmp_path / "known.parquet")
    write_recording(recording.without_truth(), tmp_path / "measured.parquet")
    return tmp_path


def run(capsys, *arguments):
    main(arguments)
    return capsys.readouterr().out


def test_it_judges_by_truth_and_placebo_and_draws_signal_and_spectrum(reading, capsys):
    told = run(capsys, "filter", "known.parquet", "--chain", "report_filter_code", "--evaluate")
    assert "positions without lines" in told
    assert "error to the true load" in told
    assert "100-200 Hz N*m" in told
    assert "energy %" in told
    assert "largest hits" in told
    assert "Step response: " in told
    assert "perfect line removal" in told
    assert "times that of perfect line removal" in told
    drawn = (reading / "known.report_filter_code.evaluation.svg").read_bytes()
    assert drawn.startswith(b"<?xml")
    run(capsys, "filter", "known.parquet", "--chain", "report_filter_code", "--evaluate", "--force")
    assert (reading / "known.report_filter_code.evaluation.svg").read_bytes() == drawn


def test_without_truth_it_says_so_and_still_sets_the_placebo_beside(reading, capsys):
    chosen = ("--chain", "report_filter_code", "--evaluate", "--picture", "mine.png")
    told = run(capsys, "filter", "measured.parquet", *chosen)
    assert "true load is unknown" in told
    assert "positions without lines" in told
    assert (reading / "mine.png").read_bytes().startswith(b"\x89PNG")


def test_in_blocks_it_judges_a_stretch_from_the_middle(reading, capsys):
    told = run(capsys, "filter", "known.parquet", "--chain", "none", "--block", "1 s", "--evaluate")
    assert "none, evaluated on 1 s, a section from the middle:" in told


def test_a_chain_without_lines_has_no_placebo(reading, capsys):
    told = run(capsys, "filter", "known.parquet", "--chain", "low_pass_20Hz", "--evaluate")
    assert "No placebo test" in told


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--evaluate", "--picture", "one.svg"), "--picture needs exactly one --chain"),
        (("--chain", "report_filter_code", "--evaluate", "--picture", "one.pdf"), "written as .svg or .png"),
        (("--chain", "report_filter_code", "--evaluate", "--picture", "there.svg"), "overwrite it with --force"),
    ],
)
def test_what_cannot_be_drawn_is_refused_before_the_work(reading, capsys, arguments, said):
    (reading / "there.svg").write_text("mine")
    with pytest.raises(SystemExit) as left:
        main(("filter", "known.parquet", *arguments))
    assert left.value.code == 2
    assert said in capsys.readouterr().err
    assert (reading / "there.svg").read_text() == "mine"
