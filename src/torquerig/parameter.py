"""Parameters of a model: unit, bounds and meaning; and estimates: value, interval, evidence and source."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import exp, inf, isfinite, log, sqrt
from typing import TYPE_CHECKING, Any, Protocol

from torquerig.errors import UnitError
from torquerig.units import IN_A_LINE, in_unit, parse_quantity, unreasonable, with_unit, written_quantity

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, ValidationInfo
    from pydantic_core import CoreSchema

EVIDENCE = {
    "DOC": "printed in the reference report, or in the maker's own table for this very product",
    "SC": "seen in a maker's table for a product of the same class",
    "MEM": "same-class figure from general knowledge, not checked",
    "RT": "rule of thumb",
    "CALC": "computed from tagged numbers",
    "REF": "the nominal reference rig",
    "FIT": "fitted to recordings",
    "CLASS": "not stated by the maker; the interval of the class that the entry names",
}


class RandomNumbers(Protocol):
    """The part of ``numpy.random.Generator`` by which values are drawn."""

    def uniform(self, low: float = 0.0, high: float = 1.0, /) -> float:
        """Return a number between low and high."""

    def standard_normal(self) -> float:
        """Return a number of the standard normal distribution."""

    def choice(self, choices: Any, /) -> Any:
        """Return one of the choices."""


@dataclass(frozen=True)
class Estimate:
    """Knowledge of one value [SI]: documented, an interval, a choice, or a relative standard deviation.

    ``value`` alone is documented; ``low``..``high`` is uniform, log-uniform where high/low > 5 (the catalog's rule);
    ``choices`` are equally likely; ``rel_sd`` is the standard deviation of a log-normal distribution around ``value``.
    All ``None`` is unknown.
    """

    value: float | None = None
    low: float | None = None
    high: float | None = None
    choices: tuple[float, ...] = ()
    rel_sd: float = 0.0
    evidence: str = "RT"
    source: str = ""
    unit: str = "1"
    note: str = ""

    @property
    def documented(self) -> bool:
        """Whether the value is documented, so that a table may show it as a number."""
        return self.value is not None and self.low is None and not self.choices

    @property
    def unknown(self) -> bool:
        """Whether nothing is known, so that the value cannot be sampled."""
        return self.value is None and self.low is None and not self.choices

    @property
    def open(self) -> bool:
        """Whether a sample of the value is random: an interval, a choice, or a value with a standard deviation."""
        return self.low is not None or bool(self.choices) or bool(self.rel_sd)

    @property
    def bounds(self) -> tuple[float, float]:
        """Lowest and highest possible value [SI]; one standard deviation around it where stated; NaN if unknown."""
        if self.choices:
            return min(self.choices), max(self.choices)
        if self.low is not None and self.high is not None:
            return self.low, self.high
        if self.value is None:
            return float("nan"), float("nan")
        return self.value * exp(-self.rel_sd), self.value * exp(self.rel_sd)

    @property
    def part_rel_sd(self) -> float:
        """Relative standard deviation of a real part around the value of the scenario [1]; 0 if unknown.

        ``rel_sd`` where stated; for an interval, from which that value is sampled, the rms of ``ln(one / other)`` of
        two log-uniform samples: ``ln(high / low) / sqrt(6)``. An interval from 0 is uniform: sqrt(2/3), the standard
        deviation of the difference of two samples over their mean.
        """
        if self.low == 0 and self.high is not None and self.high > 0:
            return sqrt(2 / 3)
        if self.low is None or self.high is None or not 0 < self.low < self.high:
            return self.rel_sd
        return log(self.high / self.low) / sqrt(6)

    def nominal(self) -> float:
        """Return the stated value, else the middle of the interval (geometric where it is log-uniform) [SI]."""
        if self.value is not None:
            return self.value
        if self.choices:
            return self.choices[0]
        low, high = self.bounds
        return sqrt(low * high) if low > 0 and high / low > 5 else 0.5 * (low + high)

    def draw(self, rng: RandomNumbers) -> float:
        """Return one random sample [SI]; a documented value is returned unchanged."""
        if self.choices:
            return float(rng.choice(self.choices))
        if self.low is not None and self.high is not None:
            if self.low > 0 and self.high / self.low > 5:
                return float(exp(rng.uniform(log(self.low), log(self.high))))
            return float(rng.uniform(self.low, self.high))
        if self.value is None:
            return float("nan")
        return float(self.value * exp(self.rel_sd * rng.standard_normal())) if self.rel_sd else self.value

    def shown(self, unit: str | None = None) -> str:
        """Return the text for a table: the number where documented, else ``?`` with the interval."""
        unit = unit or self.unit
        suffix = "" if unit == "1" else f" {unit}"
        if self.unknown:
            return "?"
        if self.documented and self.value is not None:
            return f"{_digits(in_unit(self.value, unit), 4)}{suffix}"
        if self.choices:
            return f"? ({' or '.join(_digits(in_unit(choice, unit), 4) for choice in self.choices)}{suffix})"
        low, high = (_digits(in_unit(end, unit), 3) for end in self.bounds)
        return f"? ({low}{suffix})" if low == high else f"? ({low}..{high}{suffix})"

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        raise TypeError("annotate an Estimate field with Parameter(unit, meaning)")


WRITTEN_AS = "torquerig_written_as"
"""Key in the metadata of a field's schema: how its number is written, for the JSON Schema of the file."""


@dataclass(frozen=True)
class Parameter:
    """The declaration of a numeric field: ``inertia: Annotated[float, Parameter("kg*m^2", "rotor inertia", low=0)]``.

    pydantic reads such a field from text with a unit; a bare number is refused where a unit is possible. On an
    ``Estimate`` field the YAML holds a mapping with value, or low and high, or one_of, and with evidence and source.
    With ``{"in_a_line": True}`` as pydantic's context the unit is that of linear motion, unless ``turns``: such a
    field belongs to the shaft of a part that turns rotation into motion in a line.
    """

    unit: str
    meaning: str
    low: float = -inf
    high: float = inf
    above: float = -inf
    turns: bool = False

    @property
    def in_a_line(self) -> Parameter:
        """The same parameter for linear motion: N for N*m, kg for kg*m^2; unchanged where it is of what turns."""
        return self if self.turns else replace(self, unit=IN_A_LINE.get(self.unit, self.unit))

    def read(self, written: Any) -> float:
        """Return the SI number written as ``written``; UnitError or ValueError says what to write instead."""
        if isinstance(written, bool) or written is None:
            raise UnitError(f"{written!r} is not a quantity; write for example '1.5 {self.unit}'")
        if isinstance(written, int | float):
            if self.unit != "1":
                raise UnitError(f"{written!r} has no unit; write {with_unit(written, self.unit)}")
            number = float(written)
        elif isinstance(written, str):
            number = parse_quantity(written, self.unit)
        else:
            raise UnitError(f"{written!r} is not a quantity; write for example '1.5 {self.unit}'")
        return self.checked(number)

    def checked(self, number: float) -> float:
        """Return ``number`` [SI] if it is finite and within the bounds, else raise ValueError with the bound."""
        if not isfinite(number):
            raise ValueError(f"{number} is not a finite number")
        if number < self.low or number > self.high or number <= self.above:
            bound = f"at least {self.low:g}" if number < self.low else f"at most {self.high:g}"
            bound = f"more than {self.above:g}" if number <= self.above else bound
            raise ValueError(f"{_written(number, self.unit)} is out of range: {self.meaning} must be {bound}")
        problem = unreasonable(number, self.unit)
        if problem:
            raise ValueError(f"{_written(number, self.unit)} is {problem} for {self.meaning}")
        return number

    def read_estimate(self, written: Any) -> Estimate:
        """Return the Estimate that a mapping states; a value without a document needs bounds."""
        if not isinstance(written, Mapping):
            raise ValueError(
                f"{written!r} needs its evidence; write a mapping with value, or low and high, and evidence and source"
            )
        extra = set(written) - {"value", "low", "high", "one_of", "rel_sd", "evidence", "source", "note", "unknown"}
        if extra:
            raise ValueError(
                f"unknown key {sorted(map(str, extra))[0]!r}; allowed are value, low, high, one_of, rel_sd, "
                "unknown, evidence, source, note"
            )
        evidence, source = str(written.get("evidence", "")), str(written.get("source", ""))
        if evidence not in EVIDENCE:
            raise ValueError(f"evidence {evidence!r} is none of {', '.join(EVIDENCE)}")
        if not source:
            raise ValueError("a source is missing; add source: with the key of the table or page")
        low, high = (self.read(written[end]) if end in written else None for end in ("low", "high"))
        if (low is None) != (high is None) or (low is not None and high is not None and low > high):
            raise ValueError("an interval needs both low and high, low first")
        choices = tuple(self.read(choice) for choice in _listed(written.get("one_of", [])))
        value = self.read(written["value"]) if "value" in written else None
        if value is not None and low is not None and high is not None and not low <= value <= high:
            raise ValueError("the value is outside low and high; correct one of them")
        estimate = Estimate(
            value,
            low,
            high,
            choices,
            _spread(written.get("rel_sd", 0.0)),
            evidence,
            source,
            self.unit,
            str(written.get("note", "")),
        )
        if estimate.unknown and not written.get("unknown"):
            raise ValueError("nothing is stated; write value, low and high, one_of, or unknown: true")
        if estimate.documented and evidence not in ("DOC", "REF", "FIT") and not estimate.rel_sd:
            raise ValueError(f"a value with evidence {evidence} is no document; add low and high")
        return estimate

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema

        def validator(written: Any, info: ValidationInfo) -> Any:
            if source is not float and isinstance(written, source):
                return written
            here = self.in_a_line if (info.context or {}).get("in_a_line") else self
            try:
                return here.read_estimate(written) if source is Estimate else here.read(written)
            except UnitError as error:
                raise ValueError(str(error)) from None

        metadata = {WRITTEN_AS: {"meaning": self.meaning, "unit": self.unit, "estimate": source is Estimate}}
        return core_schema.with_info_plain_validator_function(validator, metadata=metadata)


def _written(number: float, unit: str) -> str:
    return written_quantity(float(_digits(in_unit(number, unit), 12)), unit)


def _listed(written: Any) -> list[Any]:
    if not isinstance(written, list):
        raise ValueError(f"one_of is {written!r}; write a list of the possible values, such as one_of: [4, 5]")
    return written


def _spread(written: Any) -> float:
    if isinstance(written, bool) or not isinstance(written, int | float) or not 0 <= written < inf:
        raise ValueError(f"rel_sd is {written!r}; write the relative standard deviation as a number, such as 0.1")
    return float(written)


def _digits(number: float, digits: int) -> str:
    text = f"{number:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text and abs(number) < 1e7 else text
