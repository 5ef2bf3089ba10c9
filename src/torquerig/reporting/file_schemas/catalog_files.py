"""The JSON Schemas of catalog files."""

from __future__ import annotations

from torquerig.catalog.part_class import KINDS, PartClass, values_adapter
from torquerig.catalog.printed.sheet import MotorSheet
from torquerig.reporting.file_schemas.generator import JsonSchema, moved_definitions, schema_of_class, with_head

DERIVES = ("like", "as_printed")
"""Keys of an entry from which values follow that the file does not state."""


def entry_schema(of: str) -> JsonSchema:
    """Return the schema of a motor, gearbox, sensor or coupling file.

    Where the file names a class (``like``) or the figures of a data sheet (``as_printed``), no value is required.
    """
    schema = schema_of_class(KINDS[of])
    always = [name for name in ("name", "title", "kind", "ratio") if name in schema.get("required", ())]
    others = schema.pop("required", [])
    schema["required"] = always
    if of == "motor":
        definitions = schema.setdefault("$defs", {})
        schema["properties"]["as_printed"] = moved_definitions(schema_of_class(MotorSheet), definitions, prefix="Sheet")
    stated = [{"required": [key]} for key in DERIVES if key in schema["properties"]]
    schema["anyOf"] = [*stated, {"required": others}]
    return with_head(schema, title=f"{of} of a catalog", description=(KINDS[of].__doc__ or "").partition("\n")[0])


def class_schema() -> JsonSchema:
    """Return the schema of a class file; the values follow from what it is a class of."""
    schema = schema_of_class(PartClass)
    definitions = schema.setdefault("$defs", {})
    schema["allOf"] = [
        {
            "if": {"properties": {"of": {"const": of}}, "required": ["of"]},
            "then": {
                "properties": {
                    "values": moved_definitions(schema_of_class(values_adapter(kind)), definitions, prefix=of)
                }
            },
        }
        for of, kind in KINDS.items()
    ]
    return with_head(schema, title="class of a catalog", description=(PartClass.__doc__ or "").partition("\n")[0])
