"""All figures of a sized drive, each with its limit and a result: holds, exceeds, unsure, unknown."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.best_ratio import best_ratio
from torquerig.metrics.sizing.drive_current import drive_current
from torquerig.metrics.sizing.gearbox_use import gearbox_use
from torquerig.metrics.sizing.inertia_ratio import inertia_ratio
from torquerig.metrics.sizing.load_fidelity import load_fidelity, loop_fidelity
from torquerig.metrics.sizing.regeneration import regeneration
from torquerig.metrics.sizing.required_torque import torque_requirements, use_of_ratings
from torquerig.metrics.sizing.sensor_use import sensor_use
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.metrics.sizing.speed_torque import region_use
from torquerig.metrics.sizing.thermal_use import thermal_use

HOLDS, EXCEEDS, UNSURE, UNKNOWN = "holds", "exceeds", "unsure", "unknown"
GROUPS: tuple[tuple[Callable[[SizedDrive], Mapping[str, Figure]], Mapping[str, str]], ...] = (
    (torque_requirements, {"rms_torque": "N*m", "peak_torque": "N*m", "peak_power": "W", "top_speed": "rad/s",
                    "mean_speed": "rad/s"}),
    (use_of_ratings, {"rms_torque_use": "1", "peak_torque_use": "1"}),
    (region_use, {"continuous_use": "1", "intermittent_use": "1", "speed_limit_use": "1"}),
    (inertia_ratio, {"inertia_ratio": "1"}),
    (thermal_use, {"thermal_use": "1", "thermal_margin": "K"}),
    (gearbox_use, {"gearbox_life_use": "1", "gearbox_peak_use": "1", "gearbox_jam_use": "1", "gearbox_speed_use": "1",
                   "gearbox_no_load_use": "1"}),
    (drive_current, {"rms_current": "A", "peak_current": "A", "limit_current": "A", "rms_current_use": "1",
                     "peak_current_use": "1"}),
    (regeneration, {"braking_energy": "J", "regenerated_energy": "J"}),
    (best_ratio, {"ideal_ratio": "1", "speed_ratio": "1", "best_ratio": "1", "best_ratio_use": "1"}),
    (sensor_use, {"sensor_cycle_use": "1", "sensor_range_use": "1", "sensor_overload": "1",
                  "sensor_overload_unlimited": "1"}),
    (load_fidelity, {"load_fidelity": "1"}),
    (loop_fidelity, {"loop_fidelity": "1", "flat_to": "Hz"}),
)  # fmt: skip
"""Functions with their figures and units, in groups that are calculated together."""
SIZING_UNITS: Mapping[str, str] = {name: unit for _, units in GROUPS for name, unit in units.items()}
"""Every figure of a sizing with its unit; a study's criteria may name them."""
LIMITED = (
    "rms_torque_use", "peak_torque_use", "continuous_use", "intermittent_use", "speed_limit_use", "thermal_use",
    "gearbox_life_use", "gearbox_peak_use", "gearbox_jam_use", "gearbox_speed_use", "rms_current_use",
    "peak_current_use", "sensor_cycle_use", "sensor_range_use", "sensor_overload",
)  # fmt: skip
"""The shares that must not exceed 1."""
ROUNDING = 1e-9  # [1] rounding error by which a share at its limit may exceed it


@dataclass(frozen=True, kw_only=True)
class Sizing:
    """The sizing of one drive.

    Parameters
    ----------
    figures : mapping of str to Figure
        By the names of ``SIZING_UNITS``, in groups.
    late : tuple of str
        Steps of the set-point that the drive cannot follow in time.
    """

    drive: SizedDrive
    figures: Mapping[str, Figure]
    late: tuple[str, ...] = field(default=())

    def word(self, name: str) -> str:
        """Return whether a share stays below 1; empty for a figure without a limit."""
        return limit_word(self.figures[name]) if name in LIMITED and name in self.figures else ""

    @property
    def verdict(self) -> str:
        """The worst result: ``exceeds`` before ``unsure`` before ``unknown`` before ``holds``."""
        given = {self.word(name) for name in self.figures}
        return next((word for word in (EXCEEDS, UNSURE, UNKNOWN) if word in given), HOLDS)

    def with_word(self, word: str) -> tuple[str, ...]:
        """Return the names of the shares with this result."""
        return tuple(name for name in self.figures if self.word(name) == word)


def sizing(drive: SizedDrive, *, ambient: float = 40.0, names: Collection[str] = tuple(SIZING_UNITS)) -> Sizing:
    """Return the figures of a drive at ``ambient`` [C]: those of ``names`` and of their groups."""
    figures: dict[str, Figure] = {}
    for found, units in GROUPS:
        if not set(units) & set(names):
            continue
        figures |= thermal_use(drive, ambient=ambient) if found is thermal_use else found(drive)
    return Sizing(drive=drive, figures=figures, late=drive.requirement().late)


def limit_word(figure: Figure) -> str:
    """Return ``holds`` if a share is certainly at most 1, ``exceeds`` if certainly more, else unsure or unknown."""
    if figure.unknown:
        return UNKNOWN
    low = figure.value if figure.low is None else figure.low
    high = figure.value if figure.high is None else figure.high
    if high is not None and high <= 1 + ROUNDING:
        return HOLDS
    return EXCEEDS if low is not None and low > 1 + ROUNDING else UNSURE
