"""Held-out errors of a real rig: of the baseline without the effect, and of each hypothesis that was tried."""

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
from torquerig.diagnosis.motion.moved import Moved, low_passed
from torquerig.diagnosis.motion.tried import Tried
from torquerig.document import read_document
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

RIGS = ("emps", "laas", "brfd")


@dataclass(frozen=True, kw_only=True)
class Told:
    """How the figures of one rig are counted: relative [%] or in the channel's unit, and below which frequency [Hz].

    EMPS is counted below 30 Hz: the pulses of the held-out run excite a flexibility that no rigid model has.
    """

    unit: str
    below: float | None = None


TOLD = {
    "emps": Told(unit="% of the force", below=30.0),
    "laas": Told(unit="A"),
    "brfd": Told(unit="kip"),
}


@dataclass(frozen=True, kw_only=True)
class Figure:
    """One line of the table: what the model has, whether the diagnosis named it, and its held-out error."""

    model: str
    named: bool
    held_out: float


def scenario_of(rig: str) -> Scenario:
    """Return the baseline scenario of a rig: everything but the effect."""
    return read_scenario(read_document(Path(__file__).parent / f"{rig}.yaml"), Catalog(), seed=0)


def diagnosed(rig: str, *, progress: Callable[[str], None] = lambda _: None) -> MotionOutcome:
    """Return the diagnosis of a rig's recordings; FileNotFoundError where they are not here and cannot be fetched."""
    module = import_module(f"proof.real.{rig}")
    held = (module.HELD,) if isinstance(module.HELD, str) else module.HELD
    return diagnose_motion(scenario_of(rig), module.recordings(), held_out=held, progress=progress)


def figures(rig: str, outcome: MotionOutcome) -> tuple[Figure, ...]:
    """Return the held-out error of the baseline and, step by step, of every hypothesis worth a tenth of the best."""
    told = TOLD[rig]
    answer = [Figure(model="baseline", named=True, held_out=error(outcome.before, outcome.runs, told))]
    for step in outcome.steps:
        worth = [one for one in step.tried if one.gain > 0.1 * step.kept.gain]
        answer += [
            Figure(model=_name(one), named=one is step.kept, held_out=error(one.model, outcome.runs, told))
            for one in sorted(worth, key=lambda one: one.gain)
        ]
    return tuple(answer)


def error(model: FittedMotion, runs: tuple[Moved, ...], told: Told) -> float:
    """Return the rms of what a model leaves of the held-out runs, as ``told`` counts it."""
    pairs = [(run, residual) for run, residual in zip(runs, model.residuals, strict=True) if run.held.any()]
    rms = root_mean_square([_counted(residual, run, told)[run.held] for run, residual in pairs])
    if told.unit.startswith("%"):
        return 100 * rms / root_mean_square([_counted(run.effort, run, told)[run.held] for run, _ in pairs])
    return rms / abs(runs[0].channel.si_per_unit)


def _counted(values: NDArray[np.float64], run: Moved, told: Told) -> NDArray[np.float64]:
    return values if told.below is None else low_passed(values, told.below / run.rate)


def _name(one: Tried) -> str:
    return one.candidate.mechanism + (f" ({one.candidate.variant})" if one.candidate.variant else "")
