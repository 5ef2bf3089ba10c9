"""A self-contained HTML page from its template."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from torquerig.harmless import harmless
from torquerig.version import __version__

TEMPLATES = Path(__file__).with_name("templates")


def _harmless(value: Any) -> Any:
    """Return text of foreign files without acting control characters; text that is HTML already stays HTML."""
    if not isinstance(value, str) or value.isprintable():
        return value
    shown = harmless(value)
    return value if shown == value else type(value)(shown)


def html(template: str, content: Mapping[str, Any], *, folder: Path | None = None) -> str:
    """Return a template of ``folder`` or of ``reporting/templates`` filled with ``content`` and the version.

    Text is escaped. A name of the template that the content lacks is an error.
    """
    from jinja2 import ChoiceLoader, Environment, FileSystemLoader, PackageLoader, StrictUndefined

    from torquerig.reporting.compiled_templates import CompiledTemplates

    own = [] if folder is None else [FileSystemLoader(folder)]
    environment = Environment(
        loader=ChoiceLoader([*own, PackageLoader("torquerig.reporting")]), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True, finalize=_harmless,
        bytecode_cache=None if own else CompiledTemplates(TEMPLATES),
    )  # fmt: skip
    return environment.get_template(template).render({"version": __version__, **content})
