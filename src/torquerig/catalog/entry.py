"""Common fields of all catalog entries: name, title, note; integer counts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StrictBool, StringConstraints, field_validator

from torquerig.parameter import EVIDENCE, Estimate

UNKNOWN = Estimate(note="not stated in the file")
Text = Annotated[str, StringConstraints(strict=True, strip_whitespace=True, min_length=1)]


class Record(BaseModel):
    """A frozen part of a YAML file; an unknown key is an error."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    @cached_property
    def listed(self) -> tuple[tuple[str, Estimate], ...]:
        """Each value with its dotted name in schema order; listed once, for a record is never changed in place."""
        return tuple(pair for field in type(self).model_fields for pair in _within(getattr(self, field), field))

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Return a copy with other fields, whose values are listed anew."""
        made = super().model_copy(update=update, deep=deep)
        made.__dict__.pop("listed", None)
        return made


class Evidenced(Record):
    """A record with its evidence and source.

    Parameters
    ----------
    evidence : str
        One of the tags of ``torquerig.parameter.EVIDENCE``.
    source : str
        Page or table, with its key in docs/sources.md.
    """

    evidence: Text
    source: Text

    @field_validator("evidence")
    @classmethod
    def _known_tag(cls, tag: str) -> str:
        if tag not in EVIDENCE:
            raise ValueError(f"evidence {tag!r} is none of {', '.join(EVIDENCE)}")
        return tag


class Fact(Evidenced):
    """A yes or no with its evidence."""

    value: StrictBool


class Entry(Record):
    """One catalog entry.

    Parameters
    ----------
    name : str
        The id by which scenarios and the command line name it.
    title : str
        One line of description.
    note : str
        Remarks on the reliability of the values.
    like : str
        The class from which values that the file does not state are filled; empty where none.
    """

    name: Text
    title: Text
    note: str = ""
    like: str = ""


def whole_choices(estimate: Estimate) -> Estimate:
    """Return ``estimate`` of a count if its value or each of its choices is whole, else raise ValueError."""
    if estimate.low is not None or estimate.rel_sd:
        raise ValueError("a count has no interval or standard deviation; write one_of: [4, 5]")
    counts = estimate.choices or (() if estimate.value is None else (estimate.value,))
    for count in counts:
        if count != int(count):
            raise ValueError(f"{count:g} is not a whole number; a count must be")
    return estimate


Whole = AfterValidator(whole_choices)
Order = Annotated[int, Field(gt=0, strict=True)]


def counts_of(estimate: Estimate) -> tuple[int, ...]:
    """Return the counts that ``estimate`` allows, likeliest first; empty where it is unknown."""
    if estimate.choices:
        return tuple(int(choice) for choice in estimate.choices)
    return () if estimate.value is None else (int(estimate.value),)


def estimates(record: Record) -> tuple[tuple[str, Estimate], ...]:
    """Return each value of an entry with its dotted name, such as ``ripple.cogging_native``, in schema order."""
    return record.listed


def _within(value: Any, name: str) -> Iterator[tuple[str, Estimate]]:
    if isinstance(value, Estimate):
        yield name, value
    elif isinstance(value, Record):
        yield from ((f"{name}.{inner}", known) for inner, known in value.listed)
    elif isinstance(value, Mapping):
        for key, part in value.items():
            yield from _within(part, f"{name}.{key}")
