"""Figures of each motor on each gearbox from catalog and simulation, by metric."""

from __future__ import annotations

from dataclasses import dataclass, replace

from torquerig.metrics.figure import Figure
from torquerig.metrics.motor_facts import FACT_UNITS, motor_facts
from torquerig.study.missing_data import missing_data_text
from torquerig.study.reference_decision.plan import KNOWN_UNITS, real_name
from torquerig.study.results import DriveResult, StudyRuns
from torquerig.study.scoring import figure_of
from torquerig.study.settings import SIMULATED


@dataclass(frozen=True)
class Known:
    """Look-up in the runs of a study by motor (or alias), gearbox and metric."""

    runs: StudyRuns

    def figure(self, motor: str, gearbox: str, metric: str) -> Figure:
        """Return one figure; unknown where the drive was not simulated."""
        catalog, study = self.runs.study.catalog, self.runs.study
        if metric in FACT_UNITS:
            present = catalog.motor(study.settings.present.motor)
            return motor_facts(catalog.motor(motor), catalog.gearbox(gearbox), present=present)[metric]
        drive = self.drive(motor, gearbox)
        if drive is None:
            return Figure(unit=KNOWN_UNITS[metric], missing=f"a simulation of {motor} on {gearbox}")
        found = figure_of(drive, study.settings.present.filter, metric)
        rests_on = found.rests_on
        if metric in SIMULATED:
            rests_on = tuple((one.name, one.known) for one in drive.taken.values())
        return replace(found, missing=missing_data_text(found.missing, drive.candidate), rests_on=rests_on)

    def drive(self, motor: str, gearbox: str) -> DriveResult | None:
        """Return the drive of a motor on a gearbox; None where the study has none."""
        name = real_name(self.runs.study.catalog, motor)
        found = (one for one in self.runs.drives if one.candidate.motor == name and one.candidate.gearbox == gearbox)
        return next(found, None)
