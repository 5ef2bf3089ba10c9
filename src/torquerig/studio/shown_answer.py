"""The answer of a long calculation as plain values, which another process can return and a page can show."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.reporting.figures.picture import Picture
    from torquerig.study.answer.what_to_do import LargeFigure


@dataclass(frozen=True)
class ShownAnswer:
    """What the first screen of a result shows.

    Parameters
    ----------
    sentences : tuple of str
        The first is the answer.
    figures : tuple of (name, value, note)
    tone : str
        CSS class of the answer: good, poor or open.
    """

    sentences: tuple[str, ...]
    figures: tuple[tuple[str, str, str], ...]
    tone: str


@dataclass(frozen=True)
class ShownPicture:
    """A picture: all of the image as an address, its text alternative, its caption."""

    source: str
    alt_text: str
    caption: str


def figures_of(figures: Iterable[LargeFigure]) -> tuple[tuple[str, str, str], ...]:
    """Return large figures as plain values."""
    return tuple((one.name, one.value, one.note) for one in figures)


def pictures_of(pictures: Iterable[Picture | None]) -> tuple[ShownPicture, ...]:
    """Return pictures as plain values, without those that are none."""
    return tuple(ShownPicture(one.source, one.alt_text, one.caption) for one in pictures if one is not None)
