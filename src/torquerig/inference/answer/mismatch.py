"""A place where recordings and model differ, as a value of the contract."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Mismatch:
    """One place where recordings and model differ, as the contract states it."""

    domain: str
    axis: str
    at: float
    width: float
    recordings: tuple[str, ...]
    excess_dB: float  # noqa: N815 (the contract's name)
    share_of_misfit: float
    p_value: float
