"""What the pages of both kinds of rig share: pictures and HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.html import html
from torquerig.reporting.moving.page_scripts import page_scripts

NO_MISMATCH = "No difference is significant, so there is no figure of it."


def rendered(content: Mapping[str, Any], *, title: str, command: str, model: str | None, seed: int) -> str:
    """Return the HTML of a diagnosis: pictures and scripts inside, no request to anywhere."""
    made = {
        "title": title.replace("_", " "), "command": command, "model": model, "seed": seed,
        "scripts": page_scripts(with_plots=False, with_matrices=False),
    }  # fmt: skip
    return html("diagnosis.html", {**made, **content})


def first_and_others(drawn: Sequence[Picture]) -> Mapping[str, Any]:
    """Return the picture of the first screen, of recording and models, and the others; each named for its files."""
    named = [replace(one, name=f"picture_{number}") for number, one in enumerate(drawn, start=1)]
    return {"first_picture": named[0] if named else None, "pictures": tuple(named[1:])}
