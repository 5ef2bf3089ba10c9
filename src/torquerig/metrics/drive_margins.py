"""Margins of a motor on a gearbox without a simulation: speed, torque, load of the sensor, price."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.catalog.entry import UNKNOWN
from torquerig.metrics.figure import Figure, scaled, total, yes_no

if TYPE_CHECKING:
    from torquerig.catalog.motor import Motor
    from torquerig.parameter import Estimate


@dataclass(frozen=True, kw_only=True)
class Duty:
    """Operating point and settings of a drive.

    Parameters
    ----------
    output_speed : float
        [rad/s]
    mean_torque : float
        Mean torque at the output [N m].
    ratio, efficiency : float
        Of the whole chain from the motor to the measured part, as simulated [1].
    torque_limit : float
        Of the drive as set [N m].
    """

    output_speed: float
    mean_torque: float
    ratio: float
    efficiency: float
    torque_limit: float
    unit: str = "N*m"


@dataclass(frozen=True, kw_only=True)
class ExchangedStage:
    """The stage that a study exchanges.

    Parameters
    ----------
    name : str
    price : Estimate
        [EUR]; unknown where nothing states it.
    efficiency : Estimate
        Of the catalog [1]; unknown where the scenario states the stage.
    """

    name: str
    price: Estimate = UNKNOWN
    efficiency: Estimate = UNKNOWN


def drive_margins(
    motor: Motor, stage: ExchangedStage | None, duty: Duty, *, new_motor: bool, new_stage: bool
) -> Mapping[str, Figure]:
    """Return the figures of a drive by the names that a study's criteria use.

    ``speed_reserve`` max. speed / needed speed; ``speed_use`` needed / rated speed; ``continuous_output_torque`` rated
    torque x ratio x efficiency [N m]; ``torque_reserve`` that over the mean torque; ``sensor_peak`` the drive's limit
    at the sensor [N m]; ``servo`` 1 or 0; ``new_parts`` how many of motor, drive, gearbox, adapter must be changed
    (present parts are not new); ``price`` of the new parts [EUR]. ``stage`` is None where only the motor is exchanged.
    """
    name = motor.stands_for or motor.name
    needed = duty.output_speed * duty.ratio
    gain = duty.ratio * duty.efficiency
    prices = [Figure(value=0.0, unit="EUR", source="present parts cost nothing")]
    if new_motor:
        prices += [scaled(motor.price, 1.0, unit="EUR", missing=f"price of {name}"),
                   scaled(motor.drive_price, 1.0, unit="EUR", missing=f"price of the drive of {name}")]  # fmt: skip
    if stage is not None and new_stage:
        prices.append(scaled(stage.price, 1.0, unit="EUR", missing=f"price of {stage.name}"))
    efficiency = () if stage is None or stage.efficiency.unknown else (
        (f"efficiency of {stage.name}", stage.efficiency),
    )  # fmt: skip
    return {
        "speed_reserve": scaled(motor.max_speed, 1 / needed, unit="1", missing=f"maximum speed of {name}"),
        "speed_use": scaled(motor.rated_speed, needed, unit="1", inverse=True, missing=f"rated speed of {name}"),
        "continuous_output_torque": scaled(motor.rated_torque, gain, unit=duty.unit, missing=f"rated torque of {name}"),
        "torque_reserve": scaled(
            motor.rated_torque, gain / duty.mean_torque, unit="1", missing=f"rated torque of {name}"
        )
        if duty.mean_torque > 0
        else Figure(missing="a mean load as reference of the reserve"),
        "sensor_peak": Figure(
            value=duty.torque_limit * gain,
            unit=duty.unit,
            source="drive's limit x ratio x efficiency",
            rests_on=((f"peak torque of {name}", motor.peak_torque), *efficiency),
        ),
        "servo": yes_no(motor.servo, f"whether {name} is a servo motor"),
        # a new motor brings its drive and an adapter plate with it
        "new_parts": Figure(value=float(3 * new_motor + new_stage), source="motor, drive and adapter; gearbox"),
        "price": total(prices, unit="EUR"),
    }
