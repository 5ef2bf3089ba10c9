"""One number with its uncertainty as a scenario states it, in SI."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf, isfinite, sqrt
from typing import Any

from torquerig.catalog.chosen_draws import draws_of
from torquerig.errors import UnitError
from torquerig.parameter import Estimate, Parameter
from torquerig.units import in_unit, parse_quantity, written_quantity

_SIGN = r"(?:±|\+/-|\+-)"
_IN_BRACKETS = re.compile(rf"^\s*\(\s*([^±()]+?)\s*{_SIGN}\s*([^±()]+?)\s*\)\s*(.*?)\s*$")
_TOLERANCE = re.compile(rf"^\s*([^±]+?)\s*{_SIGN}\s*([^±]*?)\s*$")
_BARE_NUMBER = re.compile(r"^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$")


@dataclass(frozen=True, kw_only=True)
class NumberText:
    """How a number is read from a scenario and written into it.

    Parameters
    ----------
    unit : str
        In which it is counted.
    read, write : callable
        From text or number to the value, with its bounds checked, and back.
    counted : callable
        From the value to its number in ``unit``.
    """

    unit: str
    read: Callable[[Any], float]
    write: Callable[[float], Any]
    counted: Callable[[float], float] = float

    @classmethod
    def of(cls, parameter: Parameter) -> NumberText:
        """Return the reading of a declared parameter."""
        unit = parameter.unit
        return cls(
            unit=unit, read=parameter.read, write=lambda number: written_quantity(number, unit),
            counted=lambda number: in_unit(number, unit),
        )  # fmt: skip

    @classmethod
    def bare(cls) -> NumberText:
        """Return the reading of a number without a unit, such as a phase [rad]."""
        return cls(unit="1", read=_bare, write=float)

    def interval(self, low: float, high: float) -> str:
        """Return an interval for a table, as the catalog shows one."""
        return f"? ({self.counted(low):.3g}..{self.counted(high):.3g}{self._suffix})"

    def shown(self, number: float) -> str:
        """Return the number with its unit for a table."""
        return f"{self.counted(number):.4g}{self._suffix}"

    @property
    def _suffix(self) -> str:
        return "" if self.unit == "1" else f" {self.unit}"


class UncertaintyError(ValueError):
    """What is wrong below one key of an uncertain number."""

    def __init__(self, key: str, text: str) -> None:
        super().__init__(text)
        self.key = key


@dataclass(frozen=True, kw_only=True)
class Uncertain:
    """A number with its uncertainty: what the rig has, and what is known.

    Parameters
    ----------
    written
        The value as a scenario would state it alone.
    known : Estimate
        Its value, interval and relative standard deviation [SI].
    assumed : str
        Which value of which interval was drawn; empty where the file states the value.
    kept : str
        The stated value with its uncertainty; empty for one that was drawn, or that has none.
    """

    written: Any
    known: Estimate
    assumed: str = ""
    kept: str = ""


def uncertain_number(written: Any, text: NumberText, *, name: str, seed: int) -> Uncertain | None:
    """Return the number that ``written`` states with an uncertainty; None for a number alone.

    ``{value, rel_sd}`` is log-normal around the value; ``{low, high}`` is an interval from which the value is drawn, by
    ``seed`` and ``name``; with a ``value`` in it, and for ``5 N*m ± 10 %``, that value is kept. An interval counts as
    uniform, log-uniform where high/low > 5, as in the catalog.

    Raises
    ------
    UnitError, ValueError
        What is wrong, and what to write.
    """
    if isinstance(written, str):
        parts = _tolerance_of(written)
        return None if parts is None else _with_tolerance(written, *parts, text)
    if not isinstance(written, Mapping):
        return None
    if ("low" in written) != ("high" in written):
        raise ValueError("an interval needs both low and high; add the other one")
    if "low" in written:
        if "rel_sd" in written:
            raise ValueError("an interval and a rel_sd are stated; keep one")
        return _interval(written, text, name=name, seed=seed)
    if "value" not in written:
        raise ValueError("the value is missing; write {value: ..., rel_sd: 0.1} or {low: ..., high: ...}")
    return _around(written, _relative(written.get("rel_sd", 0.0)), text)


def deviation(known: Estimate) -> float:
    """Return the standard deviation of an uncertain number around its value, in its unit.

    An interval that contains 0 has no relative one; that of the difference of two uniform samples is returned.
    """
    if known.low is not None and known.high is not None and not known.rel_sd:
        return (known.high - known.low) / sqrt(6)
    return known.rel_sd * abs(known.value or 0.0)


def _around(written: Mapping[str, Any], rel_sd: float, text: NumberText) -> Uncertain:
    number = text.read(written["value"])
    if rel_sd and number == 0:
        raise ValueError("0 has no relative standard deviation; write an interval {low: ..., high: ...}")
    kept = f"{text.shown(number)}, rel_sd {rel_sd:g}" if rel_sd else ""
    return Uncertain(written=written["value"], known=Estimate(number, rel_sd=rel_sd, evidence="REF"), kept=kept)


def _interval(written: Mapping[str, Any], text: NumberText, *, name: str, seed: int) -> Uncertain:
    low, high = (_read(written, key, text) for key in ("low", "high"))
    if low > high:
        raise ValueError(f"low {written['low']!r} is above high {written['high']!r}; exchange them")
    if "value" in written:
        return _within(written, low, high, text)
    number = Estimate(low=low, high=high).draw(draws_of(seed, name))
    known = _known(number, low, high, text.unit)
    return Uncertain(
        written=text.write(number), known=known, assumed=f"{text.shown(number)} of {text.interval(low, high)}"
    )


def _within(written: Mapping[str, Any], low: float, high: float, text: NumberText) -> Uncertain:
    number = text.read(written["value"])
    if not low <= number <= high:
        raise ValueError("the value is outside low and high; correct one of them")
    return _kept(written["value"], number, low, high, text)


def _kept(written: Any, number: float, low: float, high: float, text: NumberText) -> Uncertain:
    """Return a stated value in its interval."""
    known = _known(number, low, high, text.unit)
    return Uncertain(written=written, known=known, kept=f"{text.shown(number)} of {text.interval(low, high)}")


def _read(written: Mapping[str, Any], key: str, text: NumberText) -> float:
    try:
        return text.read(written[key])
    except (UnitError, ValueError) as error:
        raise UncertaintyError(key, str(error)) from None


def _known(number: float, low: float, high: float, unit: str) -> Estimate:
    """Return the estimate of a number in its interval, with the standard deviation that the catalog's have."""
    rel_sd = Estimate(low=low, high=high).part_rel_sd
    return Estimate(number, low, high, rel_sd=rel_sd, evidence="REF", unit=unit)


