"""What effects gain on rigs where nothing is hidden, and which thresholds follow."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from proof.null_gains import NullGain
from proof.page.cells import percent
from proof.page.figures import gains_figure
from proof.thresholds import CHANCE, FEWEST, Threshold, best_gains
from torquerig.diagnosis.choosing.trial import LEAST_GAIN
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.reporting.figures.picture import Picture, picture
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def null(rigs: Sequence[Sequence[NullGain]], found: Sequence[Threshold]) -> Chapter:
    """Return the distribution of the best rejected candidate's gain, and the thresholds by mechanism."""
    if not rigs:
        return Chapter(anchor="null", title="Where nothing is hidden", lines=("No clean rig was run.",))
    best = best_gains(rigs, least_share=LEAST_SHARE)
    quantiles = [float(np.quantile(best, at)) for at in (0.5, 0.9, 1.0)]
    lines = (
        (
            f"On {len(rigs)} rigs with nothing hidden (wrong parameters among them) the best effect of the "
            f"library that explains more than {LEAST_SHARE:g} of its places gains {quantiles[0]:.1f} (median), "
            f"{quantiles[1]:.1f} (90 % quantile), {quantiles[2]:.1f} (largest). What gains {LEAST_GAIN:g} or less "
            f"is not named where no table says otherwise; {sum(gain > LEAST_GAIN for gain in best)} of these rigs "
            "gain more."
        ),
        f"A threshold is the gain that a further clean rig exceeds with {percent(CHANCE)} for each mechanism: an "
        "exponential tail above the 80 % quantile, at least the largest gain that was seen. "
        + ("" if len(rigs) >= FEWEST else f"It takes {FEWEST} clean rigs; with {len(rigs)} none is derived."),
    )
    rows = tuple(
        (*words(one.mechanism), number(str(one.tried)), number(str(one.passed)), number(f"{one.median:.1f}"),
         number(f"{one.largest:.1f}"), number("-" if one.gain is None else f"{one.gain:.1f}"))
        for one in found
    )  # fmt: skip
    table = Table(
        caption="Gains of effects that are not there",
        head=("", "fitted on", "explaining enough", "median gain", "largest gain", "threshold"), rows=rows,
        note="null_table.yaml beside this page holds the thresholds, keyed by the scenario's content.",
    )  # fmt: skip
    return Chapter(anchor="null", title="Where nothing is hidden", lines=lines, tables=(table,) if rows else ())


def null_picture(rigs: Sequence[Sequence[NullGain]], found: Sequence[Threshold]) -> tuple[Picture, ...]:
    """Return the gains by mechanism, those that explain enough to be named."""
    gains: dict[str, list[float]] = {}
    for rig in rigs:
        for one in rig:
            if one.share > LEAST_SHARE:
                gains.setdefault(one.mechanism, []).append(one.gain)
    if not gains:
        return ()
    derived = {one.mechanism: one.gain for one in found if one.gain is not None}
    figure = gains_figure(gains, least=LEAST_GAIN, thresholds=derived)
    told = "Gains on clean rigs, a dot each; red: derived threshold, dashed: built-in least gain."
    return (picture(figure, caption=told, told="gains of effects that are not there, by mechanism"),)
