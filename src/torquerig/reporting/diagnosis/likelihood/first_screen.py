"""The first screen of a diagnosis' page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from torquerig.reporting.diagnosis.page_answer import DiagnosisAnswer, diagnosis_answer
from torquerig.reporting.layout import plain
from torquerig.study.answer.what_to_do import LargeFigure


def first_screen(data: Mapping[str, Any], *, percent: bool = False) -> DiagnosisAnswer:
    """Return what is missing, the rms error before and after, how sure, what to do next.

    ``percent`` says that the residual is a share of the measured effort, of rigs whose motion was measured.
    """
    shown = diagnosis_answer({**data, "rms": None}, percent=percent)
    first, *others = shown.sentences
    return replace(
        shown,
        sentences=(first, *_unnamed(data), _error(data), *others),
        figures=(_error_figure(data), *shown.figures[1:]),
    )


def _unnamed(data: Mapping[str, Any]) -> tuple[str, ...]:
    large = [each for each in data["unnamed"] if not each["minor"]]
    if not large:
        return ()
    text, size = large[0]["explanation"].split(". ")[0].rstrip("."), large[0]["size"]
    more = f", and {len(large) - 1} more" if len(large) > 1 else ""
    return (f"{text}, {plain(size['value'])} {_unit(size['unit'])}{more}. It is in the completed model.",)


def _error(data: Mapping[str, Any]) -> str:
    rms, unit = data["rms"], _unit(data["rms"]["unit"])
    before, after = (plain(rms[key]) for key in ("before", "after"))
    change = f"is {after} {unit} rms" if before == after else f"changes from {before} to {after} {unit} rms"
    least = f"; random errors alone make {plain(rms['true_model'])} {unit}" if "true_model" in rms else ""
    return f"The error on held-out data {change}{least}."


def _error_figure(data: Mapping[str, Any]) -> LargeFigure:
    rms = data["rms"]
    before, after = (plain(rms[key], 2) for key in ("before", "after"))
    value = after if before == after else f"{before} to {after}"
    return LargeFigure(name="rms error", value=f"{value} {_unit(rms['unit'])}", note="on held-out data")


def _unit(unit: str) -> str:
    return unit.replace("*", " ")
