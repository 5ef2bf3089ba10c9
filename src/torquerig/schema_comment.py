"""The line of a YAML file that tells an editor where the JSON Schema of the file is."""

from __future__ import annotations

import os
from pathlib import Path

FOLDER = "schemas"
"""Folder of the schemas, next to catalogs/ and scenarios/; ``torquerig init`` writes it."""
_LEVELS = 4  # from a catalog shelf to the folder that init has filled, and one more


def schema_comment(path: Path, name: str) -> str:
    """Return the comment with the relative path of the schema; empty where no folder above ``path`` has it."""
    here = Path(path).resolve().parent
    for folder in (here, *here.parents[:_LEVELS]):
        schema = folder / FOLDER / f"{name}.json"
        if schema.is_file():
            relative = Path(os.path.relpath(schema, here)).as_posix()
            return f"# yaml-language-server: $schema={relative}\n"
    return ""
