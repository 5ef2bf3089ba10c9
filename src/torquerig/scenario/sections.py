"""The sections of a scenario file, and the check of the one that only a comparison uses."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from pydantic import BaseModel

from torquerig.document import Document, validated, with_new_keys
from torquerig.errors import InputError, did_you_mean
from torquerig.scenario.section_names import SECTIONS
from torquerig.section_schema import schema_of

if TYPE_CHECKING:
    from torquerig.scenario.conditions.operating_point import OperatingPoint
    from torquerig.scenario.numbers.uncertain import Resolved
    from torquerig.scenario.study_section import Settings

Section = TypeVar("Section", bound=BaseModel)
USUAL = "torque_sensor"  # what most rigs measure with; it turns


def sections_of(document: Document) -> dict[str, Any]:
    """Return the sections of a scenario; InputError for a missing rig, an unknown section, or an unusable study."""
    data = document.data
    if not isinstance(data, dict) or not isinstance(data.get("rig"), dict) or not data["rig"]:
        place = document.place(("rig",)) if isinstance(data, dict) and "rig" in data else document.path
        raise InputError(f"{place}: a scenario needs a mapping named rig: with one entry per part")
    for key, value in data.items():
        if key not in SECTIONS:
            remedy = did_you_mean(str(key), SECTIONS)
            elsewhere = None if remedy.startswith("did you") else _place_of(str(key), value, data, here="the top level")
            raise InputError(f"{document.place((key,))}: unknown key; {elsewhere or remedy}")
    if "study" in data:
        read_study_section(with_current_names(document))
    return data


def with_current_names(document: Document) -> Document:
    """Return the document with old names of keys of its study replaced by the new ones; a notice lists them."""
    return with_new_keys(document, {("study", "demands"): "requirements"})


def read_study_section(document: Document) -> Settings:
    """Return the study of a scenario that has one; InputError with file, line and key where it cannot be used."""
    from torquerig.scenario.study_section import Settings  # 20 ms that a scenario without a study does not need

    return _validated(document, "study", Settings, in_a_line=output_moves_in_a_line(document.data))


def read_operating_point(document: Document, *, seed: int) -> tuple[OperatingPoint, Resolved]:
    """Return the operating point with one value for every number, and what is known of the uncertain ones."""
    from torquerig.scenario.conditions.operating_point import OperatingPoint
    from torquerig.scenario.numbers.uncertain import resolved

    name, in_a_line = "operating_point", output_moves_in_a_line(document.data)
    stated = resolved(
        document.data.get(name, {}), OperatingPoint, owner=name, seed=seed,
        place=lambda path: document.place((name, *path)), in_a_line=in_a_line,
    )  # fmt: skip
    return _validated(document, name, OperatingPoint, data=stated.values, in_a_line=in_a_line), stated


def output_moves_in_a_line(data: Mapping[str, Any]) -> bool:
    """Return whether the place that is measured first moves in a line; its speed is then one in m/s."""
    measured = data.get("measured", "torque_sensor")
    first = measured[0] if isinstance(measured, list) and measured else measured
    parts = data["rig"] if isinstance(data.get("rig"), dict) else {}
    part = parts.get(first) if isinstance(first, str) else None
    if isinstance(part, dict) and isinstance(part.get("at"), str):  # an instrument or an imposed motion
        part = parts.get(part["at"])
    kind = part.get("kind") if isinstance(part, dict) else None
    if kind == USUAL:  # the kinds take 0.2 s to import
        return False
    from torquerig.scenario.kinds import KINDS

    return isinstance(kind, str) and kind in KINDS and KINDS[kind].in_a_line


def read_section(document: Document, name: str, model: type[Section]) -> Section:
    """Return a section of a scenario, its defaults where the file has none; InputError as for the study."""
    return _validated(document, name, model) if name in document.data else model()


def _validated(
    document: Document, name: str, model: type[Section], *, data: Any = None, in_a_line: bool = False
) -> Section:
    elsewhere = partial(_place_of, data=document.data, here=name)
    return validated(
        document, schema_of(model), within=(name,), data=data, context={"in_a_line": in_a_line}, elsewhere=elsewhere
    )


def _place_of(key: str, value: Any, data: Any, *, here: str) -> str | None:
    """Return where a key that is unknown here would be right; what knows that is imported for an error alone."""
    from torquerig.scenario.checks.misplaced import place_of

    return place_of(key, value, data, here=here)
