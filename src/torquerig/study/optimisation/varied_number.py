"""A number of a filter that an optimisation varies between two limits, such as the cutoff of a low-pass."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import exp, log
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import TypeAdapter, ValidationError

from torquerig.document import problem_text
from torquerig.errors import InputError, did_you_mean
from torquerig.parameter import Parameter
from torquerig.study.definition import Study
from torquerig.units import in_unit

if TYPE_CHECKING:
    from torquerig.filters.chains.chain_file import Stages

_UNIT = re.compile(r"^\s*[+-]?[\d.]+(?:[eE][+-]?\d+)?\s*(.*?)\s*$")


@dataclass(frozen=True, kw_only=True)
class VariedNumber:
    """One number of a stage of a filter chain, and its limits.

    Parameters
    ----------
    chain : str
    stage : int
        Row of the stage in its chain, from 0.
    key : str
        Of the number in the YAML of the stage.
    low, high : float
        Limits in the unit of the filter's field [SI].
    unit : str
        In which it is shown; "1" for a number without.
    whole : bool
        Whether it is a count.
    """

    chain: str
    stage: int
    key: str
    low: float
    high: float
    unit: str = "1"
    whole: bool = False

    @property
    def name(self) -> str:
        """The name in tables: ``low_pass_20Hz.cutoff``."""
        return f"{self.chain}.{self.key}"

    def at(self, share: float) -> float:
        """Return the number at a share 0..1 of the way from low to high; in equal ratios where both are above 0."""
        if self.whole:
            return float(round(self.low + share * (self.high - self.low)))
        if self.low > 0:
            return exp(log(self.low) + share * (log(self.high) - log(self.low)))
        return self.low + share * (self.high - self.low)

    def shown(self, number: float) -> str:
        """Return the number with key and unit: ``cutoff 12.3 Hz``."""
        return f"{self.key} {in_unit(number, self.unit):.3g}{'' if self.unit == '1' else f' {self.unit}'}"


def varied_texts(study: Study, numbers: Sequence[VariedNumber], values: Sequence[float]) -> Mapping[str, Stages]:
    """Return the stages of the chains whose numbers vary, with these values [SI]."""
    changed: dict[str, Stages] = {}
    for number, value in zip(numbers, values, strict=True):
        stages = list(changed.get(number.chain, study.filter_texts[number.chain]))
        written = int(value) if number.whole else float(value)
        stages[number.stage] = stages[number.stage].model_copy(update={number.key: written})
        changed[number.chain] = tuple(stages)
    return changed


def varied_number(text: str, study: Study) -> VariedNumber:
    """Return what ``FILTER.KEY=LOW..HIGH`` states, such as ``low_pass_20Hz.cutoff=5..60 Hz``.

    Where several stages of a chain have the key, ``FILTER.2.KEY`` names that of the second stage.

    Raises
    ------
    InputError
        For another form, an unknown filter or key, and limits that the filter cannot have.
    """
    path, equals, limits = text.partition("=")
    words, ends = path.strip().split("."), limits.split("..")
    if not equals or len(words) not in (2, 3) or len(ends) != 2:
        raise InputError(
            f"--vary {text}: not of the form FILTER.KEY=LOW..HIGH; write for example "
            "--vary 'low_pass_20Hz.cutoff=5..60 Hz'"
        )
    chain, key = words[0], words[-1]
    known = [name for name in dict.fromkeys((*study.settings.filters.names, study.settings.present.filter))
             if name in study.filter_texts]  # fmt: skip
    if chain not in known:
        raise InputError(f"--vary {text}: the study has no filter {chain!r}; {did_you_mean(chain, known)}")
    row = _stage_of(text, study.filter_texts[chain], key, words[1] if len(words) == 3 else None)
    return _limited(text, study.filter_texts[chain][row], ends, chain=chain, row=row, key=key)


def _stage_of(text: str, stages: Stages, key: str, stated: str | None) -> int:
    """Return the row of the stage that has the number."""
    having = [row for row, stage in enumerate(stages) if key in _numbers(stage)]
    if stated is not None:
        row = int(stated) - 1 if stated.isdigit() else -1
        if row not in having:
            rows = ", ".join(str(one + 1) for one in having) or "none"
            raise InputError(f"--vary {text}: stage {stated} has no number {key!r}; stages that have one: {rows}")
        return row
    if not having:
        keys = list(dict.fromkeys(one for stage in stages for one in _numbers(stage)))
        remedy = did_you_mean(key, keys) if keys else "none of its stages has a number; leave --vary out"
        raise InputError(f"--vary {text}: the filter has no number {key!r}; {remedy}")
    if len(having) > 1:
        chain = text.split(".", maxsplit=1)[0]
        rows = ", ".join(f"{chain}.{row + 1}.{key}" for row in having)
        raise InputError(f"--vary {text}: several stages have {key!r}; write one of {rows}")
    return having[0]


def _numbers(stage: Any) -> list[str]:
    """Return the keys of a stage that hold one number."""
    return [key for key, field in type(stage).model_fields.items() if field.annotation in (float, int)]


def _limited(text: str, stage: Any, ends: Sequence[str], *, chain: str, row: int, key: str) -> VariedNumber:
    field = type(stage).model_fields[key]
    unit = next((note.unit for note in field.metadata if isinstance(note, Parameter)), "1")
    last = _UNIT.match(ends[1])
    # 5..60 Hz has one unit for both
    texts = [f"{ends[0].strip()} {last[1]}" if last and _unit_of(ends[0]) == "" else ends[0].strip(), ends[1].strip()]
    hint: Any = Annotated[(field.annotation, *field.metadata)]
    adapter: TypeAdapter[Any] = TypeAdapter(hint)
    try:
        low, high = (float(adapter.validate_python(_plain(one.strip(), unit))) for one in texts)
    except ValidationError as error:
        detail = error.errors()[0]
        why = str(detail["ctx"]["error"]) if detail["type"] == "value_error" else problem_text(detail["type"], detail)
        raise InputError(f"--vary {text}: {why}") from None
    if not low < high:
        raise InputError(
            f"--vary {text}: {ends[0].strip()} to {ends[1].strip()} is no range; write the lower end first"
        )
    return VariedNumber(
        chain=chain, stage=row, key=key, low=low, high=high, unit=unit, whole=field.annotation is int
    )  # fmt: skip


def _unit_of(end: str) -> str | None:
    found = _UNIT.match(end)
    return None if found is None else found[1]


def _plain(end: str, unit: str) -> Any:
    """Return a number without a unit as a number, as YAML would read it."""
    if unit != "1":
        return end
    try:
        return int(end)
    except ValueError:
        return end
