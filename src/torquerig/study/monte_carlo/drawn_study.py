"""A study of many draws: its drives, and one case for each drive and draw."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from torquerig.cases import Case, Column, Identity, digest_of
from torquerig.catalog.chosen_draws import ChosenDraws
from torquerig.errors import InputError
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import ScenarioReader
from torquerig.simulation.inputs import Draws
from torquerig.study.candidate import Candidate
from torquerig.study.candidates import candidates, reader_of, scenario_of, tuned_scenario
from torquerig.study.definition import Study
from torquerig.study.monte_carlo.replayed_files import replayed_files
from torquerig.study.preflight import check_study, out_of_reach
from torquerig.study.settings import metrics_of

RATED_AFTERWARDS = ("requirements", "criteria", "draws", "all_points")  # of a study
LONGEST = 60  # characters of a value that an identity holds as text
MOST = 100_000_000  # draws; the number of a case holds the drive too


@dataclass(frozen=True)
class DrawnStudy:
    """What all cases share.

    Parameters
    ----------
    study : Study
    drives : mapping of str to Candidate
        By name; those that reach the speed, torque and voltage of the run.
    left_out : mapping of str to str
        The other drives, with the reason.
    unknown : mapping of str to tuple of str
        Names of what is drawn, by drive: ``HDS6A-0104A.rotor_inertia``.
    replayed : mapping of str to str
        Digest of the content of each recording that the rig replays, by path.
    """

    study: Study
    drives: Mapping[str, Candidate]
    left_out: Mapping[str, str]
    unknown: Mapping[str, tuple[str, ...]]
    replayed: Mapping[str, str] = field(default_factory=dict)
    loads: Draws = field(default_factory=Draws, repr=False, compare=False)
    readers: dict[str, ScenarioReader] = field(default_factory=dict, repr=False, compare=False)

    def scenario(self, drive: str, *, seed: int) -> Scenario:
        """Return the scenario of a drive at one draw; what no draw changes is read once in each process."""
        if drive not in self.readers:
            self.readers[drive] = reader_of(self.drives[drive], self.study)
        return tuned_scenario(self.readers[drive], self.study, seed=seed)

    @property
    def metrics(self) -> frozenset[str]:
        """The simulated metrics that a criterion uses, and the reading error."""
        return frozenset({*metrics_of(self.study.settings), "truth_error"})

    @property
    def filters(self) -> tuple[str, ...]:
        """The names of the filters, the present one included."""
        settings = self.study.settings
        return tuple(dict.fromkeys((*settings.filters.names, settings.present.filter)))

    @property
    def names(self) -> tuple[str, ...]:
        """Everything that is drawn, once each."""
        return tuple(dict.fromkeys(name for listed in self.unknown.values() for name in listed))

    def results(self) -> list[Column]:
        """Return the columns of the answers."""
        unit = self.study.effort_unit
        columns = [Column("out_of_reach", kind="str", meaning="why the drive of this draw cannot run; empty if it can")]
        for name in self.filters:
            said = f"rms of the reading behind the filter {name} minus the true load"
            columns.append(Column(error_column(name), unit, meaning=said))
        if "disturbance" in self.metrics:
            columns.append(Column("disturbance", unit, meaning="rms of the lines in the unfiltered reading"))
        if "residual_disturbance" in self.metrics:
            columns += [
                Column(residual_column(name), unit, meaning=f"rms of the lines behind the filter {name}")
                for name in self.filters
            ]
        return columns

    def identity(self, plan: str) -> Identity:
        """Return what determines the answers; ``plan`` names the table of cases: draws, or a design of them."""
        study = self.study
        motors = {one.motor: repr(study.catalog.motor(one.motor)) for one in self.drives.values()}
        shelves = (study.catalog.gearboxes, study.catalog.sensors, study.catalog.couplings)
        others = {name: repr(one) for shelf in shelves for name, one in shelf.items()}
        return Identity(
            study={
                **_stated(_computed(study.document.data)),
                "drives": ", ".join(self.drives),
                **{f"recording {path}": digest for path, digest in self.replayed.items()},
                "filter file": digest_of(json.dumps(study.filters.data, default=repr, sort_keys=True)),
                **{f"entry {name} of the catalog": digest_of(text) for name, text in (motors | others).items()},
                "plan": plan if len(plan) <= LONGEST else f"{plan[:LONGEST]}... ({digest_of(plan)})",
            },
            values=[Column("drive", kind="str"), Column("draw", kind="int"), *quantile_columns(plan)],
            results=self.results(),
        )


def _stated(data: Mapping[str, Any], before: str = "") -> dict[str, str]:
    """Return what a scenario states, by dotted key: short values as text, long ones as digests."""
    found: dict[str, str] = {}
    for key, value in data.items():
        name, text = f"{before}{key}", json.dumps(value, default=repr, sort_keys=True)
        if isinstance(value, dict) and len(text) > LONGEST:
            found |= _stated(value, f"{name}.")
        else:
            found[name] = text.strip('"') if len(text) <= LONGEST else digest_of(text)
    return found


def _computed(data: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return a scenario without what is only made of the figures afterwards: a weight may change and no case does."""
    kept = {key: value for key, value in data["study"].items() if key not in RATED_AFTERWARDS}
    return {**data, "study": kept}


def error_column(name: str) -> str:
    """Return the column of the reading error behind a filter."""
    return f"reading_error_{name}"


def residual_column(name: str) -> str:
    """Return the column of the lines that a filter leaves."""
    return f"residual_disturbance_{name}"


def quantile_columns(plan: str) -> list[Column]:
    """Return the column of the stated quantiles; none for random draws."""
    return [] if plan == "draws" else [Column("quantiles", kind="str", meaning="stated quantiles, as JSON")]


def drawn_study(study: Study) -> DrawnStudy:
    """Return the drives of a study and what is drawn of each; InputError as ``compare`` gives before its first run."""
    listed = candidates(study)
    seed = study.settings.seed
    scenarios, unknown = {}, {}
    for one in listed:
        watched = ChosenDraws(seed)
        scenarios[one] = scenario_of(one, study, seed=watched)
        unknown[one.name] = tuple(watched.drawn)
    check_study(study, scenarios)
    reasons = {one.name: out_of_reach(one, made, study) for one, made in scenarios.items()}
    drives = {one.name: one for one in listed if not reasons[one.name]}
    return DrawnStudy(
        study=study,
        drives=drives,
        left_out={name: why for name, why in reasons.items() if why},
        unknown={name: unknown[name] for name in drives},
        replayed=replayed_files(made.rig for made in scenarios.values()),
    )


def cases_of_draws(drawn: DrawnStudy, draws: int) -> list[Case]:
    """Return one case for each drive and draw, those of a drive together, so that the batch finds them alike.

    Draw 0 has the values of ``compare``'s first sample, and draw n those of its sample n. The number of a case does not
    depend on how many draws there are, so that a study can be continued.
    """
    if not 1 <= draws <= MOST:
        raise InputError(f"--draws {draws}: give a number from 1 to {MOST}")
    seed, names = drawn.study.settings.seed, list(drawn.drives)
    return [
        Case(number=draw * len(names) + row, values={"drive": name, "draw": draw}, seed=seed + draw)
        for row, name in enumerate(names)
        for draw in range(draws)
    ]
