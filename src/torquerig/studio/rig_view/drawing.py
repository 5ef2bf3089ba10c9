"""The drawing of a rig as SVG: boxes along each shaft, effects below, each a button for mouse and keyboard."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import partial
from html import escape

from torquerig.harmless import harmless
from torquerig.rig.assembly import Part
from torquerig.scenario.kinds import KINDS
from torquerig.studio.rig_view.placed_parts import PlacedPart

WIDTH, HEIGHT, GAP = 132, 52, 26  # [px] of a box on a shaft, and between two
SMALL, LINE = 26, 31  # [px] height of an effect, and from one to the next
LETTERS = 17  # of a name that fits into a box
EDGE = 6  # [px] around the drawing: room for the frame of the chosen box


def drawing(
    parts: Sequence[PlacedPart], *, chosen: str, problems: Mapping[str, int], read: Collection[str]
) -> str:  # fmt: skip
    """Return the SVG.

    Parameters
    ----------
    chosen : str
        Name of the part whose values are shown.
    problems : mapping of str to int
        Number of problems by part.
    read : collection of str
        Names of the parts that are measured.
    """
    on_shaft = [one for one in parts if one.column >= 0]
    names = {one.name for one in on_shaft}
    hung: dict[str, list[PlacedPart]] = {}
    for one in parts:
        if one.column < 0:
            hung.setdefault(one.host if one.host in names else "", []).append(one)
    tops = _tops(on_shaft, hung)
    loose = hung.get("", [])
    columns = max(1, min(len(loose), 6), *(one.column + 1 for one in on_shaft))
    places = {one.name: (EDGE + one.column * (WIDTH + GAP), tops[one.row]) for one in on_shaft}
    boxes = [_shaft_line(one, places) for one in on_shaft if one.after]
    box = partial(_box, chosen=chosen, problems=problems, read=read)
    for one in on_shaft:
        x, y = places[one.name]
        boxes.append(box(one, x, y, HEIGHT))
        below = enumerate(hung.get(one.name, []))
        boxes += [box(effect, x, y + HEIGHT + 5 + at * LINE, SMALL) for at, effect in below]
    foot = tops[-1]
    boxes += [
        box(one, EDGE + at % columns * (WIDTH + GAP), foot + at // columns * LINE, SMALL)
        for at, one in enumerate(loose)
    ]
    width = 2 * EDGE + columns * (WIDTH + GAP) - GAP
    height = foot + -(-len(loose) // columns) * LINE + EDGE
    return (
        f'<svg role="group" aria-label="parts along the shaft" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}">{"".join(boxes)}</svg>'
    )


def _tops(on_shaft: Sequence[PlacedPart], hung: Mapping[str, Sequence[PlacedPart]]) -> list[int]:
    """Return the top of each row of boxes [px], and last that of the parts without a place."""
    tops = [EDGE]
    for row in range(max((one.row for one in on_shaft), default=-1) + 1):
        deepest = max(len(hung.get(one.name, [])) for one in on_shaft if one.row == row)
        tops.append(tops[-1] + HEIGHT + 5 + deepest * LINE + 14)
    return tops


def _shaft_line(one: PlacedPart, places: Mapping[str, tuple[int, int]]) -> str:
    (start, top), (end, below) = places[one.after], places[one.name]
    return f'<line x1="{start + WIDTH}" y1="{top + HEIGHT // 2}" x2="{end}" y2="{below + HEIGHT // 2}"/>'


def _box(
    one: PlacedPart, x: int, y: int, height: int, *, chosen: str, problems: Mapping[str, int], read: Collection[str]
) -> str:  # fmt: skip
    count = problems.get(one.name, 0)
    is_chosen = one.name == chosen
    said = f"{one.name}, {one.kind or 'no kind'}" + (", measured" if one.name in read else "")
    said += f", {count} problem{'s' * (count > 1)}" if count else ""
    spring = KINDS.get(one.kind, Part).opens_node
    kinds = (("spring", spring), ("read", one.name in read), ("chosen", is_chosen), ("wrong", count))
    classes = " ".join(name for name, is_so in kinds if is_so)
    mark = f'<text class="mark" x="{x + WIDTH - 16}" y="{y + 17}">!</text>' if count else ""
    below = f'<text class="kind" x="{x + 8}" y="{y + 40}">{_cut(one.kind)}</text>' if height == HEIGHT else ""
    name = f'<text x="{x + 8}" y="{y + (22 if height == HEIGHT else 18)}">{_cut(one.name)}</text>'
    return (
        f'<g role="button" tabindex="0" data-part="{_safe(one.name)}" aria-pressed="{str(is_chosen).lower()}" '
        f'aria-label="{_safe(said)}" class="{classes}"><title>{_safe(said)}</title>'
        f'<rect x="{x}" y="{y}" width="{WIDTH}" height="{height}" rx="5"/>{name}{below}{mark}</g>'
    )


def _cut(text: str) -> str:
    return _safe(text if len(text) <= LETTERS else f"{text[: LETTERS - 1]}…")


def _safe(text: str) -> str:
    return escape(harmless(text))
