"""The changes between two recordings as sentences and as a table."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.metrics.changes.change import CONFIDENCE, Change
from torquerig.metrics.changes.comparison import Changes
from torquerig.plain_table import cut, grid

_MOST = 20  # rows of the table; the JSON has all
_KINDS = {"order": "order line", "frequency": "line of fixed frequency", "band": "frequency band", "mean": "mean"}
_PLURAL = {"order": "order lines", "frequency": "lines of fixed frequency", "band": "frequency bands", "mean": "mean"}


def changes_sentences(found: Changes) -> list[str]:
    """Return the answer: the largest change, and the smallest that would have been seen where nothing changed."""
    unit, changed = found.unit.replace("*", " "), found.changed
    if not changed:
        said = ["Nothing changed that these two recordings can show."]
    else:
        first = changed[0]
        more = f" {len(changed) - 1} more changes follow." if len(changed) > 1 else ""
        said = [f"The largest change: {place_text(first)} {_moved(first, unit)}.{more}"]
    return [*said, *_unseen(found, unit)]


def _moved(one: Change, unit: str) -> str:
    direction = "rose" if one.difference > 0 else "fell"
    percent = "" if one.percent is None else f", {one.percent:+.3g} %"
    return (
        f"{direction} from {one.before:.3g} to {one.after:.3g} {unit} ({one.difference:+.3g} {unit}{percent}; "
        f"{100 * (1 - CONFIDENCE):.0f} % interval {one.low:+.3g} to {one.high:+.3g})"
    )


def _unseen(found: Changes, unit: str) -> Iterator[str]:
    for kind, spoken in _PLURAL.items():
        tests = [one for one in found.tested if one.kind == kind]
        limit = found.unseen(kind)
        if limit is None:
            continue
        others = "other " if any(one.is_change for one in tests) else ""
        what = "The mean" if kind == "mean" else f"{sum(not one.is_change for one in tests)} {others}{spoken}"
        yield f"{what}: no change. One larger than {limit:.3g} {unit} would be seen."


def place_text(one: Change) -> str:
    """Return what changed, in words."""
    cause = f" ({cut(one.cause, 40)})" if one.cause else ""
    if one.kind == "order":
        spoken = "" if one.frequency is None else f", {one.frequency:.6g} Hz at this speed"
        return f"order {one.at:.6g} of the output shaft{spoken}{cause}"
    if one.kind == "frequency":
        return f"the line at {one.at:.6g} Hz{cause}"
    return "the mean" if one.kind == "mean" else f"the band from {one.at:.4g} to {one.until:.4g} Hz"


def changes_table(found: Changes) -> str:
    """Return one row per change, the largest first; empty where there is none."""
    changed = found.changed
    if not changed:
        return ""
    rows = [["what", "at", f"before {found.unit}", f"after {found.unit}", f"change {found.unit}", "95 % interval",
             "%", "cause"]]  # fmt: skip
    for one in changed[:_MOST]:
        hertz = "" if one.frequency is None else f" = {one.frequency:.5g} Hz"
        at = {"order": f"{one.at:.6g} /rev{hertz}", "frequency": f"{one.at:.6g} Hz", "mean": "",
              "band": f"{one.at:.4g}-{one.until:.4g} Hz"}[one.kind]  # fmt: skip
        percent = "-" if one.percent is None else f"{one.percent:+.1f}"
        rows.append([_KINDS[one.kind], at, f"{one.before:.4g}", f"{one.after:.4g}", f"{one.difference:+.4g}",
                     f"{one.low:+.3g}..{one.high:+.3g}", percent, cut(one.cause, 40)])  # fmt: skip
    more = f"\n{len(changed) - _MOST} smaller changes are in the JSON" if len(changed) > _MOST else ""
    return grid(rows) + more
