"""The JSON Schemas of sidecars, matrices, published tables, filter chains, mixtures, faults and plans."""

from __future__ import annotations

from torquerig.decide.matrix_io.matrix_schema import CellText, MatrixText
from torquerig.decide.matrix_io.published_tables import TablesText
from torquerig.filters.chains.chain_schema import CHAINS
from torquerig.recordings.files.sidecar_schema import sidecar_schema as sidecar_adapter
from torquerig.reporting.file_schemas.generator import JsonSchema, moved_definitions, schema_of_class, with_head
from torquerig.study.reference_decision.plan import PlanText
from torquerig.synthetic.description import FAULT_LIST, MIXTURE

_SCALE = {"type": "number", "description": "scale: SI value of one unit, or units of one SI value"}


def sidecar_schema() -> JsonSchema:
    """Return the schema of the sidecar of a recording; the key of a scale depends on the unit, such as Nm_per_V."""
    schema = schema_of_class(sidecar_adapter())
    schema["$defs"]["WrittenChannel"]["patternProperties"] = {"^.+_per_.+$": _SCALE}
    return with_head(
        schema, title="sidecar of a recording",
        description="Rate, channels with their units and scales, and the conditions of the run.",
    )  # fmt: skip


def matrix_schema() -> JsonSchema:
    """Return the schema of a decision matrix; a cell is a number, text with a unit, an interval, ? or a mapping."""
    schema = schema_of_class(MatrixText)
    definitions = schema.setdefault("$defs", {})
    mapping = moved_definitions(schema_of_class(CellText), definitions, prefix="Cell")
    number = {"type": ["number", "string", "boolean", "null"]}
    interval = {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2}
    row = {"type": "object", "additionalProperties": {"anyOf": [number, interval, mapping]}}
    schema["properties"]["alternatives"] = {
        "type": "object", "additionalProperties": {"anyOf": [row, {"type": "null"}]}
    }  # fmt: skip
    return with_head(schema, title="decision matrix", description="Criteria, alternatives and their cells.")


def tables_schema() -> JsonSchema:
    """Return the schema of a file of published tables."""
    return with_head(schema_of_class(TablesText), title="published tables", description="Tables of marks or points.")


def filters_schema() -> JsonSchema:
    """Return the schema of a file of filter chains."""
    chains = schema_of_class(CHAINS)
    definitions = chains.pop("$defs", {})
    schema = {"type": "object", "properties": {"filters": chains}, "required": ["filters"], "$defs": definitions}
    return with_head(schema, title="filter chains", description="Filter chains by name, each a list of stages.")


def mixture_schema() -> JsonSchema:
    """Return the schema of a test signal of known components."""
    return with_head(
        schema_of_class(MIXTURE), title="test signal", description="Components of torquerig synth mixture and pair."
    )


def faults_schema() -> JsonSchema:
    """Return the schema of a file of faults that are drawn into a recording."""
    return with_head(schema_of_class(FAULT_LIST), title="faults", description="Faults of torquerig synth fault.")


def plan_schema() -> JsonSchema:
    """Return the schema of the plan of torquerig reference-decision."""
    return with_head(
        schema_of_class(PlanText), title="plan of a published decision", description="How each criterion is computed."
    )
