"""The S-diagram of a study's page."""

from __future__ import annotations

from base64 import b64encode
from typing import TYPE_CHECKING

from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.rating_drawing import rating_drawing
from torquerig.reporting.moving.page_scripts import csv_script
from torquerig.reporting.study.picture_csv import ratings_csv
from torquerig.reporting.study.tables import best_per_drive

if TYPE_CHECKING:
    from torquerig.study.scoring import Decided

FRONT = 8  # combinations named in it


def rating_picture(decided: Decided, *, winner: str) -> Picture | None:
    """Return the S-diagram; None where no criterion is economic."""
    if decided.economic is None:
        return None
    front = best_per_drive(decided)[:FRONT]
    named = tuple(dict.fromkeys(name for name in (winner, *front, decided.baseline) if name))
    drawn = rating_drawing(decided.technical, decided.economic, named=named)
    return Picture(
        source=f"data:image/svg+xml;base64,{b64encode(drawn).decode()}",
        caption="Technical against economic rating; the numbers mark the best drives with their best filter, "
        "and the present one",
        alt_text="Scatter of technical rating x against economic rating y of all combinations.",
        name="s_diagram", csv=csv_script(ratings_csv(decided)),
    )  # fmt: skip
