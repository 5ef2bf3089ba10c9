"""``torquerig reference-results`` on short runs of three cells: what it prints, the page it writes, what it refuses."""

from pathlib import Path

import pytest

from torquerig.cli import main
from torquerig.study.reference_report.published import CELLS

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


@pytest.fixture(autouse=True)
def short(monkeypatch, tmp_path):
    """Two seconds instead of ten, one copy instead of three, three cells of nine."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("torquerig.study.reference_report.conditions.DURATION", 2.0)
    monkeypatch.setattr("torquerig.study.reference_report.cells.RUNS", 1)
    few = (CELLS[0], CELLS[3], CELLS[6])
    for room in ("results", "fitting"):
        monkeypatch.setattr(f"torquerig.study.reference_report.{room}.OCCUPANCIES", (5.0, 21.0))
    monkeypatch.setattr("torquerig.study.reference_report.results.CELLS", few)


@pytest.mark.long
def test_it_prints_every_cell_and_writes_the_same_page_twice(tmp_path, capsys):
    main(("reference-results", str(SCENARIOS / "wear_rig.yaml"), "--out", "first.html"))
    told = capsys.readouterr().out
    assert "held out" in told
    assert "Three parameters are free" in told
    assert "orders without lines" in told
    assert "59 %" in told
    main(("reference-results", str(SCENARIOS / "wear_rig.yaml"), "--out", "second.html"))
    first, second = ((tmp_path / name).read_bytes() for name in ("first.html", "second.html"))
    assert first == second
    page = first.decode()
    for number in ("4.1", "4.2", "4.3", "4.4", "4.5", "4.6", "4.7", "4.8", "4.9", "4.10", "4.11", "4.12"):
        assert number in page
    assert page.count("data:image/svg+xml") == 9
    assert "http://" not in page.replace("http://www.w3.org", "")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--out", "nowhere/page.html"), "there is no folder"),
        (("--out", "there.html"), "overwrite it with --force"),
        (("--set", "operating_point.profile=ramp"), "write profile: steady"),
        (("no_such.yaml",), "no_such.yaml"),
    ],
)
def test_what_cannot_be_done_is_refused(tmp_path, capsys, arguments, said):
    (tmp_path / "there.html").write_text("mine")
    with pytest.raises(SystemExit) as left:
        main(("reference-results", *arguments))
    assert left.value.code == 2
    assert said in capsys.readouterr().err
    assert (tmp_path / "there.html").read_text() == "mine"
