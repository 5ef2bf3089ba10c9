"""Pictures of the gallery: every matplotlib figure that an example holds in a variable."""

from __future__ import annotations

from typing import Any

from matplotlib import pyplot as plt
from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst


def figures(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """Save the figures that a block of an example made and return the page's text that shows them."""
    scope = block_vars["example_globals"]
    shown: set[int] = scope.setdefault("_shown_figures", set())
    paths = []
    for figure in [one for one in scope.values() if isinstance(one, Figure) and id(one) not in shown]:
        shown.add(id(figure))
        path = next(block_vars["image_path_iterator"])
        figure.savefig(path, dpi=130)
        paths.append(path)
    plt.close("all")
    return str(figure_rst(paths, gallery_conf["src_dir"])) if paths else ""


def _get_sg_image_scraper() -> Any:
    return figures
