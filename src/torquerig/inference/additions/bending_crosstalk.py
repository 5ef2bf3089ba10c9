"""Bending cross-talk: the sensor reads bending of its shaft as torque, once and twice a turn."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor

NAMES = ("bending_crosstalk",)

_LOG_ODDS = -5.5  # sensors are sold with 0.05 to 1 % of cross-talk; it shows where much weight hangs on them
_FIELDS = {1: "once", 2: "twice"}


def propose(context: Context) -> Iterator[Addition]:
    """Yield the cross-talk of the measured sensor where it shows a line once or twice a turn of its shaft."""
    rig = context.rig
    sensor = rig.part(rig.measured)
    if not isinstance(sensor, AmplifiedTorqueSensor):
        return
    turns, name = Twin(rig).turns[rig.node(sensor.name)], free_name(rig, "bending_crosstalk")
    places = {round(order): place for order, place in context.at_orders(turns, (1.0, 2.0)).items()}

    def bent(sizes: dict[int, float]) -> mechanisms.BendingCrosstalk:
        return mechanisms.BendingCrosstalk(
            name=name, sensor=sensor.name, once=sizes.get(1, 0.0), twice=sizes.get(2, 0.0)
        )

    found = harmonics(
        context, places, unit=lambda order: bent({order: 1.0}), knob=lambda order: Knob(name, _FIELDS[order], DECADE)
    )
    if found.medians:
        yield Addition(
            mechanism="bending_crosstalk", parts=(bent(found.medians),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(places.values()), log_odds=_LOG_ODDS,
            label=f"bending that {sensor.name} reads as torque",
            reported=tuple(Reported(f"{_FIELDS[order]}_Nm", _FIELDS[order], "N*m") for order in found.medians),
        )  # fmt: skip
