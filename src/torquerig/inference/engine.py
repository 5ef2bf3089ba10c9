"""From recordings of one rig and its nominal scenario to a completed model, by one likelihood."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from torquerig.diagnosis.fitting.knobs import with_free_load
from torquerig.diagnosis.linear.twin import Twin
from torquerig.diagnosis.looking.places import Place, order
from torquerig.diagnosis.rig_under_test import check_recordings, check_rig
from torquerig.errors import RecordingError
from torquerig.inference.features.line_search import search_lines
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, Fit, fitted
from torquerig.inference.measured_run import MeasuredRun, measured_runs
from torquerig.inference.model_density import model_densities
from torquerig.inference.parameters import parameters
from torquerig.inference.search import Model, searched
from torquerig.inference.setup_faults import SetupFault, best_reading
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

Progress = Callable[[str], None]

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
    setup : tuple of SetupFault
        Corrected before all else.
    """

    runs: tuple[MeasuredRun, ...]
    data: Data
    held: Data
    nominal: Fit
    model: Model
    setup: tuple[SetupFault, ...] = ()

    @property
    def completed(self) -> Rig:
        """The rig with all additions and its parameters at their estimates."""
        return self.model.fit.fitted_rig

    @property
    def completes(self) -> bool:
        """Whether something was added to the rig."""
        return bool(self.model.additions)


def diagnose(scenario: Scenario, recordings: Sequence[Recording], *, progress: Progress = lambda _: None) -> Outcome:
    """Return the model that completes a scenario's rig until it explains the recordings, or the nominal one.

    The features of all runs (lines, bands, levels) have one likelihood under a model. The parameters of the nominal rig
    are fitted first. Then nameless effects, numbers far from their stated values and mechanisms of the library compete
    by posterior odds; each must also make held-out data more likely.

    Raises
    ------
    InputError, RecordingError
        Where the scenario has no motor or no measured place that transmits torque, the recordings are of different
        rigs, or one is too short.
    """
    check_rig(scenario.rig)
    check_recordings(recordings)
    for recording in recordings:
        if recording.duration < SHORTEST:
            raise RecordingError(
                f"{recording.name}: {recording.duration:.2f} s are too short for a diagnosis; record at least "
                f"{SHORTEST:g} s, better 12 s"
            )
    rig = with_free_load(scenario.rig.at(recordings[0].run))
    progress("estimating the angle of the motor")
    runs = measured_runs(recordings, rig)
    known = sorted({order(line.order) for run in runs for line in Twin(rig.at(run.run)).lines()})
    knobs = parameters(scenario, rig, runs)
    progress("fitting the parameters of the nominal model")

    def nominal_fit(of: Sequence[MeasuredRun]) -> tuple[Data, Fit]:
        seen = _features(of, known)
        return seen, fitted(rig, knobs, seen)

    reading = best_reading(runs, rig, nominal_fit)
    runs, data, nominal = reading.runs, reading.data, reading.fit
    progress("searching lines that the model lacks")
    lines = search_lines(runs, known, model_densities(nominal, data))
    places = [*known, *(line.place for line in lines)]
    if lines:
        data = _features(runs, places)
        nominal = fitted(rig, knobs, data, start=nominal.positions, gains=nominal.gains)
    held = _features(runs, places, held_out=True)
    model = searched(nominal, data, held, lines, progress=progress)
    return Outcome(runs, data, held, nominal, model, reading.faults)


def _features(runs: Sequence[MeasuredRun], places: Sequence[Place], *, held_out: bool = False) -> Data:
    return Data.of([run_features(run, places, held_out=held_out) for run in runs])
