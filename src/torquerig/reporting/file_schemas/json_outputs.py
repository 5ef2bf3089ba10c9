"""The JSON Schemas of what ``--json`` of the commands writes."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic.json_schema import GenerateJsonSchema

from torquerig.reporting.file_schemas.generator import JsonSchema, moved_definitions, schema_of_class, with_head
from torquerig.reporting.json_results.diagnosis import DiagnosisJson
from torquerig.reporting.json_results.document import schema_name
from torquerig.reporting.json_results.provenance import Provenance
from torquerig.reporting.json_results.registry import result_class
from torquerig.reporting.json_results.values import MissingValue


@dataclass(frozen=True)
class _Common:
    """What every document has in addition to its result."""

    missing: tuple[MissingValue, ...]
    provenance: Provenance


def output_schema(command: str) -> JsonSchema:
    """Return the schema of the JSON of a command, by the name in the document."""
    if command == "diagnosis":
        return _named(schema_of_class(DiagnosisJson, GenerateJsonSchema), command)
    schema, common = (schema_of_class(one, GenerateJsonSchema) for one in (result_class(command), _Common))
    definitions = schema.setdefault("$defs", {})
    moved = moved_definitions(common, definitions, prefix="")
    schema["properties"] = {"schema": {}, **schema.get("properties", {}), **moved["properties"]}
    schema["required"] = list(schema["properties"])
    schema["additionalProperties"] = False
    return _named(schema, command)


def _named(schema: JsonSchema, command: str) -> JsonSchema:
    schema["properties"]["schema"] = {"const": schema_name(command)}
    spoken = command.replace("-", " ")
    return with_head(schema, title=f"JSON of {spoken}", description=schema.get("description", ""))
