"""A rig written as a scenario file: every part with its values and units, as ``read_scenario`` reads them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, asdict, fields, is_dataclass
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

from torquerig.errors import InputError
from torquerig.parameter import Estimate, Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.measured import written_measured
from torquerig.scenario.numbers.uncertain_text import by_part, with_uncertainty
from torquerig.schema_comment import schema_comment
from torquerig.units import written_quantity
from torquerig.whole_file import whole_file

_NOT_WRITTEN = ("name", "group")


def written_part(
    part: Part, known: Mapping[str, Estimate] | None = None, *, in_a_line: bool = False
) -> dict[str, Any]:  # fmt: skip
    """Return the YAML mapping of a part: kind first, then every field that differs from its default.

    Parameters
    ----------
    known : mapping of str to Estimate, optional
        Uncertain numbers by path, such as ``amplitudes.2``; written with their ``rel_sd`` or interval.
    in_a_line : bool
        Whether it sits on something that moves in a line, so that N stands for N*m.
    """
    hints = get_type_hints(type(part), include_extras=True)
    answer: dict[str, Any] = {"kind": part.kind}
    uncertain = {path.partition(".")[0] for path in known or {}}
    for field in fields(part):
        value = getattr(part, field.name)
        default = field.default_factory() if field.default_factory is not MISSING else field.default
        is_default = value == default and default is not MISSING and field.name not in uncertain
        if field.name in (*_NOT_WRITTEN, "kind") or value is None or is_default:
            continue
        answer[field.name.rstrip("_")] = _written(value, hints[field.name], in_a_line)
    if "group" in hints and get_origin(hints["group"]) is not None and len(get_args(hints["group"])) > 1:
        answer["group"] = part.group
    return dict(with_uncertainty(answer, known or {}))


def scenario_text(
    rig: Rig, *, title: str, operating_point: Mapping[str, Any], recording: Mapping[str, Any] | None = None,
    known: Mapping[str, Estimate] | None = None, head: str = "",
) -> str:  # fmt: skip
    """Return a scenario file for ``rig``; ``head`` goes before it as a comment, line by line."""
    import yaml

    of_parts = by_part(known or {}, rig)
    parts = {
        part.name: written_part(part, of_parts.get(part.name), in_a_line=rig.in_a_line(part)) for part in rig.parts
    }
    data = {
        "scenario": title, "operating_point": dict(operating_point),
        **({} if recording is None else {"recording": dict(recording)}), "measured": written_measured(rig),
        "rig": parts,
    }  # fmt: skip
    comment = "".join(f"# {line}\n" for line in head.splitlines())
    return comment + yaml.safe_dump(data, sort_keys=False, allow_unicode=True, width=120)


def write_scenario(path: Path, text: str, *, overwrite: bool) -> None:
    """Write a scenario file completely or not at all; InputError where one exists and must not be replaced."""
    if path.exists() and not overwrite:
        raise InputError(f"{path} exists already; choose another name, or add --force to replace it")
    with whole_file(path) as partial:
        partial.write_text(schema_comment(path, "scenario") + text, encoding="utf-8", newline="\n")


def _written(value: Any, hint: Any, in_a_line: bool) -> Any:
    """Return a value as YAML states it: numbers with units where the annotation has one."""
    if get_origin(hint) in (Union, UnionType):
        hint = next(option for option in get_args(hint) if option is not type(None))
    parameter = next((note for note in getattr(hint, "__metadata__", ()) if isinstance(note, Parameter)), None)
    if parameter is not None and isinstance(value, int | float):
        unit = parameter.in_a_line.unit if in_a_line else parameter.unit
        return float(value) if unit == "1" else written_quantity(float(value), unit)
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    inner = get_args(hint)
    if isinstance(value, Mapping):
        return {_written(key, inner[0], in_a_line): _written(item, inner[1], in_a_line) for key, item in value.items()}
    if isinstance(value, tuple | list):
        return [_written(item, inner[0] if inner else type(item), in_a_line) for item in value]
    if is_dataclass(value) and not isinstance(value, type):
        return {key: item for key, item in asdict(value).items() if item is not None}
    return value
