"""Torque ripple of a motor: line by line where it is known, else by class, as shares of its torque."""

from __future__ import annotations

from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from torquerig.catalog.entry import UNKNOWN, Order, Record
from torquerig.parameter import Estimate, Parameter
from torquerig.renamed import current_name

LineTorque = Annotated[Estimate, Parameter("N*m", "zero-to-peak torque of the line", low=0)]
Lines = dict[Order, LineTorque]
RENAMED = {"cogging_as_published": "cogging_per_pole"}


class KnownLines(Record):
    """Zero-to-peak torques [N m] by motor order [1/rev], on the motor's shaft, independent of the load.

    Parameters
    ----------
    mechanical : dict of int to Estimate
        Imbalance and runout of the rotor and their harmonics.
    cogging_per_pole : dict of int to Estimate
        Order LCM(slots, magnets) / magnets and its harmonics; once ``cogging_as_published``.
    electrical : dict of int to Estimate
        The electrical period (pole pairs per turn) and its harmonics.
    """

    mechanical: Lines = Field(default_factory=dict)
    cogging_per_pole: Lines = Field(default_factory=dict)
    electrical: Lines = Field(default_factory=dict)

    @model_validator(mode="before")
    @classmethod
    def _under_present_keys(cls, written: Any) -> Any:
        if not isinstance(written, dict) or not RENAMED.keys() & written.keys():
            return written
        present = {current_name(str(key), RENAMED, what="catalog key"): value for key, value in written.items()}
        if len(present) < len(written):
            raise ValueError(f"a key has its old and its present name; keep one of {', '.join(map(str, written))}")
        return present


class Ripple(Record):
    """The torque ripple of one motor.

    A simulation uses ``known_lines`` where they are stated; the shares then only document the class. All shares are
    zero to peak.

    Raises
    ------
    ValueError
        When neither known lines nor the shares of a class are stated.
    """

    known_lines: KnownLines | None = None
    cogging_native: Annotated[
        Estimate, Parameter("1", "share of rated torque, at the motor order LCM(slots, magnets)", low=0, high=1)
    ] = UNKNOWN
    cogging_tolerance: Annotated[
        Estimate, Parameter("1", "share of rated torque, at each of the motor orders slots and magnets", low=0, high=1)
    ] = UNKNOWN
    six_pulse_ripple: Annotated[
        Estimate, Parameter("1", "share of the transmitted torque, at motor order 6 x pole pairs", low=0, high=1)
    ] = UNKNOWN
    current_offset_ripple: Annotated[
        Estimate, Parameter("1", "share of rated torque, at the motor order of the pole pairs", low=0, high=1)
    ] = UNKNOWN
    current_gain_ripple: Annotated[
        Estimate, Parameter("1", "share of the transmitted torque, at motor order 2 x pole pairs", low=0, high=1)
    ] = UNKNOWN
    rotor_slot_ripple: Annotated[
        Estimate, Parameter("1", "share of the transmitted torque, at the motor order of the rotor bars", low=0, high=1)
    ] = UNKNOWN
    mechanical_unbalance: Annotated[
        Estimate, Parameter("1", "share of rated torque, at motor order 1", low=0, high=1)
    ] = UNKNOWN

    @model_validator(mode="after")
    def _is_not_empty(self) -> Self:
        shares = (self.cogging_native, self.six_pulse_ripple, self.rotor_slot_ripple)
        if self.known_lines is None and all(share.unknown for share in shares):
            raise ValueError("the ripple is empty; state known_lines, or cogging_native and six_pulse_ripple")
        return self
