"""Schema of a coupling file: torsional stiffness, damping, and the orders of its jaws."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import model_validator

from torquerig.catalog.entry import UNKNOWN, Entry, Whole
from torquerig.parameter import Estimate, Parameter


class Coupling(Entry):
    """One shaft coupling.

    Raises
    ------
    ValueError
        When none of damping, damping_ratio and loss_factor is stated.
    """

    kind: Literal["bellows", "jaw"]
    rated_torque: Annotated[Estimate, Parameter("N*m", "rated torque", above=0)] = UNKNOWN
    stiffness: Annotated[Estimate, Parameter("N*m/rad", "dynamic torsional stiffness", above=0)]
    static_stiffness: Annotated[Estimate, Parameter("N*m/rad", "static torsional stiffness", above=0)] = UNKNOWN
    damping: Annotated[Estimate, Parameter("N*m*s/rad", "torsional damping", low=0)] = UNKNOWN
    damping_ratio: Annotated[Estimate, Parameter("1", "of the mode in which it is the spring", low=0, high=1)] = UNKNOWN
    loss_factor: Annotated[Estimate, Parameter("1", "loss factor of the elastomer", low=0, high=2)] = UNKNOWN
    inertia: Annotated[Estimate, Parameter("kg*m^2", "inertia", above=0)] = UNKNOWN
    jaws: Annotated[Estimate, Parameter("1", "jaws of a hub", low=2), Whole] = UNKNOWN
    spider_legs: Annotated[Estimate, Parameter("1", "legs of the spider", low=2), Whole] = UNKNOWN
    price: Annotated[Estimate, Parameter("EUR", "price", low=0)] = UNKNOWN

    @model_validator(mode="after")
    def _is_damped(self) -> Self:
        if self.damping.unknown and self.damping_ratio.unknown and self.loss_factor.unknown:
            raise ValueError("the damping is missing; state damping, damping_ratio or loss_factor")
        return self
