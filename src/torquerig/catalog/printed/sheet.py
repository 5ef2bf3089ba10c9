"""Schema of the block ``as_printed`` of a motor file: the figures of a data sheet in the maker's words."""

from __future__ import annotations

from typing import Literal

from torquerig.catalog.entry import Evidenced
from torquerig.catalog.printed.figure import Figure


class MotorSheet(Evidenced):
    """Figures as the maker prints them; evidence and source hold for all that state no other.

    Parameters
    ----------
    winding : str
        ``star`` or ``delta``, where the sheet says so; it matters for values per phase.
    voltage_constant, speed_constant, torque_constant : Figure
        Ke (``27.8 V/krpm line-to-line rms``), kV (``340 rpm/V dc``) and Kt (``0.46 N*m/A rms``).
    resistance, inductance : Figure
        ``5.7 ohm line-to-line`` or ``1.55 ohm per phase star``.
    electrical_time_constant : Figure
        L / R, which gives the inductance where none is printed.
    rated_current, no_load_current : Figure
        ``2.5 A rms``; the no-load current at ``no_load_speed`` gives the friction.
    rated_power, rated_torque, intermittent_torque : Figure
        ``400 W``, ``1.27 N*m``, ``1.8 N*m S3 40 %``.
    flywheel_effect : Figure
        GD^2, four times the inertia: ``0.002 kgf*m^2``.
    cogging, torque_ripple : Figure
        ``2 % of rated torque peak-to-peak`` or ``12 mN*m amplitude``.
    """

    winding: Literal["star", "delta"] | None = None
    voltage_constant: Figure | None = None
    speed_constant: Figure | None = None
    torque_constant: Figure | None = None
    resistance: Figure | None = None
    inductance: Figure | None = None
    electrical_time_constant: Figure | None = None
    rated_current: Figure | None = None
    no_load_current: Figure | None = None
    no_load_speed: Figure | None = None
    rated_power: Figure | None = None
    rated_torque: Figure | None = None
    intermittent_torque: Figure | None = None
    flywheel_effect: Figure | None = None
    cogging: Figure | None = None
    torque_ripple: Figure | None = None

    def figures(self) -> dict[str, Figure]:
        """Return the figures that are stated, by key."""
        held = {key: getattr(self, key) for key in type(self).model_fields}
        return {key: value for key, value in held.items() if isinstance(value, Figure)}
