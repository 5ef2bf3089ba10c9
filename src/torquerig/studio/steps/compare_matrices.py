"""The three matrices with sliders: the page computes them again, with the scripts of the reports."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from nicegui import ui

SCRIPTS = ("elements.js", "tables.js", "matrix_engine.js", "matrix_tables.js", "matrix_controls.js")
ADDRESS = "/studio/report/scripts"
START = f"""
window.studioMatrices ||= (async () => {{
  for (const name of {list(SCRIPTS)}) {{
    await new Promise((done, failed) => {{
      const script = document.createElement("script");
      Object.assign(script, {{ src: `{ADDRESS}/${{name}}`, async: false, onload: done, onerror: failed }});
      document.head.append(script);
    }});
  }}
}})();
await window.studioMatrices;
const made = Object.assign(document.createElement("script"), {{ id: "data-matrix", type: "application/json" }});
const held = document.getElementById("data-matrix") || document.body.appendChild(made);
held.textContent = JSON.stringify(model);
startMatrices();
"""


class Matrices:
    """Sliders for weights, limits and points, and the tables that follow them."""

    def __init__(self) -> None:
        self._holder = ui.html("", sanitize=False)

    def show(self, model: Mapping[str, Any]) -> None:
        """Show the matrices of a study."""
        self._holder.set_content(_laboratory())
        ui.run_javascript(f"const model = {json.dumps(dict(model))};\n{START}")

    async def moved(self) -> Mapping[str, Any]:
        """Return the matrices as they are on the page now."""
        found: Mapping[str, Any] = await ui.run_javascript("return window.torquerigMatrices.state.model", timeout=10.0)
        return found


@cache
def _laboratory() -> str:
    """Return the HTML of the reports' section on other weights."""
    from jinja2 import Environment, PackageLoader

    parts = Environment(loader=PackageLoader("torquerig.reporting"), autoescape=True).get_template("parts.html")
    laboratory: Callable[[], str] = vars(parts.make_module({}))["matrix_lab"]
    return str(laboratory())
