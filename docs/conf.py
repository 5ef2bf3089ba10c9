"""Build the site: ``python -m sphinx -W --keep-going -b html docs build/docs``; it reads and writes nothing on the net.

Examples (``examples/*.py``) and notebooks (``examples/notebooks``) run during the build; both are cached, so that a
second build runs only what was changed.
"""

from __future__ import annotations

import shutil
import sys
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any, get_type_hints

from sphinx.application import Sphinx

import torquerig
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path[:0] = [str(HERE), str(HERE / "_ext")]

project, author, version = "torquerig", "The torquerig authors", torquerig.__version__
project_copyright = author
extensions = ["sphinx.ext.autodoc", "sphinx.ext.autosummary", "numpydoc", "myst_nb", "sphinx_gallery.gen_gallery"]
exclude_patterns = ["README.md", *(f"gallery/*.{ending}" for ending in ("ipynb", "py", "md5", "json", "zip"))]
templates_path = ["_templates"]
nitpicky = False

html_theme, html_title = "furo", "torquerig"
html_static_path, html_css_files = ["_static"], ["torquerig.css"]
html_show_sourcelink = html_copy_source = False
html_theme_options = {"navigation_with_keys": True}
pygments_style, pygments_dark_style = "tango", "monokai"

autosummary_generate = True
autodoc_typehints = "none"  # the parameter tables say it in words
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False
numpydoc_xref_param_type = False

myst_enable_extensions = ["colon_fence", "attrs_inline"]
myst_heading_anchors = 3
nb_execution_mode = "cache"
nb_execution_cache_path = str(ROOT / "build" / "notebooks")
nb_execution_timeout = 900  # [s] of one cell; a diagnosis takes a minute on an idle machine, some on a busy one
nb_execution_raise_on_error = True


sphinx_gallery_conf = {
    "examples_dirs": [str(ROOT / "examples")],
    "gallery_dirs": ["gallery"],
    "filename_pattern": r"\.py$",
    "ignore_pattern": r"notebooks",
    "image_scrapers": ["gallery_figures"],
    "copyfile_regex": "",
    "show_memory": False,
    "show_signature": False,
    "min_reported_time": 1e9,
    "download_all_examples": False,
    "within_subsection_order": "FileNameSortKey",
    "write_computation_times": False,
}


NOTEBOOKS = ("select_a_drive", "validate_a_filter", "diagnose_a_recording")  # in the order in which they are read


def notebooks() -> None:
    """Copy the notebooks to where Sphinx reads, unchanged ones not again, and write the page that lists them."""
    source, target = ROOT / "examples" / "notebooks", HERE / "notebooks"
    target.mkdir(exist_ok=True)
    found = [one for one in source.glob("*") if one.suffix in (".ipynb", ".md")]
    found.sort(key=lambda one: (NOTEBOOKS.index(one.stem) if one.stem in NOTEBOOKS else len(NOTEBOOKS), one.stem))
    for one in found:
        copy = target / one.name
        if not copy.exists() or copy.read_bytes() != one.read_bytes():
            shutil.copyfile(one, copy)
    for stale in target.glob("*"):
        if stale.is_file() and stale.name != "index.md" and stale.name not in {one.name for one in found}:
            stale.unlink()
    listed = ["```{toctree}", ":maxdepth: 1", "", *(one.stem for one in found), "```", ""] if found else []
    head = [
        "# Notebooks",
        "",
        "*For those who work in Jupyter. Each notebook runs from top to bottom while these pages are built.*",
        "",
    ]
    text = "\n".join(head + listed)
    if not (target / "index.md").exists() or (target / "index.md").read_text(encoding="utf-8") != text:
        (target / "index.md").write_text(text, encoding="utf-8")


def with_fields(app: Sphinx, what: str, name: str, thing: Any, *rest: Any) -> None:
    """Add the fields that a class declares by ``Parameter`` to its docstring, as numpydoc has them."""
    lines: list[str] = rest[1]
    if what != "class" or not (is_dataclass(thing) and issubclass(thing, Part)) or "Parameters" in lines:
        return
    import parameters  # the script beside this file

    hints = get_type_hints(thing, include_extras=True)
    rows = []
    for one in fields(thing):
        declared: Parameter | None = next(parameters.declarations(hints[one.name]), None)
        if declared is not None:
            unit = "1" if declared.unit == "1" else declared.unit
            allowed, default = parameters.bounds(declared), parameters.default(one)
            rows += [f"{one.name} : {allowed if allowed != 'any' else 'number'}, {default_text(default)}"]
            rows += [f"    {declared.meaning} [{unit}]"]
    if rows:
        lines += ["", "Parameters", "----------", *rows]


def default_text(default: str) -> str:
    """Return a default in numpydoc's words."""
    return default if default in ("required", "empty") else f"default {default}"


def without_stale_pages() -> None:
    """Remove the reference pages of an earlier build whose class or function has another name now."""
    listed = set((HERE / "api.rst").read_text(encoding="utf-8").split())
    for page in (HERE / "api").glob("*.rst"):
        if page.stem not in listed:
            page.unlink()


def setup(app: Sphinx) -> None:
    """Prepare what the pages are made of."""
    notebooks()
    without_stale_pages()
    app.connect("autodoc-process-docstring", with_fields, priority=100)  # before numpydoc
