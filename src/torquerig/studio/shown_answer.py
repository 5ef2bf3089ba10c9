"""The answer of a long calculation as plain values, which another process can return and a page can show."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from html.parser import HTMLParser
from typing import TYPE_CHECKING

if TYPE_CHECKING:
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


def pictures_in(page: str) -> tuple[ShownPicture, ...]:
    """Return the pictures of a page of ``torquerig.reporting`` with their captions, in their order."""
    found = _Figures()
    found.feed(page)
    return tuple(found.pictures)


class _Figures(HTMLParser):
    """Collects image, text alternative and caption of each figure."""

    def __init__(self) -> None:
        super().__init__()
        self.pictures: list[ShownPicture] = []
        self._image: dict[str, str | None] = {}
        self._caption: list[str] | None = None

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Remember the image of the figure, and that its caption begins."""
        if tag == "img":
            self._image = dict(attrs)
        elif tag == "figcaption":
            self._caption = []

    def handle_data(self, data: str) -> None:
        """Collect the words of a caption."""
        if self._caption is not None:
            self._caption.append(data)

    def handle_endtag(self, tag: str) -> None:
        """Keep the picture at the end of its caption."""
        if tag == "figcaption" and self._caption is not None and self._image:
            caption = " ".join("".join(self._caption).split())
            self.pictures.append(ShownPicture(self._image.get("src") or "", self._image.get("alt") or "", caption))
            self._caption, self._image = None, {}
