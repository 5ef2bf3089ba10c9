"""Pages of kept results: the same bytes as without them, and nothing is drawn twice."""

from __future__ import annotations

import gzip
from base64 import b64decode
from pathlib import Path

import pytest

from torquerig.cases.kept_results import KeptResults
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.reporting.figures import picture
from torquerig.reporting.moving import page_scripts
from torquerig.reporting.study.report import write_study_report
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide
from torquerig.study.verdict import verdict

TINY = (
    "study.duration=1 s", "study.draws=1", "study.motors=[bldc-12n14p, HDS5C-102A]",
    "study.gearboxes=[reference-5-1]", "study.filters.names=[none, report_filter_code]",
)  # fmt: skip
SAME_ORDER = "study.criteria.reading error.weight=0.36"

MARKS = ("/* BEGIN bokeh.min.js */", "/* END bokeh.min.js */")


def written(folder: Path, *settings: str, kept: KeptResults | None) -> dict[str, bytes]:
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), (*TINY, *settings))
    runs = run_study(open_study(document, load_catalog(shipped_folder())), kept=kept)
    decided = decide(runs)
    paths = write_study_report(runs, decided, verdict(decided), folder)
    return {path.name: path.read_bytes() for path in paths}


def test_a_page_of_kept_results_is_the_same_and_draws_what_has_changed_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[str] = []
    before = picture.svg

    def noted(figure):
        drawn.append("picture")
        return before(figure)

    monkeypatch.setattr(picture, "svg", noted)
    first = written(tmp_path / "first", kept=KeptResults(tmp_path / "kept"))
    count = len(drawn)
    assert count >= 5
    again = written(tmp_path / "again", kept=KeptResults(tmp_path / "kept"))
    assert len(drawn) == count
    changed = written(tmp_path / "changed", SAME_ORDER, kept=KeptResults(tmp_path / "kept"))
    assert len(drawn) == count  # the S-diagram needs no library
    assert first == again == written(tmp_path / "alone", kept=None)
    assert changed == written(tmp_path / "changed alone", SAME_ORDER, kept=None)
    assert changed["index.html"] != first["index.html"]


def test_the_packed_library_is_that_of_its_resources() -> None:
    from bokeh.resources import Resources

    text = "\n".join(Resources(mode="inline", components=["bokeh"]).js_raw)
    expected = "\n".join(line for line in text.split("\n") if line not in MARKS)
    assert gzip.decompress(b64decode(page_scripts._bokeh(None))).decode() == expected
