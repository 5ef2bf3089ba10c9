"""The parameters of a fault as a table: name, default with its unit, meaning."""

from __future__ import annotations

from typing import Any

from torquerig.parameter import Parameter
from torquerig.synthetic.faults.drawn_fault import DrawnFault
from torquerig.units import written_quantity


def parameter_rows(fault: type[DrawnFault]) -> list[list[str]]:
    """Return one row per parameter, in the spelling that ``--set`` and YAML accept."""
    return [[name, _written(default, declared), declared.meaning]
            for name, (declared, default) in fault.parameters().items()]  # fmt: skip


def _written(default: Any, declared: object) -> str:
    if not isinstance(declared, Parameter):
        return str(default)
    if declared.unit == "1/s":
        return f"{60 * default:.6g} per minute"
    return written_quantity(default, declared.unit)
