"""The JSON Schema of a scenario: its sections, and its parts by their kind."""

from __future__ import annotations

from typing import Any

from torquerig.reporting.file_schemas.generator import (
    JsonSchema,
    UncertainForm,
    WrittenForm,
    moved_definitions,
    schema_of_class,
    with_head,
)
from torquerig.scenario.catalog_values.from_catalog import FIELDS
from torquerig.scenario.conditions.operating_point import OperatingPoint
from torquerig.scenario.conditions.recording_settings import RecordingSettings
from torquerig.scenario.kinds import KINDS
from torquerig.scenario.section_names import SECTIONS
from torquerig.scenario.study_section import Settings

_NAMES: JsonSchema = {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}
_MODELS: dict[str, tuple[Any, type[WrittenForm]]] = {
    "operating_point": (OperatingPoint, UncertainForm),
    "recording": (RecordingSettings, WrittenForm),
    "study": (Settings, WrittenForm),
}


def scenario_schema() -> JsonSchema:
    """Return the schema of a scenario file."""
    definitions: JsonSchema = {}
    texts: JsonSchema = {"scenario": {"type": "string"}, "measured": _NAMES}
    sections = {name: moved_definitions(schema_of_class(*one), definitions, prefix=name)
                for name, one in _MODELS.items()}  # fmt: skip
    definitions["part"] = _part(definitions)
    rig = {"type": "object", "minProperties": 1, "additionalProperties": {"$ref": "#/$defs/part"}}
    every = {**texts, **sections, "rig": rig}
    schema = {
        "type": "object",
        "properties": {name: every[name] for name in SECTIONS},
        "required": ["rig"],
        "additionalProperties": False,
        "$defs": definitions,
    }
    return with_head(schema, title="scenario", description="A rig, its operating point, and what is studied on it.")


def _part(definitions: JsonSchema) -> JsonSchema:
    """Return the schema of one part: its kind decides which keys it has."""
    cases = []
    for kind in KINDS:
        definitions[f"part_{kind}"] = _of_kind(kind, definitions)
        cases.append({
            "if": {"properties": {"kind": {"const": kind}}, "required": ["kind"]},
            "then": {"$ref": f"#/$defs/part_{kind}"},
        })  # fmt: skip
    return {
        "type": "object",
        "properties": {"kind": {"enum": sorted(KINDS)}},
        "required": ["kind"],
        "allOf": cases,
    }


def _of_kind(kind: str, definitions: JsonSchema) -> JsonSchema:
    """Return the schema of a part of one kind, as a file writes it: its name is the key above it."""
    cls = KINDS[kind]
    schema = moved_definitions(schema_of_class(cls, UncertainForm), definitions, prefix=kind)
    if "$ref" in schema:  # a part that refers to itself
        schema = dict(definitions[schema["$ref"].rpartition("/")[2]])
    properties = {
        key.removesuffix("_") if key == "from_" else key: one
        for key, one in schema["properties"].items() if key != "name"
    }  # fmt: skip
    properties["kind"] = {"const": kind}
    required = [key.removesuffix("_") if key == "from_" else key for key in schema.get("required", ())]
    required = [key for key in required if key not in ("name", "kind", "after")]
    made: JsonSchema = {
        "type": "object", "description": (cls.__doc__ or "").partition("\n")[0], "properties": properties,
        "additionalProperties": False,
    }  # fmt: skip
    if kind in FIELDS:
        properties["catalog"] = {"type": "string", "description": "name of the entry in the catalog"}
        properties.setdefault("ripple", {})
        made["anyOf"] = [{"required": ["catalog"]}, {"required": required}]
    else:
        made["required"] = required
    return made
