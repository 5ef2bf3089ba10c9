"""Gains on rigs without hidden effects, and the thresholds from them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from proof.null_gains import NullGain
from proof.page.cells import percent
from proof.page.figures import gains_figure
from proof.thresholds import FALSE_ALARM, FEWEST, Threshold, best_gains
from torquerig.diagnosis.choosing.trial import LEAST_GAIN
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def null(rigs: Sequence[Sequence[NullGain]], found: Sequence[Threshold]) -> Chapter:
    """Return the distribution of the largest gain per rig, and the thresholds by mechanism."""
    if not rigs:
        return Chapter(anchor="null", title="Rigs without hidden effects", lines=("No clean rig was tested.",))
    best = best_gains(rigs, least_share=LEAST_SHARE)
    quantiles = [float(np.quantile(best, at)) for at in (0.5, 0.9, 1.0)]
    lines = (
        (
            f"Data: {len(rigs)} rigs without hidden effects, some with wrong parameters. On each, the largest gain of "
            f"a mechanism that explains more than {LEAST_SHARE:g} of the residual where it acts is taken. It is "
            f"{quantiles[0]:.1f} (median), {quantiles[1]:.1f} (90 % quantile), {quantiles[2]:.1f} (largest). "
            f"Without a table, a finding needs a gain above {LEAST_GAIN:g}; "
            f"{sum(gain > LEAST_GAIN for gain in best)} of these rigs exceed it."
        ),
        f"A threshold is the gain that a clean rig exceeds with a probability of {percent(FALSE_ALARM)} per mechanism. "
        "It is an exponential tail above the 80 % quantile, and at least the largest gain of these rigs."
        + ("" if len(rigs) >= FEWEST else f" It needs {FEWEST} clean rigs; with {len(rigs)} none is derived."),
    )
    rows = tuple(
        (*words(one.mechanism), number(str(one.tried)), number(str(one.passed)), number(f"{one.median:.1f}"),
         number(f"{one.largest:.1f}"), number("-" if one.gain is None else f"{one.gain:.1f}"))
        for one in found
    )  # fmt: skip
    table = Table(
        caption="Gains of absent mechanisms",
        head=("", "rigs fitted", "with sufficient share", "median gain", "largest gain", "threshold"), rows=rows,
        note="The file null_table.yaml holds the thresholds, with the hash of the scenario as key.",
    )  # fmt: skip
    return Chapter(anchor="null", title="Rigs without hidden effects", lines=lines, tables=(table,) if rows else ())


def null_picture(rigs: Sequence[Sequence[NullGain]], found: Sequence[Threshold]) -> tuple[Picture, ...]:
    """Return the gains by mechanism, of fits with a sufficient share."""
    gains: dict[str, list[float]] = {}
    for rig in rigs:
        for one in rig:
            if one.share > LEAST_SHARE:
                gains.setdefault(one.mechanism, []).append(one.gain)
    if not gains:
        return ()
    derived = {one.mechanism: one.gain for one in found if one.gain is not None}
    figure = gains_figure(gains, least=LEAST_GAIN, thresholds=derived)
    caption = "Gains on clean rigs, a dot each. Red: derived threshold. Dashed: built-in threshold."
    return (picture(figure, caption=caption, alt_text="gains of absent mechanisms, by mechanism"),)
