"""Uncertain numbers of a scenario that the Monte Carlo samples of a study do not vary."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.study.definition import Study


def held_sentence(study: Study) -> str:
    """Return one sentence about the uncertain numbers that every sample has at their stated value; empty for none.

    The samples draw from intervals without a value, of the catalog and of the scenario.
    """
    from torquerig.scenario.reading import read_scenario

    kept = read_scenario(study.document, study.catalog, seed=study.settings.seed).kept
    if not kept:
        return ""
    return (
        f"No Monte Carlo sample varies {', '.join(kept)}: the scenario states a value and its uncertainty, which "
        "is for calibrations. Write an interval {low: ..., high: ...} without a value to have it drawn."
    )
