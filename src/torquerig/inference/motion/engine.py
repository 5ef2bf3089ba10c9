"""From recordings of a rig whose motion was measured, and its scenario, to a completed model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.inference.knobs import Knob, nuisance_knobs
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.held_out import HeldOut, held_out
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import ImposedRun, imposed_runs
from torquerig.inference.motion.search import Step, searched
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario

Floats = NDArray[np.float64]
Progress = Callable[[str], None]

_SMOOTHING = (
    0.7  # of the logarithm: nobody states the speed over which a dry friction changes its sign to a factor of 2
)


@dataclass(frozen=True, eq=False)
class MotionOutcome:
    """A completed model under measured motion, with what it was judged by.

    Parameters
    ----------
    runs : tuple of ImposedRun
    stated, nominal, fit : Fit
        The scenario as it is stated, with its uncertain parameters fitted, and with all additions.
    held : tuple of HeldOut
        The judgements of these three.
    steps : tuple of Step
        The additions, each with the alternatives in its place.
    refused : tuple of (Hypothesis, float)
        What was not added, and the gain of its posterior odds [nats].
    """

    runs: tuple[ImposedRun, ...]
    stated: Fit
    nominal: Fit
    fit: Fit
    held: tuple[HeldOut, HeldOut, HeldOut]
    steps: tuple[Step, ...]
    refused: tuple[tuple[object, float], ...]

    @property
    def completes(self) -> bool:
        """Whether something was added to the rig."""
        return bool(self.steps)

    @property
    def completed(self) -> Rig:
        """The rig with its parameters at their estimates and the parts of all additions that the library has."""
        rig = self.fit.rig
        for each in self.fit.model.additions:
            for part in each.parts:
                rig = rig.changed(_without_unseen_peak(rig.part(part.name), {knob.field for knob in each.knobs}))
            if each.written is not None and not each.local:
                for part in each.written(sizes_of(self.fit, each.name, scale=each.scale)):
                    rig = rig + part
        return rig


def diagnose_motion(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out_runs: Sequence[str] = (),
    progress: Progress = lambda _: None,
) -> MotionOutcome:  # fmt: skip
    """Return the model that completes a scenario's rig until it explains the effort along the measured motion.

    Every third frame of each recording, or the recordings named in ``held_out_runs``, is seen by no fit and judges.

    Raises
    ------
    InputError, RecordingError
        Where the scenario measures no imposed motion, or a recording lacks effort or motion.
    """
    stated, nominal = nominal_fits(scenario, recordings, held_out_runs=held_out_runs, progress=progress)
    found = searched(nominal, progress=progress)
    progress("predicting the held-out data")
    judged = [held_out(one) for one in (stated, nominal, found.fit)]
    if any(one is None for one in judged):
        raise InputError("the rig cannot be simulated along the motion of the held-out recordings")
    one, two, three = (each for each in judged if each is not None)
    return MotionOutcome(nominal.runs, stated, nominal, found.fit, (one, two, three), found.steps, found.refused)


def nominal_fits(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out_runs: Sequence[str],
    progress: Progress,
) -> tuple[Fit, Fit]:  # fmt: skip
    """Return the scenario as it is stated, and with its uncertain parameters fitted; errors as ``diagnose_motion``."""
    rig = scenario.rig.at(recordings[0].run)
    progress("differentiating the motion")
    runs = imposed_runs(recordings, rig, held_out=held_out_runs)
    stated = fitted(Model(rig, ()), runs)
    progress("fitting the parameters of the nominal model")
    knobs = nuisance_knobs(rig, scenario.uncertainties, occupancies=[])
    nominal = fitted(Model(rig, (*knobs, *_smoothing(rig, knobs))), runs)
    if stated is None or nominal is None:
        raise InputError("the rig cannot be simulated along the measured motion; state less stiffness or more damping")
    return stated, nominal


def sizes_of(fit: Fit, name: str, *, scale: float) -> Floats:
    """Return the fitted sizes of a linear addition [N m] or [N]."""
    rows = [row for row, each in enumerate(fit.names) if each.startswith(f"{name}[")]
    return np.asarray(scale * fit.positions[rows])


def _smoothing(rig: Rig, known: Sequence[Knob]) -> tuple[Knob, ...]:
    """Return a parameter for the speed over which each stated dry friction of the imposed shaft changes its sign."""
    taken, imposed = {knob.name for knob in known}, imposed_part(rig)
    assert imposed is not None
    dry = [
        part for part in rig.parts
        if getattr(part, "coulomb", 0.0) and getattr(part, "smoothing", 0.0)
        and rig.node(getattr(part, "at", part.name)) == rig.node(imposed.at)
    ]  # fmt: skip
    knobs = [Knob(part.name, "smoothing", _SMOOTHING) for part in dry]
    return tuple(knob for knob in knobs if knob.name not in taken)


def _without_unseen_peak(part: Any, fitted_fields: set[str]) -> Part:
    """Return a friction whose static value was not fitted with the sliding one in its place."""
    if not hasattr(part, "static") or "static" in fitted_fields:
        return cast("Part", part)
    changed = {"static": part.coulomb}
    if getattr(part, "coulomb_backward", None) is not None:
        changed["static_backward"] = part.coulomb_backward
    return cast("Part", replace(part, **changed))
