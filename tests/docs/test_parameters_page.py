"""The page of parameters is what its script prints from the declarations in the code."""

from __future__ import annotations

import runpy
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"


def test_the_committed_page_is_what_the_script_prints() -> None:
    printed = runpy.run_path(str(DOCS / "parameters.py"))["page"]()
    committed = (DOCS / "parameters.md").read_text(encoding="utf-8")
    assert committed == printed, "run: python docs/parameters.py > docs/parameters.md"


def test_the_page_names_every_kind_that_a_scenario_may_use() -> None:
    from torquerig.scenario.reading import KINDS

    text = (DOCS / "parameters.md").read_text(encoding="utf-8")
    assert [kind for kind in KINDS if f"### {kind}\n" not in text] == []
