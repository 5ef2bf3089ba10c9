"""What the computing process does first: it loads the integrator and computes the first scenario as it is stated."""

from __future__ import annotations

from pathlib import Path


def warm_up(folder: Path, scenario: Path | None, catalogs: tuple[Path, ...]) -> None:
    """Answer the question that the first page is going to ask, so that its answer is there already."""
    from torquerig.errors import TorquerigError
    from torquerig.studio.session.folder_files import files_in
    from torquerig.studio.what_if.asked import simulated, stated_question

    first = scenario.resolve() if scenario is not None else next(iter(files_in(folder).scenarios), None)
    if first is None:
        return
    try:
        question = stated_question(first, first.read_text(encoding="utf-8"), catalogs)
        simulated(question)
    except (TorquerigError, OSError, ValueError):
        return  # the page says what is wrong, when it asks itself
