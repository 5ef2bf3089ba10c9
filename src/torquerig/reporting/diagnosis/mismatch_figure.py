"""Shares of the squared residual by place, as bars."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.sentences import p_value_text, place_text
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import new_figure, picture

COLOURS = {
    "order": "#0072b2", "frequency": "#e69f00", "time": "#7a68a6", "speed": "#56b4e9", "level": "#d55e00",
    "distribution": "#cc79a7",
}  # fmt: skip
MOST = 12
_LEAST = 5e-4  # [1] a smaller share is written as 0.0 %


def has_visible_share(mismatches: Sequence[Mismatch]) -> bool:
    """Return whether any bar is longer than zero."""
    return any(one.share_of_misfit >= _LEAST for one in mismatches)


def mismatch_picture(listed: Sequence[Mismatch]) -> Picture | None:
    """Return the shares of the squared residual by place, or None where no place has a visible share."""
    if not has_visible_share(listed):
        return None
    which = "Each place" if len(listed) <= MOST else f"The {MOST} largest of {len(listed)} places"
    return picture(
        mismatch_figure(listed),
        caption=f"{which} where recordings and calibrated model differ, by share of the squared residual.",
        alt_text="bars of the shares of the squared residual by place, largest first",
        name="differences_by_place",
    )


def mismatch_figure(mismatches: Sequence[Mismatch]) -> Figure:
    """Return bars of the shares of the squared residual [%], largest first, coloured by domain."""
    shown = sorted(mismatches, key=lambda one: -one.share_of_misfit)[:MOST][::-1]
    figure = new_figure(10.5, 0.7 + 0.27 * len(shown))
    axes = figure.add_subplot()
    shares = [100 * one.share_of_misfit for one in shown]
    axes.barh(range(len(shown)), shares, color=[COLOURS[one.domain] for one in shown], height=0.7)
    for row, (one, share) in enumerate(zip(shown, shares, strict=True)):
        label = f"  {share:.1f} %, p {p_value_text(one.p_value)}"
        axes.text(share, row, label, va="center", fontsize=7.5, clip_on=True)
    axes.set_yticks(range(len(shown)), [place_text(one) for one in shown])
    axes.set_xlim(0, 1.25 * max(shares))
    axes.set_xlabel("share of the squared residual [%]")
    present = dict.fromkeys(one.domain for one in reversed(shown))
    handles = [axes.barh([0], [0], color=COLOURS[domain], label=_domain_text(domain)) for domain in present]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def _domain_text(domain: str) -> str:
    return {"order": "shaft order", "speed": "depends on speed"}.get(domain, domain)
