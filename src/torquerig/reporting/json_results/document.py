"""The JSON document of a command: schema, provenance, result, and why values are missing."""

from __future__ import annotations

import json
from typing import Any

from torquerig.reporting.json_results.provenance import Provenance
from torquerig.reporting.json_results.values import plain_values


def schema_name(command: str) -> str:
    """Return the name of the schema of a command, with its version."""
    return f"torquerig.{command}/1"


def json_document(command: str, result: Any, provenance: Provenance) -> dict[str, Any]:
    """Return the document of a command: keys in a fixed order, no number that is not finite.

    ``missing`` lists each null with its place and reason.
    """
    body, missing = plain_values(result)
    origin, of_origin = plain_values(provenance)
    every = [{"at": f"/provenance{one.at}", "reason": one.reason} for one in of_origin]
    every += [{"at": one.at, "reason": one.reason} for one in missing]
    return {"schema": schema_name(command), **body, "missing": every, "provenance": origin}


def json_text(document: Any) -> str:
    """Return the text of a document; the same document gives the same bytes."""
    return json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
