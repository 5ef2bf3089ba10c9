"""Technical against economic rating: the S-diagram of VDI 2225, as SVG without a drawing library.

It is the one picture of a page that a weight changes; importing what draws the others takes longer than all the rest.
"""

from __future__ import annotations

from html import escape
from math import hypot
from typing import TYPE_CHECKING

from torquerig.harmless import harmless

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from torquerig.decide.kesselring import KesselringResult

NEAR = 0.015  # [1] dots nearer than this share one label
WIDTH, HEIGHT = 756, 346  # [pt] of the picture
LEFT, RIGHT, TOP, BOTTOM = 48, 500, 10, 304  # [pt] of the axes; the legend is to the right of them
STEPS = (0.05, 0.1, 0.2)  # [1] between grid lines; the first that gives at most TICKS of them
TICKS = 9
FONT = "DejaVu Sans, Verdana, sans-serif"


def rating_drawing(technical: KesselringResult, economic: KesselringResult, *, named: Sequence[str]) -> bytes:
    """Return a dot per combination, bars over the uncertain range, the ``named`` ones numbered with a legend.

    The diagonal is where both ratings are equal; the nearer to the upper right corner on it, the better.
    """
    lowest_y = min(low / economic.ideal for low in economic.total_low.tolist())
    view = _View(max(0.0, min(technical.share.tolist()) - 0.08), max(0.0, lowest_y - 0.05))
    dots = list(zip(technical.share.tolist(), economic.share.tolist(), strict=True))
    start = max(view.x0, view.y0)
    parts = [
        *_grid(view),
        view.line((start, start), (1.0, 1.0), colour="#c6ccd2"),
        *(view.dot(at, 2.0, colour="#a9b8c6", opacity=0.7) for at in dots),
    ]
    rows = [technical.alternatives.index(name) for name in named]
    for row in rows:
        for result, across in ((technical, True), (economic, False)):
            ends = [float(end[row]) / result.ideal for end in (result.total_low, result.total_high)]
            bar = [(end, dots[row][1]) if across else (dots[row][0], end) for end in ends]
            parts.append(view.line(*bar, colour="#12395b", opacity=0.4))
        parts.append(view.dot(dots[row], 3.0, colour="#12395b"))
    parts += _labels(view, [dots[row] for row in rows])
    legend = (f"{place}  {name}" for place, name in enumerate(named, start=1))
    parts += _column(RIGHT + 14, (TOP + BOTTOM) / 2, list(legend))
    body = "".join(parts)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}pt" height="{HEIGHT}pt" viewBox="0 0 {WIDTH} {HEIGHT}">'
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>'
        f'<clipPath id="axes"><rect x="{LEFT}" y="{TOP}" width="{RIGHT - LEFT}" height="{BOTTOM - TOP}"/></clipPath>'
        f'<g font-family="{FONT}" font-size="9" fill="#000000">{body}</g></svg>\n'
    ).encode()


class _View:
    """The axes: from their lower ends to just above 1."""

    def __init__(self, x0: float, y0: float) -> None:
        self.x0, self.y0, self.x1, self.y1 = x0, y0, 1.02, 1.04

    def place(self, at: tuple[float, float]) -> tuple[float, float]:
        """Return the place of two ratings in the picture [pt]."""
        x = LEFT + (at[0] - self.x0) / (self.x1 - self.x0) * (RIGHT - LEFT)
        return x, BOTTOM - (at[1] - self.y0) / (self.y1 - self.y0) * (BOTTOM - TOP)

    def line(self, start: tuple[float, float], end: tuple[float, float], *, colour: str, opacity: float = 1.0) -> str:
        """Return a thin line within the axes."""
        (x1, y1), (x2, y2) = self.place(start), self.place(end)
        return (
            f'<line x1="{x1:.2f}" y1="{y1:.2f}" x2="{x2:.2f}" y2="{y2:.2f}" stroke="{colour}" stroke-width="0.8" '
            f'stroke-opacity="{opacity:g}" clip-path="url(#axes)"/>'
        )

    def dot(self, at: tuple[float, float], radius: float, *, colour: str, opacity: float = 1.0) -> str:
        """Return a dot of a radius [pt]."""
        x, y = self.place(at)
        return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:g}" fill="{colour}" fill-opacity="{opacity:g}"/>'


def _grid(view: _View) -> list[str]:
    """Return grid lines with their numbers, the axes and their names."""
    parts = []
    for at in _ticks(view.x0, view.x1):
        x = view.place((at, view.y0))[0]
        parts.append(f'<path d="M{x:.2f} {TOP}V{BOTTOM}" stroke="#e8ebee" stroke-width="0.6"/>')
        parts.append(_text(x, BOTTOM + 13, f"{at:.2f}", anchor="middle"))
    for at in _ticks(view.y0, view.y1):
        y = view.place((view.x0, at))[1]
        parts.append(f'<path d="M{LEFT} {y:.2f}H{RIGHT}" stroke="#e8ebee" stroke-width="0.6"/>')
        parts.append(_text(LEFT - 5, y + 3, f"{at:.2f}", anchor="end"))
    parts.append(f'<path d="M{LEFT} {TOP}V{BOTTOM}H{RIGHT}" fill="none" stroke="#000000" stroke-width="0.8"/>')
    middle_x, middle_y = (LEFT + RIGHT) / 2, (TOP + BOTTOM) / 2
    parts.append(_text(middle_x, HEIGHT - 8, "technical rating x = T/T_max without the price", anchor="middle"))
    turned = f' transform="rotate(-90 12 {middle_y:g})"'
    return [*parts, _text(12, middle_y, "economic rating y", anchor="middle", more=turned)]


def _ticks(low: float, high: float) -> list[float]:
    step = next((one for one in STEPS if (high - low) / one <= TICKS), STEPS[-1])
    return [place * step for place in range(1 + int(high / step)) if place * step >= low]


def _labels(view: _View, dots: Iterable[tuple[float, float]]) -> list[str]:
    """Return the numbers of the named dots; dots that are close share one label."""
    labels: dict[tuple[float, float], list[str]] = {}
    for place, dot in enumerate(dots, start=1):
        near = next((at for at in labels if hypot(at[0] - dot[0], at[1] - dot[1]) < NEAR), dot)
        labels.setdefault(near, []).append(str(place))
    found = []
    for at, numbers in labels.items():
        x, y = view.place(at)
        bold = ' font-weight="bold"'
        found.append(_text(x - 5, y - 5, ", ".join(numbers), anchor="end", colour="#12395b", more=bold))
    return found


def _column(x: float, middle: float, texts: Sequence[str]) -> list[str]:
    """Return lines of text below each other, centred on a height."""
    top = middle - 6.5 * (len(texts) - 1)
    small = ' font-size="8"'
    return [_text(x, top + 13 * place + 3, text, more=small) for place, text in enumerate(texts)]


def _text(x: float, y: float, text: str, *, anchor: str = "start", colour: str = "#000000", more: str = "") -> str:
    shown = escape(harmless(text))
    looks = f'text-anchor="{anchor}" fill="{colour}"{more} xml:space="preserve"'
    return f'<text x="{x:.2f}" y="{y:.2f}" {looks}>{shown}</text>'
