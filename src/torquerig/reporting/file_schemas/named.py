"""All JSON Schemas by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from torquerig.catalog.part_class import KINDS
from torquerig.errors import UnknownNameError, did_you_mean
from torquerig.reporting.file_schemas.catalog_files import class_schema, entry_schema
from torquerig.reporting.file_schemas.generator import JsonSchema
from torquerig.reporting.file_schemas.json_outputs import output_schema
from torquerig.reporting.file_schemas.other_files import (
    faults_schema,
    filters_schema,
    matrix_schema,
    mixture_schema,
    plan_schema,
    sidecar_schema,
    tables_schema,
)
from torquerig.reporting.file_schemas.scenario_file import scenario_schema
from torquerig.reporting.json_results.registry import RESULTS

JSON = "-json"
"""Ending of the name of a schema for what ``--json`` writes: ``orders-json``."""
FILES: Mapping[str, Callable[[], JsonSchema]] = {
    **{of: partial(entry_schema, of) for of in KINDS},
    "class": class_schema,
    "faults": faults_schema,
    "filters": filters_schema,
    "matrix": matrix_schema,
    "mixture": mixture_schema,
    "plan": plan_schema,
    "scenario": scenario_schema,
    "sidecar": sidecar_schema,
    "tables": tables_schema,
}
"""The schemas of files that people write, by name."""
OUTPUTS = (*(f"{name}{JSON}" for name in sorted({*RESULTS, "diagnosis"})),)
"""The names of the schemas of what the commands write."""


def schema_named(name: str) -> JsonSchema:
    """Return a schema by its name; UnknownNameError with the close matches."""
    if name in FILES:
        return FILES[name]()
    if name in OUTPUTS:
        return output_schema(name.removesuffix(JSON))
    raise UnknownNameError(f"there is no schema {name!r}; {did_you_mean(name, (*FILES, *OUTPUTS))}")
