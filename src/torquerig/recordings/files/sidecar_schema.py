"""The keys that a sidecar may have, with their bounds: the schema that the YAML is checked against."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, partial
from typing import TYPE_CHECKING, Annotated, Any

from torquerig.errors import did_you_mean
from torquerig.recordings.quantities import QUANTITIES, ROLES
from torquerig.recordings.run import PROFILES
from torquerig.recordings.tacho_edges import PER_MOTOR_TURN, PER_OUTPUT_TURN

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, TypeAdapter
    from pydantic_core import CoreSchema


FASTEST = 1e7  # [rpm] a hundred times the fastest spindles
LONGEST = 1e9  # [s] 30 years
IN_OTHERS = ("pole_pairs", "slots", PER_MOTOR_TURN, PER_OUTPUT_TURN, "notes")
"""Keys of ``run:`` that a :class:`~torquerig.recordings.run.Run` keeps in ``others``."""


@dataclass(frozen=True)
class _Number:
    """A finite number within bounds; text and true/false are refused."""

    gt: float | None = None
    ge: float | None = None
    le: float | None = None

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema

        return core_schema.float_schema(strict=True, allow_inf_nan=False, gt=self.gt, ge=self.ge, le=self.le)


@dataclass(frozen=True)
class _Count:
    """A whole number within bounds; text, true/false and fractions are refused."""

    ge: int = 1
    le: int = 1_000_000

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema

        return core_schema.int_schema(strict=True, ge=self.ge, le=self.le)


@dataclass(frozen=True)
class _Word:
    """One of a list of words; another one is refused with the close matches."""

    check: Callable[[str], str]

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema

        return core_schema.no_info_after_validator_function(self.check, core_schema.str_schema(strict=True))


def _one_of(words: Iterable[str], kind: str, written: str) -> str:
    if written not in words:
        raise ValueError(f"{written!r} is no {kind}; {did_you_mean(written, words)}")
    return written


@dataclass(frozen=True, kw_only=True)
class WrittenChannel:
    """One entry of ``channels:`` without its scale, because the key of the scale depends on the unit."""

    __pydantic_config__ = {"extra": "forbid"}  # noqa: RUF012 (pydantic's own protocol)

    quantity: Annotated[str, _Word(partial(_one_of, QUANTITIES, "quantity"))]
    unit: str | None = None
    truth: bool = False
    of: str | None = None
    role: Annotated[str, _Word(partial(_one_of, ROLES, "role"))] | None = None
    tare: bool = False
    pulses_per_rev: Annotated[float, _Number(gt=0, le=1e6)] | None = None
    teeth: Annotated[int, _Count()] | None = None
    shaft: Annotated[str, _Word(partial(_one_of, ("motor", "output"), "shaft of a tacho"))] | None = None


@dataclass(frozen=True, kw_only=True)
class WrittenEncoder:
    """What the encoder's data sheet says: counts of one turn, for angle channels in counts without their own scale."""

    __pydantic_config__ = {"extra": "forbid"}  # noqa: RUF012

    counts_per_rev: Annotated[float, _Number(gt=0, le=1e12)]


@dataclass(frozen=True, kw_only=True)
class WrittenSetPoint:
    """The points of a tabulated profile: straight lines between them, ``repeats`` times (null: without end)."""

    __pydantic_config__ = {"extra": "forbid"}  # noqa: RUF012

    time_s: list[Annotated[float, _Number(ge=0, le=LONGEST)]]
    speed_rpm: list[Annotated[float, _Number(ge=-FASTEST, le=FASTEST)]]
    load_Nm: list[Annotated[float, _Number(ge=0, le=1e9)]] | None = None  # noqa: N815 (as the file writes it)
    repeats: Annotated[int, _Count()] | None = 1


@dataclass(frozen=True, kw_only=True)
class WrittenRun:
    """The keys of ``run:``, in the units of their names; ``others`` holds further conditions, ``notes`` any text."""

    __pydantic_config__ = {"extra": "forbid"}  # noqa: RUF012

    motor: str | None = None
    gear_ratio: Annotated[float, _Number(ge=1e-6, le=1e6)] | None = None
    travel_per_turn_mm: Annotated[float, _Number(ge=1e-6, le=1e6)] | None = None
    speed_rpm: Annotated[float, _Number(ge=-FASTEST, le=FASTEST)] | None = None
    profile: Annotated[str, _Word(partial(_one_of, PROFILES, "profile"))] = "steady"
    set_point: WrittenSetPoint | None = None
    occupancy_percent: Annotated[float, _Number(ge=0, le=100)] | None = None
    particle_size_mm: Annotated[float, _Number(ge=0, le=1e6)] | None = None
    pole_pairs: Annotated[int, _Count(le=10_000)] | None = None
    slots: Annotated[int, _Count(ge=0, le=10_000)] | None = None
    tacho_pulses_per_motor_turn: Annotated[float, _Number(gt=0, le=1e6)] | None = None
    tacho_pulses_per_output_turn: Annotated[float, _Number(gt=0, le=1e6)] | None = None
    notes: Any = None
    others: dict[str, Any] | None = None


@dataclass(frozen=True, kw_only=True)
class WrittenSidecar:
    """A whole sidecar file."""

    __pydantic_config__ = {"extra": "forbid"}  # noqa: RUF012

    sample_rate_Hz: Annotated[float, _Number(ge=1e-6, le=1e9)] | None = None  # noqa: N815 (as the file writes it)
    channels: dict[str, WrittenChannel] | None = None
    run: WrittenRun | None = None
    origin: dict[str, Any] | None = None
    encoder: WrittenEncoder | None = None
    teeth: Any = None
    notes: Any = None


@cache
def sidecar_schema() -> TypeAdapter[WrittenSidecar]:
    """Return the schema of a sidecar; pydantic is imported on the first call."""
    from pydantic import TypeAdapter

    return TypeAdapter(WrittenSidecar)
