"""From recordings of a rig under measured motion and its scenario to a diagnosis: the stations in their order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.believed import believed
from torquerig.diagnosis.motion.completing import completed
from torquerig.diagnosis.motion.effort_told import Told, effort_told, limit_is_the_readings, with_codes
from torquerig.diagnosis.motion.fitted import FittedMotion, at_their_ends, residuals_of
from torquerig.diagnosis.motion.friction import viscous_at, without_peak
from torquerig.diagnosis.motion.goes_with import goes_with
from torquerig.diagnosis.motion.lines import in_a_line, lines_in
from torquerig.diagnosis.motion.moved import STRETCHES, Moved, faults_in, moved_runs
from torquerig.diagnosis.motion.neutral import Neutral, neutral, neutral_part
from torquerig.diagnosis.motion.objections import lacks_viscous
from torquerig.diagnosis.motion.places import mismatches
from torquerig.diagnosis.motion.set_aside import set_aside
from torquerig.diagnosis.motion.sign_smoothed import knobs_of_the_sign
from torquerig.diagnosis.motion.told import finding, relative_error
from torquerig.diagnosis.motion.tried import Refused, Step
from torquerig.diagnosis.outcome import Diagnosis, HeldOut, UsedRecording, Verdict, as_json
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.knobs import Knob, nuisance_knobs, unvaried
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

Floats = NDArray[np.float64]

METRIC = (
    "Rms residual of held-out data, relative to the rms of the measured torque or force. "
    "The residual is measured minus simulated, below a tenth of the sample rate, with the recorded motion imposed. "
    "0 is a perfect model; 1 is a model that predicts zero."
)
_LEFT_OUT = (
    "Samples at a limit and dropouts are excluded from fits and held-out data. They do not change the held-out "
    "residual."
)
_NEUTRALS = 3
_DRAWS = 400


@dataclass(frozen=True, kw_only=True)
class MotionOutcome:
    """A diagnosis of a rig under measured motion, with what a report shows of it.

    Parameters
    ----------
    diagnosis : Diagnosis
    runs : tuple of Moved
    nominal : Rig
        The scenario's.
    before, after : FittedMotion
        The nominal model calibrated, and with the findings in it.
    missed, left : tuple of Mismatch
        Where the calibrated model is wrong, and where the one with the findings still is.
    steps : tuple of Step
        Each kept hypothesis with its rivals.
    neutrals : tuple of Neutral
        What a nameless term does for each line that is left.
    completed : Rig
        What a scenario file is written of.
    """

    diagnosis: Diagnosis
    runs: tuple[Moved, ...]
    nominal: Rig
    before: FittedMotion
    after: FittedMotion
    missed: tuple[Mismatch, ...]
    left: tuple[Mismatch, ...]
    steps: tuple[Step, ...]
    neutrals: tuple[Neutral, ...]
    completed: Rig

    @property
    def completes(self) -> bool:
        """Whether the completed rig has parts that the scenario lacks."""
        return bool(self.diagnosis.findings)

    def as_json(self) -> dict[str, Any]:
        """Return the diagnosis in the contract's form."""
        data = as_json(self.diagnosis)
        data["fit"]["metric"] = METRIC
        return data


def diagnose_motion(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str] = (), seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> MotionOutcome:  # fmt: skip
    """Return where model and recordings differ, which physics was left out, and how much better the model gets.

    Parameters
    ----------
    held_out : sequence of str
        Recordings that no fit may see; without any, every other tenth of each recording is held out.

    Raises
    ------
    InputError, RecordingError
        Where the scenario measures no imposed motion, or a recording lacks effort or motion.
    """
    rig = scenario.rig.at(recordings[0].run)
    knobs = nuisance_knobs(rig, scenario.uncertainties, occupancies=[])
    knobs = (*knobs, *knobs_of_the_sign(rig, knobs))
    progress("tracking the motion")
    for limits in (True, False):
        faults = faults_in(recordings, limits=limits)
        runs = moved_runs(recordings, rig, held_out=held_out, faults=faults)
        before, steps, refused = _completed(rig, runs, knobs, progress)
        if faults.limit is None or limit_is_the_readings(faults, _last(before, steps), runs):
            break
        progress("repeating the fit: the limit is that of the drive, not of the reading")
    after, code = with_codes(_last(before, steps), runs)
    of_samples = tuple(effort_told(faults, after, runs, code=code))
    left = mismatches(after, runs, before=before)
    whole = goes_with(after, runs)
    left = left if whole is None else (*left, whole.mismatch)
    missed = mismatches(before, runs) if steps else left
    lines = lines_in(after.residuals, runs)[:_NEUTRALS] if left else ()
    neutrals = tuple(neutral(line, after.residuals, runs) for line in lines)
    findings = (*(each.finding for each in of_samples), *(finding(step, after, runs) for step in steps))
    ends = at_their_ends(after, of=before.knobs)
    verdict: Verdict = "unexplained" if left or ends else "missing_physics" if findings else "adequate"
    diagnosis = Diagnosis(
        verdict=verdict, mismatch=_mismatch(missed, left), findings=findings,
        fit=_held_out(rig, before, after, runs, seed), recordings=tuple(_used(run) for run in runs),
        remarks=(*unvaried(rig, scenario.uncertainties),
                 *_remarks(neutrals, after, runs), *_of_viscous(refused, runs), *ends,
                 *([] if whole is None else [whole.sentence]),
                 *([_LEFT_OUT] if any(mask.any() for mask in faults.spoilt) else [])),
        set_aside=set_aside(rig, steps, refused, of_samples=[each.finding.mechanism for each in of_samples]),
    )  # fmt: skip
    return MotionOutcome(
        diagnosis=diagnosis, runs=runs, nominal=rig, before=before, after=after, missed=missed, left=left, steps=steps,
        neutrals=neutrals, completed=_written(after, neutrals, runs, of_samples),
    )  # fmt: skip


