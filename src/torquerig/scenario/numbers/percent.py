"""The occupancy of a scenario in percent."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator

from torquerig.errors import UnitError
from torquerig.units import parse_quantity


def read_percent(written: Any) -> float:
    """Return an occupancy in percent: ``21`` and ``"21 %"`` are 21."""
    if isinstance(written, bool) or not isinstance(written, int | float | str):
        raise ValueError(f"{written!r} is no occupancy; write for example 21 %")
    try:
        percent = float(written) if isinstance(written, int | float) else 100 * parse_quantity(written, "1")
    except UnitError as error:
        raise ValueError(str(error)) from None
    if isinstance(written, str) and "%" not in written:
        raise ValueError(f"{written!r} has no unit; write '{written} %'")
    if not 0 <= percent <= 100:
        raise ValueError(f"{percent:g} % is no occupancy; it lies between 0 and 100 %")
    return percent


Percent = Annotated[float, BeforeValidator(read_percent)]
