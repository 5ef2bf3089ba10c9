"""Sentences of the answer, from the diagnosis in the contract's form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.sentences import (
    FEATURE_RESIDUAL,
    ResidualMeasure,
    fact_text,
    mechanism_text,
    place_text,
)
from torquerig.reporting.layout import plain

_PLACES = 2  # of small residuals that the sentence lists


def verdict_of(data: Mapping[str, Any], *, measure: ResidualMeasure = FEATURE_RESIDUAL) -> str:
    """Return the verdict in sentences: what is missing, and how the residual on held-out data changed."""
    fit = data["fit"]
    before, after = (measure.formatted(fit[side]["heldout_misfit"]) for side in ("before", "after"))
    name, verdict, of, least = measure.name, data["verdict"], measure.of, measure.true_model
    if verdict == "adequate":
        return f"{nothing_missing(data)} The {name} is {after}{of}.{least}"
    change = f"{f'stays at {after}' if before == after else f'changes from {before} to {after}'}{of}"
    if verdict == "setup_error":
        wrong = " and ".join(fact_text(one) for one in data["setup"])
        return f"A fact of the set-up is wrong: {wrong}. With it corrected, the {name} {change}.{least}"
    named = " and ".join(_named(one) for one in data["findings"])
    lacks = f"The model lacks {named}. " if named else ""
    if verdict == "missing_physics":
        return f"{lacks}With what was found, the {name} {change}.{least}"
    more = "Something more" if named else "Something"
    where = _place(data, measure)
    return f"{lacks}{more} is missing that no mechanism of the library explains.{where} The {name} {change}."


def nothing_missing(data: Mapping[str, Any]) -> str:
    """Return that nothing is missing, or where a residual below the relevance limit is left."""
    rows = [*data.get("mismatch", ())]
    if not rows:
        return "No physics is missing that these recordings can show."
    places = [place_text(Mismatch(**{**row, "recordings": tuple(row["recordings"])})) for row in rows[:_PLACES]]
    more = f" and {len(rows) - _PLACES} more" if len(rows) > _PLACES else ""
    return f"No physics of relevant size is missing. A small residual is left: {', '.join(places)}{more}."


def _place(data: Mapping[str, Any], measure: ResidualMeasure) -> str:
    """Return where the largest residual is if nothing was found that locates it."""
    rows = data["mismatch"]
    if data["findings"] or data["unnamed"] or not rows:
        return ""
    row = max(rows, key=lambda one: one["share_of_misfit"])
    if not row["share_of_misfit"]:  # faults of samples, which were repaired
        return f" {measure.without_place}"
    place = place_text(Mismatch(**{**row, "recordings": tuple(row["recordings"])}))
    return f" The largest residual is {place}, in {' and '.join(row['recordings'][:2])}."


def remarks_of(data: Mapping[str, Any]) -> list[str]:
    """Return which channel is compared, what an adequate answer would have shown, and the best alternatives."""
    limits = [_limit(one) for one in data["upper_limits"]]
    shown = [f"These runs would have shown, in 95 % of such runs: {', '.join(limits)}."] if limits else []
    return [*data.get("remarks", ()), *shown] + [
        f"Alternative to {mechanism_text(one['mechanism'])}: {one['alternatives'][0]['hypothesis']}, "
        f"{plain(one['alternatives'][0]['nats_behind'], 2)} nats less likely."
        for one in data["findings"] if one.get("alternatives")
    ]  # fmt: skip


def _limit(one: Mapping[str, Any]) -> str:
    unit = "" if one["unit"] == "1" else f" {one['unit'].replace('*', ' ')}"
    way = "below" if one["grows"] == "down" else "from"
    return f"{mechanism_text(one['mechanism'])} ({one['parameter']}) {way} {plain(one['value'])}{unit}"


def _named(one: Mapping[str, Any]) -> str:
    name, size = mechanism_text(one["mechanism"]), one["size"]
    alike = " or ".join(map(mechanism_text, one["equivalent_to"]))
    doubt = f", not distinguished from {alike}" if alike else ""
    return f"{name} ({plain(size['value'])} {size['unit'].replace('*', ' ')} rms{doubt})"
