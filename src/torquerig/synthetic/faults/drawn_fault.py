"""A fault of samples that is drawn on purpose: its parameters, the recording with it, and the truth."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, ClassVar, Literal, final, get_type_hints

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.quantities import OTHER
from torquerig.recordings.recording import Channel, Recording
from torquerig.synthetic.faults.measured import is_measured

UNDISTURBED, AFFECTED = "undisturbed_", "affected_by_"

Acts = Literal["values", "steps", "stamps", "rows", "whole"]


@dataclass(frozen=True)
class Whole:
    """The declaration of a whole number: its meaning, the smallest and the largest sensible one."""

    meaning: str
    low: int = 0
    high: int = 1_000_000

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic_core import core_schema

        return core_schema.int_schema(strict=True, ge=self.low, le=self.high)


@dataclass(frozen=True)
class Choice:
    """The declaration of a word out of several: its meaning."""

    meaning: str


@dataclass(frozen=True, kw_only=True)
class Disturbed:
    """A recording with a fault, and which samples it affects; None where it affects all of them alike."""

    recording: Recording
    affected: NDArray[np.bool_] | None = None


@dataclass(frozen=True, kw_only=True)
class DrawnFault(ABC):
    """One kind of fault of samples.

    ``zero`` are the parameters with which it changes nothing. ``acts_on`` is what the mark shows: changed values, the
    steps at which a counter goes wrong, late stamps, or rows that are missing or doubled; ``whole``: there is no mark.
    ``named_by`` are the commands that name it, ``named_as`` is in their sentences; ``unnamed`` is why none does.
    """

    __pydantic_config__: ClassVar[dict[str, str]] = {"extra": "forbid"}
    type: str
    zero: ClassVar[Mapping[str, Any]]
    acts_on: ClassVar[Acts] = "values"
    named_by: ClassVar[tuple[str, ...]] = ()
    named_as: ClassVar[str] = ""
    unnamed: ClassVar[str] = ""
    needs_times: ClassVar[bool] = False

    def __post_init__(self) -> None:
        for name, hint in get_type_hints(type(self), include_extras=True).items():
            for declared in getattr(hint, "__metadata__", ()):
                try:
                    _check(getattr(self, name), declared)
                except ValueError as error:
                    raise InputError(f"{self.type}: {name}: {error}") from None

    @abstractmethod
    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the fault, and which samples it affects."""

    @final
    def apply(self, recording: Recording, rng: np.random.Generator) -> Recording:
        """Return the recording with the fault, and its truth.

        Parameters
        ----------
        recording : Recording
        rng : Generator

        Returns
        -------
        Recording
            With ``undisturbed_NAME`` for the torque and for every other channel that the fault changes, and
            ``affected_by_FAULT``, 1 for the samples that it affects. They are truth channels.

        Raises
        ------
        InputError, RecordingError
            Where the recording lacks what the fault disturbs, or is too short for it.
        """
        torque = recording.torque_name()
        new = {
            UNDISTURBED + name: replace(one, truth=True, role=None)
            for name, one in recording.channels.items()
            if is_measured(one) and UNDISTURBED + name not in recording.channels
        }
        made = self.disturbed(replace(recording, channels={**recording.channels, **new}), rng)
        channels = {
            name: one
            for name, one in made.recording.channels.items()
            if name not in new
            or name == UNDISTURBED + torque
            or not _same(one, made.recording.channels.get(name.removeprefix(UNDISTURBED)))
        }
        if made.affected is not None:
            mark = Channel(values=made.affected.astype(np.float64), quantity=OTHER, unit="1", truth=True)
            channels[_new_name(AFFECTED + self.type, channels)] = mark
        return replace(made.recording, channels=channels)

    @final
    def described(self) -> dict[str, Any]:
        """Return the parameters [SI] by name, for the origin of a recording."""
        return asdict(self)

    @classmethod
    @final
    def without_effect(cls) -> DrawnFault:
        """Return the fault at zero size."""
        return cls(**cls.zero)

    @classmethod
    @final
    def parameters(cls) -> dict[str, tuple[Parameter | Whole | Choice, Any]]:
        """Return the declaration and the default [SI] of each parameter by name."""
        hints = get_type_hints(cls, include_extras=True)
        return {
            one.name: (hints[one.name].__metadata__[0], one.default)
            for one in fields(cls)
            if hasattr(hints[one.name], "__metadata__")
        }


def _check(value: Any, declared: object) -> None:
    if isinstance(declared, Parameter):
        declared.checked(value)
    elif isinstance(declared, Whole) and (int(value) != value or not declared.low <= value <= declared.high):
        raise ValueError(f"{value!r} is not possible; write a whole number from {declared.low} to {declared.high}")


def _same(truth: Channel, measured: Channel | None) -> bool:
    return (
        measured is not None
        and (truth.unit, truth.si_per_unit) == (measured.unit, measured.si_per_unit)
        and np.array_equal(truth.values, measured.values)
    )


def _new_name(name: str, taken: Mapping[str, Channel]) -> str:
    number = 2
    free = name
    while free in taken:
        free, number = f"{name}_{number}", number + 1
    return free
