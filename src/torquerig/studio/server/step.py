"""One step of the studio: its name in the address, its title, and what draws it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.studio.server.tab import Tab


@dataclass(frozen=True)
class Step:
    """A step.

    Parameters
    ----------
    key : str
        In the address: ``step=what_if``.
    title : str
    build : callable
        Draws the step of a tab into the present NiceGUI element; called once, when the step is first opened.
    """

    key: str
    title: str
    build: Callable[[Tab], None]
