"""A rig as a drawing: its parts along each shaft, springs between nodes, and the effects at the parts they act on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.patches import FancyBboxPatch

from torquerig.reporting.figures.picture import new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from torquerig.rig.assembly import Part, Rig

BODY, SPRING, READ, EFFECT = "#cfe0ee", "#ffffff", "#f6d7a7", "#5b6770"
_EDGE = "#12395b"
_WIDTH, _HEIGHT, _STEP, _ROW = 1.7, 0.62, 2.1, 2.3  # [in] of a box, from box to box, from shaft to shaft
_LINE = 0.17  # [in] from effect to effect
_LETTERS = 22  # of a name in a box


def rig_figure(rig: Rig, *, title: str = "") -> Figure:
    """Return the drawing of a rig.

    A box is a part on a shaft; a white one has a spring inside (gear, sensor, coupling), the orange one is read. Grey
    names below a box are effects and attachments that act there; those without a place are listed at the foot.
    """
    shafts = _shafts(rig)
    places = {part.name: (column, row) for row, shaft in enumerate(shafts) for column, part in shaft}
    hung: dict[str, list[str]] = {}
    loose: list[str] = []
    for part in rig.parts:
        if part.name in places:
            continue
        host = part.host
        (hung.setdefault(host, []) if host in places else loose).append(f"{part.name} ({part.kind})")
    columns = max((column for column, _ in places.values()), default=0) + 1
    deepest = max((len(names) for names in hung.values()), default=0)
    row_height = max(_ROW, _HEIGHT + _LINE * (deepest + 3))
    figure = new_figure(max(columns * _STEP + 0.5, 6.0), len(shafts) * row_height + 0.6 + 0.2 * bool(loose))
    axes = figure.add_subplot()
    for row, shaft in enumerate(shafts):
        _draw_shaft(axes, rig, shaft, hung, y=-row * row_height, places=places, row_height=row_height)
    axes.set_xlim(-0.3, max(columns * _STEP, 5.5))
    axes.set_ylim(-len(shafts) * row_height + 0.4, _HEIGHT + 0.3)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, loc="left")
    if loose:
        figure.text(0.01, 0.01, f"on the signal or the whole rig: {', '.join(loose)}", fontsize=7, color=EFFECT)
    return figure


def _shafts(rig: Rig) -> list[list[tuple[int, Part]]]:
    """Return the parts of each chain with their columns: the first chain, then each branch where it begins."""
    on_shaft = [part for part in rig.parts if part.on_shaft]
    rows: list[list[tuple[int, Part]]] = []
    ends: dict[str, int] = {}  # by the last part of a row
    places: dict[str, int] = {}
    for part in on_shaft:
        before = part.after if part.after in places else None
        column = places[before] + 1 if before is not None else 0
        row = ends.pop(before) if before in ends and not part.ends_shaft else len(rows)
        if row == len(rows):
            rows.append([])
        rows[row].append((column, part))
        places[part.name] = column
        ends[part.name] = row
    return rows


def _draw_shaft(
    axes: Axes, rig: Rig, shaft: list[tuple[int, Part]], hung: dict[str, list[str]], *, y: float,
    places: dict[str, tuple[int, int]], row_height: float,
) -> None:  # fmt: skip
    for column, part in shaft:
        x = column * _STEP
        if part.after in places:
            from_column, from_row = places[part.after]
            start = (from_column * _STEP + _WIDTH, -from_row * row_height + _HEIGHT / 2)
            axes.plot([start[0], x], [start[1], y + _HEIGHT / 2], color=_EDGE, linewidth=2, zorder=0)
        colour = READ if part.name in rig.places else SPRING if part.opens_node else BODY
        axes.add_patch(FancyBboxPatch((x, y), _WIDTH, _HEIGHT, boxstyle="round,pad=0.02,rounding_size=0.08",
                                      facecolor=colour, edgecolor=_EDGE, linewidth=1.2))  # fmt: skip
        axes.text(x + _WIDTH / 2, y + 0.4, part.name[:_LETTERS], ha="center", va="center", fontsize=8)
        axes.text(x + _WIDTH / 2, y + 0.17, part.kind[:_LETTERS], ha="center", va="center", fontsize=6.5, color=EFFECT)
        for line, name in enumerate(hung.get(part.name, [])):
            axes.text(x, y - _LINE * (line + 1), name[:40], ha="left", va="center", fontsize=6, color=EFFECT)
