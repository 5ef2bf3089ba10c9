"""Thermal variants of a motor within the catalog's intervals, and the assumptions for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product

from torquerig.catalog.motor import Motor
from torquerig.parameter import Estimate
from torquerig.thermal.thermal_motor import COLD, COPPER, ThermalMotor
from torquerig.thermal.two_node import TwoNode

RATED_AMBIENT = 40.0  # [C] at which ratings hold unless stated (IEC 60034-1, 6.2)
LIMIT = Estimate(low=130.0, high=155.0, evidence="RT", source="thermal classes B and F of IEC 60085")
# published: 0.18..0.27 for the ServoTube 38 linear motors; a flange that cools well raises it
WINDING_RESISTANCE = Estimate(low=0.2, high=0.5, evidence="RT", source="share of winding to housing, ServoTube 38: 0.2")
WINDING_CAPACITY = Estimate(low=0.05, high=0.20, evidence="RT", source="share of the copper in the motor's capacity")
# the premo motors of 0.60 to 6.38 N*m: 1.19 to 0.54 K/W and 12.0 to 33.2 min [W1]
RESISTANCE_AT_1NM, RESISTANCE_EXPONENT = 0.99, -0.33
CONSTANT_AT_1NM, CONSTANT_EXPONENT = 870.0, 0.43
TREND_FACTOR = 1.5  # [1] largest deviation of a motor from the trend, either way


@dataclass(frozen=True, kw_only=True)
class ThermalVariants:
    """The nominal variant, and one for each corner of the open values.

    Parameters
    ----------
    corners : tuple of ThermalMotor
        Every combination of the ends of the intervals; they bound every figure that is monotone in each value.
    assumed : mapping of str to str
        Values that no document states: the assumed value and its source.
    """

    nominal: ThermalMotor
    corners: tuple[ThermalMotor, ...]
    assumed: Mapping[str, str]


def thermal_variants(entry: Motor) -> ThermalVariants:
    """Return the thermal variants of a motor.

    Phase resistance and torque constant give the copper loss; where one of them is an interval, the rating determines
    the copper loss: at its continuous torque, at 40 C, the winding of each variant just reaches its limit, or stays
    below it where no resistance of the interval heats it so much. At standstill there is copper loss only; the
    difference of rated and stall torque is loss at the rated speed.
    """
    known = _quantities(entry)
    ends = {name: (one.nominal(), *one.bounds) for name, one in known.items()}
    nominal = _variant(entry, {name: values[0] for name, values in ends.items()})
    open_names = [name for name, (_, low, high) in ends.items() if low < high]
    corners = []
    for chosen in product((1, 2), repeat=len(open_names)):
        values = {name: value[0] for name, value in ends.items()}
        values |= {name: ends[name][side] for name, side in zip(open_names, chosen, strict=True)}
        corners.append(_variant(entry, values))
    assumed = {name: f"{_words(name, one)}: {one.source} ({one.evidence})" for name, one in known.items()
               if not one.documented}  # fmt: skip
    if not _documented_copper(entry):
        assumed["copper loss"] = _copper_text(entry, (nominal, *corners))
    return ThermalVariants(nominal=nominal, corners=tuple(corners), assumed=assumed)


def _words(name: str, one: Estimate) -> str:
    shown = one.shown().removeprefix("? ").strip("()")
    return f"{shown} C" if name == "winding limit" else shown


def _copper_text(entry: Motor, variants: Sequence[ThermalMotor]) -> str:
    losses = [one.copper_loss for one in variants]
    text = f"{min(losses):.3g}..{max(losses):.3g} W/(N*m)^2 at 20 C: the rating, at {RATED_AMBIENT:g} C, brings the "
    if copper_bounds(entry) is None:
        return text + "winding to its limit; resistance or torque constant are unknown"
    return text + "winding to its limit, within what phase resistance and torque constant allow"


def _quantities(entry: Motor) -> dict[str, Estimate]:
    stall = entry.rated_torque if entry.stall_torque.unknown else entry.stall_torque
    size = stall.nominal()
    found = {
        "continuous torque": stall,
        "winding limit": LIMIT,
        "thermal resistance": entry.thermal_resistance,
        "thermal time constant": entry.thermal_time_constant,
        "share of resistance to the housing": WINDING_RESISTANCE,
        "share of capacity in the winding": WINDING_CAPACITY,
    }
    if entry.thermal_resistance.unknown:
        found["thermal resistance"] = _trend(RESISTANCE_AT_1NM * size**RESISTANCE_EXPONENT, "K/W")
    if entry.thermal_time_constant.unknown:
        found["thermal time constant"] = _trend(CONSTANT_AT_1NM * size**CONSTANT_EXPONENT, "min")
    return found


def _trend(middle: float, unit: str) -> Estimate:
    return Estimate(
        low=middle / TREND_FACTOR, high=middle * TREND_FACTOR, evidence="RT", unit=unit,
        source="not in the catalog; trend of the premo motors [W1] at its continuous torque, factor 1.5 either way",
    )  # fmt: skip


def _documented_copper(entry: Motor) -> bool:
    return entry.torque_constant.documented and entry.phase_resistance.documented


def copper_bounds(entry: Motor) -> tuple[float, float] | None:
    """Return the least and most copper loss that ``3 R / Kt^2`` allows [W/(N m)^2]; None where one is not known."""
    constant, resistance = entry.torque_constant, entry.phase_resistance
    if constant.unknown or resistance.unknown:
        return None
    return 3 * resistance.bounds[0] / constant.bounds[1] ** 2, 3 * resistance.bounds[1] / constant.bounds[0] ** 2


def _variant(entry: Motor, values: Mapping[str, float]) -> ThermalMotor:
    network = network_of(
        resistance=values["thermal resistance"],
        time_constant=values["thermal time constant"],
        resistance_share=values["share of resistance to the housing"],
        capacity_share=values["share of capacity in the winding"],
    )
    copper, iron = _losses(entry, network, limit=values["winding limit"], continuous=values["continuous torque"])
    return ThermalMotor(
        network=network,
        copper_loss=copper,
        torque_constant=float("nan") if entry.torque_constant.unknown else entry.torque_constant.nominal(),
        coulomb=entry.coulomb_friction.nominal(),
        viscous=entry.viscous_friction.nominal(),
        iron=iron,
        rated_speed=entry.rated_speed.nominal(),
        limit=values["winding limit"],
    )


def _losses(entry: Motor, network: TwoNode, *, limit: float, continuous: float) -> tuple[float, float]:
    """Return copper loss [W/(N m)^2] at 20 C and iron loss at the rated speed [W] according to the rating."""
    speed, rated = entry.rated_speed.nominal(), entry.rated_torque.nominal()
    friction = entry.coulomb_friction.nominal() * speed + entry.viscous_friction.nominal() * speed**2
    hot = 1 + COPPER * (limit - COLD)
    # a rated torque is given at the rated speed, where friction heats the housing too; a stall torque is not
    rise = limit - RATED_AMBIENT - (friction * network.housing_to_ambient if entry.stall_torque.unknown else 0.0)
    copper = max(0.0, rise) / (network.resistance * hot * continuous**2)
    if bounds := copper_bounds(entry):
        copper = min(max(copper, bounds[0]), bounds[1])
    if entry.stall_torque.unknown:
        return copper, 0.0
    difference = copper * hot * max(0.0, continuous**2 - rated**2)
    return copper, max(0.0, difference * network.resistance / network.housing_to_ambient - friction)


def network_of(*, resistance: float, time_constant: float, resistance_share: float, capacity_share: float) -> TwoNode:
    """Return the network with a resistance to ambient [K/W] and a slow time constant [s].

    ``resistance_share`` of the resistance lies between winding and housing, ``capacity_share`` of the capacity in the
    winding. Both time constants are in proportion to the capacity, which is set so that the slow one is as stated.
    """
    across = resistance_share * resistance
    unit = TwoNode(
        winding_capacity=capacity_share, housing_capacity=1 - capacity_share,
        winding_to_housing=across, housing_to_ambient=resistance - across,
    )  # fmt: skip
    capacity = time_constant / unit.time_constants()[1]
    return TwoNode(
        winding_capacity=capacity * capacity_share,
        housing_capacity=capacity * (1 - capacity_share),
        winding_to_housing=unit.winding_to_housing,
        housing_to_ambient=unit.housing_to_ambient,
    )