def _completed(
    rig: Rig, runs: Sequence[Moved], knobs: Sequence[Knob], progress: Callable[[str], None]
) -> tuple[FittedMotion, tuple[Step, ...], tuple[Refused, ...]]:
    """Return the calibrated model, the steps that complete it and are believed, and what was refused."""
    progress("fitting the parameters of the nominal model")
    before, found, refused = completed(rig, runs, knobs, progress=progress)
    progress("predicting the held-out data")
    return before, *believed(before, found, refused, runs)


def _last(before: FittedMotion, steps: Sequence[Step]) -> FittedMotion:
    return steps[-1].kept.model if steps else before


def _mismatch(missed: tuple[Mismatch, ...], left: tuple[Mismatch, ...]) -> tuple[Mismatch, ...]:
    """Return what was wrong before, and behind it what still is."""
    places = {(one.domain, round(one.at, 1)) for one in missed}
    return (*missed, *(one for one in left if (one.domain, round(one.at, 1)) not in places))


def _held_out(nominal: Rig, before: FittedMotion, after: FittedMotion, runs: Sequence[Moved], seed: int) -> HeldOut:
    rng = np.random.default_rng(seed)
    blocks = [
        (float((one[part] ** 2).sum()), float((two[part] ** 2).sum()))
        for run, one, two in zip(runs, before.residuals, after.residuals, strict=True)
        for part in np.array_split(np.flatnonzero(run.held), 2 * STRETCHES)
    ]
    squares = np.array(blocks)
    drawn = squares[rng.integers(0, len(squares), (_DRAWS, len(squares)))].sum(axis=1)
    gains = 1 - np.sqrt(drawn[:, 1] / np.maximum(drawn[:, 0], 1e-300))
    raw = FittedMotion(nominal, (), np.zeros(0), np.zeros((0, 0)), 0.0, residuals_of(nominal, runs))
    first, second = relative_error(before, runs), relative_error(after, runs)
    low, high = (float(end) for end in np.quantile(gains, [0.025, 0.975]))
    return HeldOut(nominal=relative_error(raw, runs), before=first, after=second,
                   improvement=(1 - second / first, low, high))  # fmt: skip


def _remarks(neutrals: Sequence[Neutral], after: FittedMotion, runs: Sequence[Moved]) -> tuple[str, ...]:
    unit = "N" if in_a_line(runs) else "N m"
    axis = "cycles/m of the motion" if in_a_line(runs) else "cycles per turn of the motor"
    said = []
    for each in neutrals:
        where = f"{each.line.at:.4g} {'Hz' if each.line.domain == 'frequency' else axis}"
        said.append(
            f"No mechanism of the library explains the line at {where}, {each.line.amplitude:.3g} {unit}. A sinusoid "
            f"there, fitted to the first half of each recording, explains it also in the second half. The residual at "
            f"constant speed falls from {each.before:.4g} to {each.after:.4g} {unit} rms."
        )
    zero = f"The fitted zero of the measured channel is {after.zero:.3g} {unit}."
    return (*said, f"{zero} Dry friction that depends on the direction can look the same.")


def _of_viscous(refused: Sequence[Refused], runs: Sequence[Moved]) -> Iterator[str]:
    """Yield what friction in proportion to the speed the scenario lacks, where nothing was named for it."""
    best = refused[-1].tried if refused else None
    if best is None or not lacks_viscous(best, runs):
        return
    at = best.candidate.parts[0].name
    unit = "N s/m" if in_a_line(runs) else "N m s/rad"
    drag = viscous_at(best.model.rig, best.model.rig.part(at).at)[0]  # type: ignore[attr-defined]
    yield (
        f"The residual is proportional to the speed: {drag:.3g} {unit} of viscous friction. Viscous friction is a "
        "parameter, not a mechanism. State it in the scenario."
    )


def _written(
    after: FittedMotion, neutrals: Sequence[Neutral], runs: Sequence[Moved], of_samples: Sequence[Told]
) -> Rig:
    rig = after.rig
    for part in after.rig.parts:
        rig = rig.changed(without_peak(part, after.knobs))
    first = next(index for index, run in enumerate(runs) if run.seen.any())
    for number, each in enumerate(neutrals, start=1):
        line = neutral_part(each.line, after.residuals[first], runs[first], rig, number=number)
        rig = rig if line is None else rig + line
    for told in of_samples:
        rig += told.part
    return rig


def _used(run: Moved) -> UsedRecording:
    speed = float(np.mean(np.abs(run.speed))) * (1.0 if in_a_line([run]) else 30 / pi)
    used = "split" if run.seen.any() and run.held.any() else "fit" if run.seen.any() else "held_out"
    return UsedRecording(file=run.name, speed_rpm=0.0 if in_a_line([run]) else speed, used_for=used)
