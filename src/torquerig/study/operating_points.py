"""The further operating points of a study."""

from __future__ import annotations

import copy
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from torquerig.scenario.sections import read_operating_point

if TYPE_CHECKING:
    from torquerig.study.definition import Study


@dataclass(frozen=True, kw_only=True)
class Point:
    """One occupancy [%] and particle size [m]."""

    occupancy_percent: float
    particle_size: float

    @property
    def name(self) -> str:
        """Name of the folder: ``occupancy-21-particle-0.5mm``."""
        return f"occupancy-{self.occupancy_percent:g}-particle-{1e3 * self.particle_size:g}mm"

    def applied(self, study: Study) -> Study:
        """Return the study at this point."""
        data = copy.deepcopy(study.document.data)
        load = data.setdefault("operating_point", {}).setdefault("load", {})
        load["occupancy"] = self.occupancy_percent
        load["particle_size"] = f"{self.particle_size!r} m"
        return replace(study, document=replace(study.document, data=data))


def points_of(study: Study) -> tuple[Point, ...]:
    """Return the study's occupancies at its default particle size, then its sizes at its default occupancy."""
    listed = study.settings.all_points
    if listed is None:
        return ()
    default = read_operating_point(study.document, seed=study.settings.seed)[0].load
    points = [Point(occupancy_percent=each, particle_size=default.particle_size) for each in listed.occupancy]
    points += [Point(occupancy_percent=default.occupancy, particle_size=each) for each in listed.particle_size]
    return tuple(dict.fromkeys(points))