def _tolerance_of(written: str) -> tuple[str, str] | None:
    """Return value and tolerance of ``5 N*m ± 10 %`` or ``(5 ± 0.2) N*m`` as texts."""
    match = _IN_BRACKETS.match(written)
    if match is not None:
        return f"{match[1]} {match[3]}".strip(), f"{match[2]} {match[3]}".strip()
    match = _TOLERANCE.match(written)
    return None if match is None else (match[1], match[2])


def _with_tolerance(written: str, value: str, tolerance: str, text: NumberText) -> Uncertain:
    is_share = tolerance.endswith(("%", "ppm"))
    if is_share and value.endswith("%"):
        raise ValueError(
            f"{written!r} may be a share of the value or percentage points; write {{value: {value}, rel_sd: ...}} or "
            "{low: ..., high: ...}"
        )
    if not is_share and _BARE_NUMBER.match(value) and not _BARE_NUMBER.match(tolerance):
        value = f"{value} {_unit_of(tolerance)}"  # 5 ± 0.2 N*m: one unit for both
    value_read = _plain(value, text)
    number = text.read(value_read)
    width = abs(number) * parse_quantity(tolerance, "1") if is_share else _width(tolerance, value, written, text)
    if width < 0:
        raise ValueError(f"{written!r} has a negative tolerance; write it without its sign")
    low, high = (text.read(text.write(end)) for end in (number - width, number + width))
    return _kept(value_read, number, low, high, text)


def _plain(value: str, text: NumberText) -> Any:
    return float(value) if text.unit == "1" and _BARE_NUMBER.match(value) else value


def _unit_of(quantity: str) -> str:
    return re.sub(r"^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s*", "", quantity)


def _width(tolerance: str, value: str, written: str, text: NumberText) -> float:
    if _BARE_NUMBER.match(tolerance) and text.unit != "1":
        unit = _unit_of(value)
        raise UnitError(f"{written!r}: the tolerance has no unit; write ± {tolerance} {unit} or ± {tolerance} %")
    return parse_quantity(tolerance, text.unit)


def _relative(written: Any) -> float:
    """Return a relative standard deviation, stated as a number or in per cent."""
    try:
        spread = parse_quantity(written, "1") if isinstance(written, str) else written
    except UnitError:
        spread = None
    if isinstance(spread, bool) or not isinstance(spread, int | float) or not 0 <= spread < inf:
        text = f"{written!r} is no standard deviation; write the relative standard deviation as a number, such as 0.1"
        raise UncertaintyError("rel_sd", text)
    return float(spread)


def _bare(written: Any) -> float:
    number = float(written) if isinstance(written, int | float) and not isinstance(written, bool) else None
    if isinstance(written, str) and _BARE_NUMBER.match(written):
        number = float(written)
    if number is None or not isfinite(number):
        raise ValueError(f"{written!r} is no number; write one, such as 0.5")
    return number
