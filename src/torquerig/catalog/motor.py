"""Schema of a motor file: each value with unit, interval, evidence and source."""

from __future__ import annotations

from math import pi
from typing import Annotated, Literal, Self

from pydantic import ValidationInfo, field_validator, model_validator

from torquerig.catalog.entry import UNKNOWN, Entry, Fact, Record, Text, Whole, counts_of
from torquerig.catalog.printed.sheet import MotorSheet
from torquerig.catalog.ripple import Ripple
from torquerig.machines.winding import no_winding, winding_pairs
from torquerig.parameter import Estimate, Parameter

KT_TOLERANCE = 0.10  # [1] rated torque and current are rounded, and hold at another temperature than the constant
KT_OVER_RATING = 2**0.25 - 1  # [1] friction and iron losses: makers' tables have up to 12 %; half-way (log) to sqrt(2)


class Alias(Record):
    """Another name of the motor in some table, with the reason for taking it as the same."""

    name: Text
    table: Text
    reason: Text


class Motor(Entry):
    """One motor with its drive.

    Values that a simulation needs must be stated, at least as an interval; other values may be unknown (``?``).

    Raises
    ------
    ValueError
        When a rating contradicts another one, the pole pairs and slots have no winding, or the torque constant does
        not agree with rated torque over rated current: 10 % below to 19 % above.
    """

    kind: Literal["bldc", "pmsm", "induction"]
    aliases: tuple[Alias, ...] = ()
    stands_for: str = ""
    warnings: tuple[Text, ...] = ()
    servo: Fact | None = None
    a_series_adapter: Fact | None = None
    as_printed: MotorSheet | None = None

    rated_torque: Annotated[Estimate, Parameter("N*m", "rated torque", above=0)]
    stall_torque: Annotated[Estimate, Parameter("N*m", "continuous stall torque", above=0)] = UNKNOWN
    peak_torque: Annotated[Estimate, Parameter("N*m", "largest torque of motor and drive", above=0)]
    rated_speed: Annotated[Estimate, Parameter("rpm", "rated speed", above=0)]
    max_speed: Annotated[Estimate, Parameter("rpm", "largest speed", above=0)]
    min_speed: Annotated[Estimate, Parameter("rpm", "smallest speed of continuous duty", low=0)] = UNKNOWN

    rated_power: Annotated[Estimate, Parameter("W", "rated power at the shaft", above=0)] = UNKNOWN

    supply_voltage: Annotated[Estimate, Parameter("V", "rms voltage of the drive's supply", above=0)] = UNKNOWN
    rated_current: Annotated[Estimate, Parameter("Arms", "rated current", above=0)] = UNKNOWN
    torque_constant: Annotated[Estimate, Parameter("N*m/Arms", "torque per phase current", above=0)] = UNKNOWN
    phase_resistance: Annotated[Estimate, Parameter("ohm", "resistance of one phase at 20 C", above=0)] = UNKNOWN
    phase_inductance: Annotated[Estimate, Parameter("H", "inductance of one phase", above=0)] = UNKNOWN
    emf_flat_angle: Annotated[
        Estimate, Parameter("deg", "flat top of the back-EMF of a bldc, electrical", above=0, high=0.999 * pi)
    ] = UNKNOWN
    emf_fifth: Annotated[
        Estimate, Parameter("1", "fifth harmonic of the back-EMF of a pmsm, share of the first", low=-0.5, high=0.5)
    ] = UNKNOWN
    dead_time: Annotated[Estimate, Parameter("us", "dead time of the inverter, uncompensated", low=0)] = UNKNOWN
    current_loop_bandwidth: Annotated[Estimate, Parameter("Hz", "lag from commanded to real torque", above=0)]

    pole_pairs: Annotated[Estimate, Parameter("1", "pole pairs", low=1), Whole]
    slots: Annotated[Estimate, Parameter("1", "stator slots", low=3), Whole] = UNKNOWN
    rotor_bars: Annotated[Estimate, Parameter("1", "bars of the cage", low=3), Whole] = UNKNOWN

    rotor_inertia: Annotated[Estimate, Parameter("kg*m^2", "rotor inertia", above=0)]
    coulomb_friction: Annotated[Estimate, Parameter("N*m", "dry friction", low=0)]
    viscous_friction: Annotated[Estimate, Parameter("N*m*s/rad", "friction in proportion to speed", low=0)]
    no_load_torque: Annotated[Estimate, Parameter("N*m", "both frictions at the no-load speed", low=0)] = UNKNOWN
    no_load_speed: Annotated[Estimate, Parameter("rpm", "speed of the no-load torque", above=0)] = UNKNOWN
    mass: Annotated[Estimate, Parameter("kg", "mass", above=0)] = UNKNOWN
    shaft_diameter: Annotated[Estimate, Parameter("mm", "shaft diameter", above=0)] = UNKNOWN
    encoder_bits: Annotated[Estimate, Parameter("bit", "encoder resolution", low=1)] = UNKNOWN

    thermal_resistance: Annotated[Estimate, Parameter("K/W", "winding to ambient", above=0)] = UNKNOWN
    thermal_time_constant: Annotated[Estimate, Parameter("min", "time constant of the winding", above=0)] = UNKNOWN

    ripple: Ripple

    price: Annotated[Estimate, Parameter("EUR", "price of the motor without drive", low=0)] = UNKNOWN
    drive_price: Annotated[Estimate, Parameter("EUR", "price of the drive", low=0)] = UNKNOWN

    @field_validator("stands_for", mode="before")
    @classmethod
    def _only_by_lookup(cls, written: object) -> str:
        raise ValueError("this is set when an alias is looked up; write the other name under aliases")

    @field_validator("peak_torque")
    @classmethod
    def _peak_reaches_rated(cls, peak: Estimate, info: ValidationInfo) -> Estimate:
        return _not_below(peak, info, "rated_torque")

    @field_validator("max_speed")
    @classmethod
    def _max_reaches_rated(cls, top: Estimate, info: ValidationInfo) -> Estimate:
        return _not_below(top, info, "rated_speed")

    @field_validator("torque_constant")
    @classmethod
    def _agrees_with_rating(cls, constant: Estimate, info: ValidationInfo) -> Estimate:
        torque, current = (info.data.get(field, UNKNOWN) for field in ("rated_torque", "rated_current"))
        if torque.unknown or current.unknown or constant.unknown:
            return constant
        low, high = torque.bounds[0] / current.bounds[1], torque.bounds[1] / current.bounds[0]
        if constant.bounds[1] * (1 + KT_TOLERANCE) < low or constant.bounds[0] > high * (1 + KT_OVER_RATING):
            raise ValueError(
                f"{constant.shown()} does not agree within 10 % below and 19 % above with rated torque / rated "
                f"current, which gives {low:.3g}..{high:.3g} N*m/Arms; check whether one of them is per peak ampere"
            )
        return constant

    @field_validator("slots")
    @classmethod
    def _has_winding(cls, slots: Estimate, info: ValidationInfo) -> Estimate:
        poles = counts_of(info.data.get("pole_pairs", UNKNOWN))
        if poles and not slots.unknown and not winding_pairs(poles, counts_of(slots)):
            raise ValueError(no_winding(poles[0], counts_of(slots)[0]))
        return slots

    @model_validator(mode="after")
    def _has_what_its_kind_needs(self) -> Self:
        needed = "rotor_bars" if self.kind == "induction" else "slots"
        for field in ("pole_pairs", needed):
            if getattr(self, field).unknown:
                raise ValueError(f"a {self.kind} motor needs {field} for its ripple orders; write one_of where unknown")
        return self


def _not_below(upper: Estimate, info: ValidationInfo, field: str) -> Estimate:
    lower: Estimate = info.data.get(field, UNKNOWN)
    if not lower.unknown and not upper.unknown and upper.bounds[1] < lower.bounds[0]:
        raise ValueError(f"{upper.shown()} is below {field} {lower.shown()}; correct one of them")
    return upper
