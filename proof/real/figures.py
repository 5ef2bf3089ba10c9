"""Held-out residuals of a real rig: of the baseline scenario, and of each tested hypothesis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.catalog.reading import Catalog
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome, diagnose_motion
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.tried import Tried
from torquerig.document import read_document
from torquerig.recordings.sampled_motion import low_passed
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

RIGS = ("emps", "laas", "brfd")


@dataclass(frozen=True, kw_only=True)
class ErrorMeasure:
    """Unit of the residual of one rig, relative [%] or of the channel, and its upper frequency [Hz].

    EMPS is evaluated below 30 Hz, because the held-out pulses excite a flexibility that a rigid model lacks.
    """

    unit: str
    below: float | None = None


ERROR_MEASURES = {
    "emps": ErrorMeasure(unit="% of the force", below=30.0),
    "laas": ErrorMeasure(unit="A"),
    "brfd": ErrorMeasure(unit="kip"),
}


@dataclass(frozen=True, kw_only=True)
class Figure:
    """One line of the table: mechanism of the model, whether it is a finding, and held-out residual."""

    model: str
    named: bool
    held_out: float


def scenario_of(rig: str) -> Scenario:
    """Return the baseline scenario of a rig, without the effect."""
    return read_scenario(read_document(Path(__file__).parent / f"{rig}.yaml"), Catalog(), seed=0)


def diagnosed(rig: str, *, progress: Callable[[str], None] = lambda _: None) -> MotionOutcome:
    """Return the diagnosis of a rig's recordings; FileNotFoundError if they are missing and cannot be downloaded."""
    module = import_module(f"proof.real.{rig}")
    held = (module.HELD,) if isinstance(module.HELD, str) else module.HELD
    return diagnose_motion(scenario_of(rig), module.recordings(), held_out=held, progress=progress)


def figures(rig: str, outcome: MotionOutcome) -> tuple[Figure, ...]:
    """Return the held-out residual of the baseline and, for each step, of hypotheses above a tenth of the best gain."""
    measure = ERROR_MEASURES[rig]
    answer = [Figure(model="baseline", named=True, held_out=error(outcome.before, outcome.runs, measure))]
    for step in outcome.steps:
        worth = [one for one in step.tried if one.gain > 0.1 * step.kept.gain]
        answer += [
            Figure(model=_name(one), named=one is step.kept, held_out=error(one.model, outcome.runs, measure))
            for one in sorted(worth, key=lambda one: one.gain)
        ]
    return tuple(answer)


def error(model: FittedMotion, runs: tuple[Moved, ...], measure: ErrorMeasure) -> float:
    """Return the rms residual of the held-out runs in the unit of ``measure``."""
    pairs = [(run, residual) for run, residual in zip(runs, model.residuals, strict=True) if run.held.any()]
    rms = root_mean_square([_filtered(residual, run, measure)[run.held] for run, residual in pairs])
    if measure.unit.startswith("%"):
        return 100 * rms / root_mean_square([_filtered(run.effort, run, measure)[run.held] for run, _ in pairs])
    return rms / abs(runs[0].channel.si_per_unit)


def _filtered(values: NDArray[np.float64], run: Moved, measure: ErrorMeasure) -> NDArray[np.float64]:
    return values if measure.below is None else low_passed(values, measure.below / run.rate)


def _name(one: Tried) -> str:
    return one.candidate.mechanism + (f" ({one.candidate.variant})" if one.candidate.variant else "")
