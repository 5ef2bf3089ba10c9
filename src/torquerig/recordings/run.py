"""The test conditions of one run: set-points, not measured values."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from typing import Any, Literal

from torquerig.errors import InputError
from torquerig.recordings.profiles.profile import SpeedProfile
from torquerig.recordings.profiles.ramp import Ramp
from torquerig.recordings.profiles.reversal import Reversal
from torquerig.recordings.profiles.steady import Steady

Profile = Literal["steady", "ramp", "reversal", "duty_cycle", "csv"]
PROFILES: tuple[Profile, ...] = ("steady", "ramp", "reversal", "duty_cycle", "csv")
WANDER_CUTOFF = 0.3  # [Hz] of the reference rig; slower than its speed loop by two decades
_BY_NAME: dict[str, SpeedProfile] = {one.name: one for one in (Steady(), Ramp(), Reversal())}


@dataclass(frozen=True, kw_only=True)
class Run:
    """The set-points of one run, as a sidecar states them; ``None`` is not stated.

    Parameters
    ----------
    motor : str or None
        Catalog name of the motor.
    gear_ratio : float or None
        Motor turns per output turn [1], > 0.
    travel_per_turn : float or None
        Travel of what moves in a line per turn of the last shaft before it [m], > 0: the lead of a screw.
    speed : float or None
        Set-point of the motor speed [rad/s].
    profile : {"steady", "ramp", "reversal", "duty_cycle", "csv"}
        ``steady`` holds the set-point; ``ramp`` runs from 10 % to 100 % of it and holds for the last tenth of the
        recording; ``reversal`` is two full sine periods with the set-point as amplitude. The other two are given
        by times and speeds in ``set_points``; ``speed`` is then the largest of them.
    set_points : SpeedProfile or None
        The profile, where its name does not determine it.
    occupancy_percent : float or None
        Filling of the wear rig [%]; 0 is idle.
    particle_size : float or None
        Particle diameter [m].
    wander_cutoff : float
        Bandwidth of the slow wander of a simulated steady speed [Hz]: a second-order low-pass.
    others : dict
        Further conditions, unchanged: ``pole_pairs``, ``slots``, ``tacho_pulses_per_motor_turn`` and ``notes`` of the
        sidecar's ``run``, and what it has under ``others``.
    inputs : Inputs or None
        Measured channels of the run that drive a model of the rig (``recordings.inputs``); never in a sidecar.
    """

    motor: str | None = None
    gear_ratio: float | None = None
    travel_per_turn: float | None = None
    speed: float | None = None
    profile: Profile = "steady"
    set_points: SpeedProfile | None = None
    occupancy_percent: float | None = None
    particle_size: float | None = None
    wander_cutoff: float = WANDER_CUTOFF
    others: dict[str, Any] = field(default_factory=dict)
    inputs: object | None = field(default=None, repr=False)

    @property
    def speed_rpm(self) -> float | None:
        """The set-point of the motor speed [rpm], as a sidecar states it."""
        return None if self.speed is None else self.speed * 30 / pi

    def speed_profile(self) -> SpeedProfile:
        """Return the set-point over time; InputError where a profile is named and its points are not stated."""
        profile = self.set_points or _BY_NAME.get(self.profile)
        if profile is None:
            raise InputError(
                f"the run's profile is {self.profile}, and nothing states its set-points; add to run: "
                "set_point: {time_s: [0, 1], speed_rpm: [0, 1000]}, or name another profile"
            )
        return profile
