"""The conditions on the test sheet of one run: set-points, not truths."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from typing import Any, Literal

Profile = Literal["steady", "ramp", "reversal"]
PROFILES: tuple[Profile, ...] = ("steady", "ramp", "reversal")


@dataclass(frozen=True, kw_only=True)
class Run:
    """What the operator set. ``None`` is not written on the sheet.

    Parameters
    ----------
    motor : str or None
        Catalog name of the motor.
    gear_ratio : float or None
        Motor turns per output turn [1], > 0.
    speed : float or None
        Set-point of the motor speed [rad/s].
    profile : {"steady", "ramp", "reversal"}
        ``steady`` holds the set-point; ``ramp`` runs from 10 % to 100 % of it and holds for the last tenth of the
        recording; ``reversal`` is two full sine periods with the set-point as amplitude.
    occupancy_percent : float or None
        Filling of the wear rig [%]; 0 is idle.
    particle_size : float or None
        Particle diameter [m].
    others : dict
        Further keys of the sheet, kept as they are.
    """

    motor: str | None = None
    gear_ratio: float | None = None
    speed: float | None = None
    profile: Profile = "steady"
    occupancy_percent: float | None = None
    particle_size: float | None = None
    others: dict[str, Any] = field(default_factory=dict)

    @property
    def speed_rpm(self) -> float | None:
        """The set-point of the motor speed [rpm], as the sheet writes it."""
        return None if self.speed is None else self.speed * 30 / pi
