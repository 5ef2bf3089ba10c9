"""The JSON Schema of a class that files are read into, as the file writes its values: numbers as text with a unit."""

from __future__ import annotations

from math import isfinite
from typing import Any

from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from torquerig.parameter import EVIDENCE, WRITTEN_AS
from torquerig.scenario.numbers.uncertain import KEYS

DIALECT = "https://json-schema.org/draft/2020-12/schema"
JsonSchema = dict[str, Any]


class WrittenForm(GenerateJsonSchema):
    """The form that a file has before it is read; where code checks more than a schema can say, the schema is wider."""

    def function_plain_schema(self, schema: core_schema.PlainValidatorFunctionSchema) -> JsonSchemaValue:
        """Return a number with its unit, or an estimate; what other functions read may be anything."""
        written = (schema.get("metadata") or {}).get(WRITTEN_AS)
        if written is None:
            return {}
        return estimate_schema(**written) if written["estimate"] else number_schema(**written)

    def function_before_schema(self, schema: core_schema.BeforeValidatorFunctionSchema) -> JsonSchemaValue:
        """Return the form that the function passes on, or text: ``5 %`` for a number, an old name for a word."""
        inner = self.generate_inner(schema["schema"])
        if {"oneOf", "$ref", "properties"} & inner.keys():
            return inner
        return {"anyOf": [inner, {"type": "string"}]}


class UncertainForm(WrittenForm):
    """The same for scenarios, in which every number may be uncertain."""

    def float_schema(self, schema: core_schema.FloatSchema) -> JsonSchemaValue:
        """Return a number, text with a tolerance, or a mapping of an uncertain number."""
        return {"anyOf": [super().float_schema(schema), {"type": "string"}, _uncertain()]}

    def function_plain_schema(self, schema: core_schema.PlainValidatorFunctionSchema) -> JsonSchemaValue:
        """Return a number with its unit, alone or with its uncertainty."""
        made = super().function_plain_schema(schema)
        if "type" not in made or made["type"] == "object":
            return made
        described = {key: made.pop(key) for key in ("description",) if key in made}
        return {**described, "anyOf": [made, _uncertain()]}


def schema_of_class(kind: Any, form: type[GenerateJsonSchema] = WrittenForm) -> JsonSchema:
    """Return the JSON Schema of a class, a mapping of classes or a TypedDict, as a file holds it."""
    adapter = kind if isinstance(kind, TypeAdapter) else TypeAdapter(kind)
    made: JsonSchema = _without_infinite_defaults(adapter.json_schema(schema_generator=form, mode="validation"))
    return made


def _without_infinite_defaults(value: Any) -> Any:
    """Return a schema without the defaults that JSON has no number for: without end, without limit."""
    if isinstance(value, list):
        return [_without_infinite_defaults(one) for one in value]
    if not isinstance(value, dict):
        return value
    kept = {key: one for key, one in value.items()
            if not (key == "default" and isinstance(one, float) and not isfinite(one))}  # fmt: skip
    return {key: _without_infinite_defaults(one) for key, one in kept.items()}


def number_schema(*, meaning: str, unit: str, **_: Any) -> JsonSchema:
    """Return a number: text with a unit, such as ``0.3 N*m``; a bare number where there is no unit."""
    if unit == "1":
        return {"type": ["number", "string"], "description": meaning}
    return {"type": "string", "description": f"{meaning} [{unit}]", "examples": [f"1.5 {unit}"]}


def estimate_schema(*, meaning: str, unit: str, **_: Any) -> JsonSchema:
    """Return a mapping with value, or low and high, or one_of, and with evidence and source."""
    number = number_schema(meaning=meaning, unit=unit)
    return {
        "type": "object",
        "description": f"{meaning} [{unit}]",
        "properties": {
            "value": number, "low": number, "high": number, "one_of": {"type": "array", "items": number},
            "rel_sd": {"type": "number", "minimum": 0}, "unknown": {"type": "boolean"},
            "evidence": {"enum": list(EVIDENCE)}, "source": {"type": "string"}, "note": {"type": "string"},
        },
        "required": ["evidence", "source"],
        "additionalProperties": False,
    }  # fmt: skip


def _uncertain() -> JsonSchema:
    number = {"type": ["number", "string"]}
    return {"type": "object", "properties": dict.fromkeys(KEYS, number), "additionalProperties": False}


def with_head(schema: JsonSchema, *, title: str, description: str) -> JsonSchema:
    """Return a schema with dialect, title and description first."""
    rest = {key: value for key, value in schema.items() if key not in ("title", "description", "$schema")}
    return {"$schema": DIALECT, "title": title, "description": description, **rest}


def moved_definitions(schema: JsonSchema, definitions: JsonSchema, *, prefix: str) -> JsonSchema:
    """Return a schema whose definitions are moved into those of a larger one, under names with a prefix."""
    inner = schema.pop("$defs", {})
    moved: JsonSchema = _renamed(schema, prefix)
    definitions |= {f"{prefix}{name}": _renamed(one, prefix) for name, one in inner.items()}
    return moved


def _renamed(value: Any, prefix: str) -> Any:
    if isinstance(value, list):
        return [_renamed(one, prefix) for one in value]
    if not isinstance(value, dict):
        return value
    if isinstance(value.get("mapping"), dict):  # of a discriminator
        value = {**value, "mapping": {key: _reference(one, prefix) for key, one in value["mapping"].items()}}
    return {key: _reference(one, prefix) if key == "$ref" else _renamed(one, prefix) for key, one in value.items()}


def _reference(text: str, prefix: str) -> str:
    return text.replace("#/$defs/", f"#/$defs/{prefix}", 1)
