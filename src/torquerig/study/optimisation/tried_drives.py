"""The drives of an optimisation: a motor on a gearbox of the catalog, or on one that is scaled to any ratio."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import ScenarioReader
from torquerig.study.candidate import Candidate
from torquerig.study.candidates import candidate_of, scenario_of, tuned_scenario
from torquerig.study.definition import Study
from torquerig.study.optimisation.scaled_gearbox import RatioBounds, scaled_document
from torquerig.study.planned_drive import planned_drive
from torquerig.study.preflight import beyond_the_drive


@dataclass(frozen=True)
class TriedDrive:
    """One motor on one gearbox: its scenario at the seed of the study, its price [EUR], and why it cannot run."""

    candidate: Candidate
    scenario: Scenario
    price: float | None
    fault: str


@dataclass(frozen=True)
class CatalogDrive:
    """A motor on a gearbox of the catalog."""

    made: TriedDrive
    bounds: None = None

    @classmethod
    def of(cls, study: Study, candidate: Candidate) -> CatalogDrive:
        """Return the drive of a candidate."""
        scenario = scenario_of(candidate, study, seed=study.settings.seed)
        return cls(_tried(study, candidate, scenario, price_of(study, candidate, scenario)))

    @property
    def name(self) -> str:
        """The name in tables."""
        return self.made.candidate.name

    def at(self, ratio: float | None) -> TriedDrive:
        """Return the drive; it has one ratio."""
        return self.made


@dataclass(frozen=True)
class ScaledDrive:
    """A motor on a gearbox of any ratio within limits."""

    study: Study
    motor: str
    bounds: RatioBounds
    _prices: dict[str, float | None] = field(default_factory=dict, compare=False, repr=False)

    @property
    def name(self) -> str:
        """The name in tables: the motor with the limits of the ratio."""
        return f"{self.motor} {self.bounds.low:g}..{self.bounds.high:g}:1"

    def at(self, ratio: float | None) -> TriedDrive:
        """Return the drive with a ratio [1]."""
        assert ratio is not None
        study, nearest = self.study, self.bounds.nearest(ratio)
        known = candidate_of(study, motor=self.motor, gearbox=nearest)
        candidate = replace(known, ratio=ratio, whole_ratio=(known.whole_ratio or known.ratio) * ratio / known.ratio)
        document = scaled_document(study, motor=self.motor, gearbox=nearest, ratio=ratio)
        scenario = tuned_scenario(ScenarioReader(document, study.catalog), study, seed=study.settings.seed)
        if nearest not in self._prices:
            self._prices[nearest] = price_of(study, candidate, scenario)
        named = replace(candidate, told_apart=f"like {nearest}")
        return _tried(study, named, scenario, self._prices[nearest])


def price_of(study: Study, candidate: Candidate, scenario: Scenario) -> float | None:
    """Return the price of all new parts of a drive [EUR]; None where it is unknown."""
    alone = replace(study, settings=study.settings.model_copy(update={"draws": 0}))
    return planned_drive(candidate, scenario, alone).result.margins["price"].value


def _tried(study: Study, candidate: Candidate, scenario: Scenario, price: float | None) -> TriedDrive:
    return TriedDrive(candidate, scenario, price, beyond_the_drive(candidate, scenario, study))
