"""The picture of a comparison: each tested line and band before and after, and the changes with their intervals."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.metrics.changes.comparison import Changes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_BEFORE, _AFTER = "#0072b2", "#d55e00"  # Okabe and Ito: distinct with any colour vision
_PANELS = (
    ("order", "order of the output shaft"),
    ("frequency", "fixed frequency Hz"),
    ("band", "lower end of the octave Hz"),
)


def changes_figure(found: Changes, *, title: str) -> Figure:
    """Return one row per kind that was tested: levels before and after, and the change with its 95 % interval."""
    from matplotlib.figure import Figure

    kinds = [one for one in _PANELS if any(test.kind == one[0] for test in found.tested)]
    figure = Figure(figsize=(11.0, 1.0 + 2.6 * len(kinds)), layout="constrained")
    axes = figure.subplots(len(kinds), 2, squeeze=False)
    for (kind, label), (levels, differences) in zip(kinds, axes, strict=True):
        _draw(found, kind, levels, differences)
        for panel in (levels, differences):
            panel.set_xlabel(label)
            panel.grid(visible=True, alpha=0.3)
    axes[0][0].legend(loc="best")
    figure.suptitle(title)
    return figure


def _draw(found: Changes, kind: str, levels: Axes, differences: Axes) -> None:
    tests = [one for one in found.tested if one.kind == kind]
    at = np.array([one.at for one in tests])
    for values, colour, marker, name in (
        ([one.before for one in tests], _BEFORE, "o", found.before.recording.name),
        ([one.after for one in tests], _AFTER, "x", found.after.recording.name),
    ):
        levels.plot(at, values, marker, color=colour, label=name, markersize=5)
    size = np.array([one.difference for one in tests])
    reach = np.array([[one.difference - one.low for one in tests], [one.high - one.difference for one in tests]])
    changed = np.array([one.is_change for one in tests])
    for chosen, colour, name in ((~changed, "0.6", "within random error"), (changed, _AFTER, "changed")):
        if chosen.any():
            differences.errorbar(
                at[chosen], size[chosen], yerr=reach[:, chosen], fmt="o", color=colour, capsize=2, markersize=4,
                label=name,
            )  # fmt: skip
    differences.axhline(0.0, color="0.3", linewidth=0.8)
    differences.legend(loc="best")
    unit = found.unit.replace("*", " ")
    levels.set_ylabel(f"{'rms' if kind == 'band' else 'amplitude'} {unit}")
    differences.set_ylabel(f"after minus before {unit}")
    if kind == "band":
        for panel in (levels, differences):
            panel.set_xscale("log")
