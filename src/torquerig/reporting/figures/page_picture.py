"""A picture as a page holds it, without the library that draws it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Picture:
    """An image of a page.

    Parameters
    ----------
    source : str
        All of the image as an address.
    caption, alt_text : str
        The text below it, and its text alternative.
    name : str
        Name of its files, and of its place on the page.
    csv : str
        Script element with its data as CSV text; empty where it has a plot, or no numbers.
    plot, data : str
        Name of the element of its plot that moves, and script element with the plot; empty where none is.
    """

    source: str
    caption: str
    alt_text: str
    name: str = ""
    csv: str = ""
    plot: str = ""
    data: str = ""


def plot_name(name: str) -> str:
    """Return the name of the page's element for the plot of a picture."""
    return f"plot-{name}"
