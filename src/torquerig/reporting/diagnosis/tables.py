"""Tables of a diagnosis: where recordings and model differ, and rejected mechanisms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.sentences import kind_text, mechanism_text, p_value_text, place_text
from torquerig.reporting.layout import Cell, Table, number, words

SIZES = "Excess of a line: residual over its standard deviation. Excess of a frequency band: recording over model."
BONFERRONI = "It is corrected for all tested places (Bonferroni)."


def mismatch_table(mismatches: Sequence[Mismatch], *, sizes: str = SIZES, correction: str = BONFERRONI) -> Table:
    """Return the places where recordings and calibrated model differ.

    ``sizes`` defines the excess, ``correction`` how the p-value accounts for the number of tested places.
    """
    rows = [
        (*words(place_text(each), kind_text(each)), number(f"{each.excess_dB:.1f}"),
         number(f"{100 * each.share_of_misfit:.1f} %"), number(p_value_text(each.p_value)),
         Cell(text=", ".join(each.recordings)))
        for each in mismatches
    ]  # fmt: skip
    return Table(
        caption="Where recordings and model differ, largest share first",
        head=("where", "kind", "excess [dB]", "share of squared residual", "p-value", "recordings"), rows=tuple(rows),
        note="p-value: the probability of so large a difference at any tested place if the model is true. "
        f"{correction} {sizes}",
    )  # fmt: skip


def rejected_table(
    reasons: Mapping[str, str], *, note: str = "Tested on the residual of the calibrated nominal model."
) -> Table:
    """Return the rejected mechanisms, each with its reason."""
    rows = tuple(words(mechanism_text(name), why) for name, why in reasons.items())
    return Table(caption="Rejected mechanisms", head=("mechanism", "reason"), rows=rows, note=note)
