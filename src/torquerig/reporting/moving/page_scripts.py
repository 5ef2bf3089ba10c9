"""Scripts and data written into a page, so that it opens from anywhere without a request to the net."""

from __future__ import annotations

import gzip
import json
import zlib
from base64 import b64encode
from functools import cache, lru_cache
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from torquerig.cases.kept_values import kept_or_made
from torquerig.harmless import harmless

if TYPE_CHECKING:
    from torquerig.cases.kept_results import KeptResults

PLOTS = ("pyramid.js", "plots.js")
MATRICES = ("matrix_engine.js", "matrix_controls.js", "matrix_tables.js", "sweep.js")
FIRST, PAGE = ("elements.js",), ("tables.js", "page.js")


def page_scripts(
    *, with_plots: bool = True, with_matrices: bool = True, kept: KeptResults | None = None
) -> Markup:  # fmt: skip
    """Return the script elements of a page: Bokeh where it has plots, and the scripts of this package.

    ``kept`` are results from which the compressed library is read.
    """
    wanted = (*FIRST, *(PLOTS if with_plots else ()), *(MATRICES if with_matrices else ()), *PAGE)
    library = f'<script type="text/plain" id="plot-library">{_bokeh(kept)}</script>\n' if with_plots else ""
    own = "\n".join(_own(name) for name in wanted)
    return Markup(f"{library}<script>{own}</script>")  # noqa: S704 (texts of installed packages)


def data_script(name: str, content: Any) -> Markup:
    """Return a script element with data as JSON; no text in it ends the element or acts on a terminal."""
    return Markup('<script type="application/json" id="{}">{}</script>').format(name, _safe_json(content))


def csv_script(text: str) -> Markup:
    """Return a script element with a CSV text, inside the figure that it belongs to."""
    return Markup('<script type="application/json" class="csv">{}</script>').format(_safe_json(text))


def _safe_json(content: Any) -> Markup:
    text = json.dumps(_cleaned(content), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    safe = text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
    return Markup(safe)  # noqa: S704 (nothing in it can end the element)


def _cleaned(content: Any) -> Any:
    """Return data with each text of foreign files made harmless."""
    if isinstance(content, str):
        return harmless(content)
    if isinstance(content, dict):
        return {str(key): _cleaned(value) for key, value in content.items()}
    return [_cleaned(one) for one in content] if isinstance(content, list | tuple) else content


@cache
def _own(name: str) -> str:
    return files("torquerig.reporting").joinpath("templates", "scripts", name).read_text(encoding="utf-8")


def _bokeh(kept: KeptResults | None) -> str:
    """Return the library of the plots, compressed: a third of its size, and unpacked when the first plot is opened.

    It is ``Resources(mode="inline", components=["bokeh"]).js_raw`` without the 0.5 s that importing bokeh takes.
    """
    found = find_spec("bokeh")
    assert found is not None
    assert found.origin is not None
    script = Path(found.origin).parent.joinpath("server", "static", "js", "bokeh.min.js").read_bytes()
    whole = script + b'\nBokeh.set_log_level("info");'
    return kept_or_made(kept, "plot library", (whole, zlib.ZLIB_RUNTIME_VERSION), lambda: _packed(whole), classes=())


@lru_cache(maxsize=1)
def _packed(script: bytes) -> str:
    return b64encode(gzip.compress(script, compresslevel=6, mtime=0)).decode()
