"""From recordings of one rig and its nominal scenario to a completed model, by one likelihood."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from torquerig.errors import InputError, RecordingError
from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine, search_lines
from torquerig.inference.features.run_features import run_features
from torquerig.inference.features.slow_waves import slow_waves
from torquerig.inference.fit import Data, Fit, fitted, sketched
from torquerig.inference.knobs import Knob, with_free_load
from torquerig.inference.measured_run import MeasuredRun, measured_runs
from torquerig.inference.model import Model
from torquerig.inference.model_density import model_densities
from torquerig.inference.own_features import refuted
from torquerig.inference.parameters import parameters
from torquerig.inference.places import Place, order
from torquerig.inference.readings import SET_POINT_ERROR, Reading, SetupFault, best_reading
from torquerig.inference.readings.conditions import with_measured_course, with_occupancy
from torquerig.inference.readings.volts import in_volts
from torquerig.inference.rig_under_test import check_recordings, check_rig
from torquerig.inference.sample_faults import on_few_codes, rounding_step, sample_faults, usable_runs
from torquerig.inference.search import searched
from torquerig.inference.set_points import off_set_points
from torquerig.inference.shared_orders import with_phases
from torquerig.inference.undecided_lines import in_both_domains
from torquerig.inference.untrue_samples import samples_as_compared
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.faults import Fault
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import InductionDrive
from torquerig.scenario.model import Scenario

Progress = Callable[[str], None]
Fitter = Callable[[Rig, Sequence[Knob], Data], Fit]

SHORTEST = 2.0  # [s] a shorter recording has no spectrum of a load


@dataclass(frozen=True, eq=False)
class Outcome:
    """A completed model with the data that it was fitted to and judged by.

    Parameters
    ----------
    runs : tuple of MeasuredRun
    data, held : Data
        Features of the fitted and of the held-out blocks.
    nominal : Fit
        Of the scenario's rig, its own parameters fitted.
    model : Model
    stated : Fit
        Of the scenario's rig to the recordings as their sidecars state them; ``nominal`` without faults of the set-up.
    stated_held : Data
        The held-out features of these.
    found : tuple of FoundLine
        All lines that the nominal rig does not have.
    setup : tuple of SetupFault
        Corrected before all else.
    judged : bool
        Whether blocks are left to which a model can be compared; not where all are at a limit of the reading.
    untrue : tuple of Fault
        Faults of the samples that no mechanism makes.
    remarks : tuple of str
        What was repaired or left out of the comparison, and which sidecars state another speed, each in a sentence.
    """

    runs: tuple[MeasuredRun, ...]
    data: Data
    held: Data
    nominal: Fit
    model: Model
    stated: Fit
    stated_held: Data
    found: tuple[FoundLine, ...] = ()
    setup: tuple[SetupFault, ...] = ()
    judged: bool = True
    untrue: tuple[Fault, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def completed(self) -> Rig:
        """The rig with all additions and its parameters at their estimates."""
        return self.model.fit.fitted_rig

    @property
    def completes(self) -> bool:
        """Whether something was added to the rig."""
        return bool(self.model.additions)


@dataclass(frozen=True, eq=False)
class Prepared:
    """The nominal rig fitted to recordings, before anything is added to it; fields as in ``Outcome``."""

    runs: tuple[MeasuredRun, ...]
    known: tuple[Place, ...]
    data: Data
    nominal: Fit
    stated: Reading
    setup: tuple[SetupFault, ...]
    samples: tuple[Addition, ...] = ()
    judged: bool = True
    untrue: tuple[Fault, ...] = ()
    remarks: tuple[str, ...] = ()


def diagnose(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str] = (),
    progress: Progress = lambda _: None,
) -> Outcome:  # fmt: skip
    """Return the model that completes a scenario's rig until it explains the recordings, or the nominal one.

    The features of all runs (lines, bands, levels) have one likelihood under a model. The parameters of the nominal rig
    are fitted first. Then nameless effects, numbers far from their stated values and mechanisms of the library compete
    by posterior odds; each must also make held-out data more likely. Those are every third block of each run, or the
    whole recordings named in ``held_out``.

    Raises
    ------
    InputError, RecordingError
        Where the scenario has no motor or no measured place that transmits torque, the recordings are of different
        rigs, one is too short, or ``held_out`` names none of them or all.
    """
    ready = prepared(scenario, recordings, held_out=held_out, progress=progress)
    runs, data, nominal = ready.runs, ready.data, ready.nominal
    progress("searching lines that the model lacks")
    densities = model_densities(nominal, data)
    found = search_lines([seen.run for seen in data.seen], ready.known, densities) if ready.judged else ()
    if ready.judged:
        own = [line.order for line in Twin(nominal.fitted_rig.at(runs[0].run)).lines()]
        known = [*ready.known, *(line.place for line in found)]
        found += tuple(slow_waves(data.seen, [each.level for each in nominal.expected], known, own))
    lines = in_both_domains(found, data.seen)
    places = [*ready.known, *(line.place for line in lines)]
    if lines:
        data = features_of(runs, places)
        nominal = fitted(
            nominal.rig, nominal.knobs, data, start=nominal.positions, gains=nominal.gains, off=nominal.off
        )
    held = features_of(runs, places, held_out=True)
    model = searched(nominal, data, held, lines, progress=progress) if ready.judged else Model(nominal, (), ())
    model = replace(model, additions=(*ready.samples, *model.additions), refuted=refuted(model, data, held))
    stated_held = features_of(ready.stated.runs, places, held_out=True) if ready.setup else held
    stated = ready.stated.fit if ready.setup else nominal
    return Outcome(
        runs, data, held, nominal, model, stated, stated_held, lines, ready.setup, ready.judged, ready.untrue,
        ready.remarks,
    )  # fmt: skip


def prepared(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str] = (),
    progress: Progress = lambda _: None,
) -> Prepared:  # fmt: skip
    """Return the nominal rig fitted to the recordings, with faults of the set-up corrected; raises as ``diagnose``."""
    check_rig(scenario.rig)
    check_recordings(recordings)
    for recording in recordings:
        if recording.duration < SHORTEST:
            raise RecordingError(
                f"{recording.name}: {recording.duration:.2f} s are too short for a diagnosis; record at least "
                f"{SHORTEST:g} s, better 12 s"
            )
    recordings, unstated = with_occupancy(recordings, scenario.rig)
    recordings, moving = with_measured_course(recordings, scenario.rig)
    rig = with_phases(with_free_load(scenario.rig.at(recordings[0].run)))
    progress("looking for faults of the samples")
    recordings = [in_volts(each, rig) for each in recordings]
    shown = samples_as_compared(recordings, rig, sample_faults(recordings, rig))
    faults = shown.faults
    rig = faults.added_to(rig)
    point = scenario.operating_point
    progress("estimating the angle of the motor")

    def measured(of: Rig) -> tuple[tuple[MeasuredRun, ...], bool]:
        made = measured_runs(faults.recordings, of)
        ready = [
            replace(run, lost=lost, wander=point.slow_speed_wander, wander_cutoff=point.slow_speed_wander_cutoff)
            for run, lost in zip(made, faults.lost, strict=True)
        ]
        usable, judged = usable_runs(ready, faults.unusable, step=rounding_step(of))
        return with_held_out(usable, held_out), judged

    runs, judged = measured(rig)
    progress("fitting the parameters of the nominal model")

    def read(
        of: Rig, runs: Sequence[MeasuredRun] | None = None, *, also: Sequence[Place] = (), fit: Fitter = sketched
    ) -> Reading:  # fmt: skip
        runs = measured(of)[0] if runs is None else runs
        own = (order(line.order) for run in runs for line in Twin(of.at(run.run)).lines())
        seen = features_of(runs, sorted({*also, *own}))
        return Reading(tuple(runs), seen, fit(of, parameters(scenario, of, runs), seen))

    stated = read(rig, runs, fit=fitted)  # most others lose by far, and need no more than a sketch
    within = point.speed_set_point_error_max or SET_POINT_ERROR
    reading = (best_reading(stated, rig, read, set_point_error=within) if judged else stated).finished()
    known = reading.data.seen[0].places
    slips = bool(rig.parts_of(InductionDrive))  # its speed follows the load, which is no error of a set-point
    off = () if reading.faults or slips else off_set_points(reading.runs, error=within)
    samples = faults.without_scaled_codes(each.estimated for each in reading.faults if each.kind == "sensor_scale")
    return Prepared(
        reading.runs, known, reading.data, reading.fit, stated, reading.faults, samples, judged, shown.untrue,
        (*unstated, *moving, *shown.sentences, *on_few_codes(runs, step=rounding_step(rig)), *off),
    )  # fmt: skip


def with_held_out(runs: Sequence[MeasuredRun], names: Sequence[str]) -> tuple[MeasuredRun, ...]:
    """Return the runs with all blocks of the named ones held out, and none of the others; unchanged without names."""
    known = [run.name for run in runs]
    unknown = [name for name in names if name not in known]
    if unknown:
        raise InputError(f"--held-out {unknown[0]}: no recording has this name; choose among {', '.join(known)}")
    if names and set(names) >= set(known):
        raise InputError("--held-out names every recording; leave at least one for the fit")
    if not names:
        return tuple(runs)
    compared = {run.name for run in runs if run.blocks}
    if not compared & set(names) or compared <= set(names):
        which = f"of the others than {names[0]}" if compared & set(names) else f"of {names[0]}"
        remedy = f"hold out one of {', '.join(sorted(compared))}" if len(compared) > 1 else "leave the option out"
        raise InputError(
            f"--held-out {names[0]}: nothing {which} can be compared, all is at a limit or stays on one code; {remedy}"
        )
    return tuple(
        replace(run, blocks=tuple(replace(block, held_out=run.name in names) for block in run.blocks)) for run in runs
    )


def features_of(runs: Sequence[MeasuredRun], places: Sequence[Place], *, held_out: bool = False) -> Data:
    """Return the features of the fitted or the held-out blocks of all runs that have such blocks."""
    rows = [row for row, run in enumerate(runs) if any(block.held_out == held_out for block in run.blocks)]
    return Data.of([run_features(runs[row], places, held_out=held_out) for row in rows], rows=rows, runs=runs)
