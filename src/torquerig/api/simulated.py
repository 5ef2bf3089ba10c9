"""``simulate``: what the torque sensor of a rig records."""

from __future__ import annotations

from dataclasses import replace
from math import isinf
from pathlib import Path
from warnings import warn

from torquerig.api.inputs import recording_from, scenario_from
from torquerig.recordings.inputs import Inputs
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.input_checks import as_driven
from torquerig.simulation.input_channels import with_input_channels, with_inputs
from torquerig.simulation.loop_stability import loop_warning
from torquerig.simulation.simulator import simulate as simulate_rig


def simulate(
    scenario: Scenario | str | Path, *, duration: float | None = None, seed: int = 1, truth: bool = True,
    inputs: Recording | str | Path | None = None, steps: int | None = None,
) -> Recording:  # fmt: skip
    """Return what the torque sensor of a rig records.

    Parameters
    ----------
    scenario : Scenario, or path of its file
    duration : float, optional
        Length [s], > 0; without it the length of the scenario's table or duty cycle, else ``recording.duration``.
    seed : int
        Fixes every random number of the run; the same scenario, seed and version give the same samples.
    truth : bool
        Whether the channels that only a simulation knows are kept, such as the true load.
    inputs : Recording, or path of its file, optional
        Whose channels drive the parts with ``from: channel``; length and, where the scenario states none, sample rate
        are then its own.
    steps : int, optional
        Integration steps per sample, > 0, taken unchecked; without it chosen from the fastest motion and checked.

    Returns
    -------
    Recording
        Sampled as ``recording.sample_rate`` of the scenario states, 25 kHz by default.

    Raises
    ------
    InputError
        For a scenario that cannot be used, or a rig without the speed that its controller needs.
    SimulationError
        Where the state becomes non-finite; names the node and the time.

    Warns
    -----
    UserWarning
        Where the integration step is too coarse, the motion chaotic, the speed loop unstable, or the motor stalls or
        stays at its torque limit; each with its remedy.

    Examples
    --------
    >>> import torquerig as tr
    >>> rec = tr.simulate("wear_rig.yaml", duration=0.5, seed=1)
    >>> rec.samples, rec.sample_rate
    (12500, 25000.0)
    """
    made, given = scenario_from(scenario), None if inputs is None else recording_from(inputs)
    made = made if given is None else under_inputs(made, given)
    recording = simulate_rig(
        made.rig, duration=default_length(made) if duration is None else duration, seed=seed,
        sample_rate=sample_rate_of(made), settling=made.recording.settling,
        wander=made.operating_point.slow_speed_wander, scenario=made.title, substeps=steps,
    )  # fmt: skip
    doubts = (*recording.origin.get("warnings", ()), loop_warning(made.rig, rate=recording.sample_rate))
    for doubt in filter(None, doubts):
        warn(doubt, stacklevel=2)
    recording = with_input_channels(recording, made.rig)
    return recording if truth else recording.without_truth()


def under_inputs(made: Scenario, given: Recording) -> Scenario:
    """Return a scenario driven by the channels of a recording; InputError where it takes none, or lacks one."""
    rig = with_inputs(made.rig, given)
    as_driven(made, [given])
    return replace(made, rig=rig)


def sample_rate_of(made: Scenario) -> float:
    """Return the samples per second [Hz] of a simulation: as the scenario states them, else those of its inputs."""
    inputs, stated = made.rig.run.inputs, made.document.data.get("recording")
    if isinstance(inputs, Inputs) and not (isinstance(stated, dict) and "sample_rate" in stated):
        return inputs.recording.sample_rate
    return made.recording.sample_rate


def default_length(made: Scenario) -> float:
    """Return how long to record where nothing states it [s]: a table's length, else ``recording.duration``."""
    if isinstance(made.rig.run.inputs, Inputs):
        return made.rig.run.inputs.recording.duration
    points = made.rig.run.set_points
    return made.recording.duration if points is None or isinf(points.length) else points.length
