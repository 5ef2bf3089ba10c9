"""The wear rig at one occupancy and particle size, with a scaled fluctuation of the load."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

from torquerig.catalog.reading import Catalog
from torquerig.document import Document
from torquerig.errors import InputError
from torquerig.mechanisms import ParticleLoad
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

DURATION, SETTLING = 10.0, 0.8  # [s]


@dataclass(frozen=True)
class ReportRig:
    """The scenario that is compared with the report.

    Parameters
    ----------
    document : Document
        With one particle_load and a steady operating point.
    seed : int
        Determines values drawn from the catalog; plus the number of a run, every random number.
    """

    document: Document
    catalog: Catalog
    seed: int

    @cached_property
    def scenario(self) -> Scenario:
        """The scenario, unchanged."""
        return read_scenario(self.document, self.catalog, seed=self.seed)

    @cached_property
    def load(self) -> ParticleLoad:
        """The rig's particle load; InputError where it has none, or several."""
        found = self.scenario.rig.parts_of(ParticleLoad)
        if len(found) != 1:
            raise InputError(
                f"{self.document.path}: the report's tables need a rig with one particle_load, not {len(found)}"
            )
        return found[0]

    @property
    def kinematics(self) -> Kinematics:
        """Poles, slots and ratio, which determine the report's notches."""
        return kinematics_of(self.scenario.rig)

    def at(self, occupancy: float, size: float, *, scale: float = 1.0) -> Rig:
        """Return the rig at an occupancy [%] and a size [m], its load's fluctuation times ``scale`` [1]."""
        settings = (f"load.occupancy={occupancy:g} %", f"load.particle_size={1e3 * size:g} mm")
        rig = read_scenario(overridden(self.document, settings), self.catalog, seed=self.seed).rig
        return replace(rig, parts=tuple(_scaled(part, scale) for part in rig.parts))

    def reading(self, occupancy: float, size: float, *, scale: float = 1.0, run: int = 0) -> Recording:
        """Return the reading of the sensor there; ``run`` numbers repetitions with other random numbers."""
        wander = self.scenario.operating_point.slow_speed_wander
        return simulate(
            self.at(occupancy, size, scale=scale), duration=DURATION, seed=self.seed + run, wander=wander,
            settling=SETTLING, scenario=self.scenario.title,
        )  # fmt: skip

    @property
    def size(self) -> float:
        """The scenario's particle size [m], used for Table VIII."""
        return self.scenario.rig.run.particle_size or 0.5e-3


def _scaled(part: Part, scale: float) -> Part:
    if not isinstance(part, ParticleLoad):
        return part
    return replace(part, hit_rms=part.hit_rms * scale, slow_rms=part.slow_rms * scale)
