"""``simulate``: what the torque sensor of a rig records."""

from __future__ import annotations

from math import isinf
from pathlib import Path

from torquerig.api.inputs import scenario_from
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate as simulate_rig


def simulate(
    scenario: Scenario | str | Path, *, duration: float | None = None, seed: int = 1, truth: bool = True
) -> Recording:
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

    Examples
    --------
    >>> import torquerig as tr
    >>> rec = tr.simulate("wear_rig.yaml", duration=0.5, seed=1)
    >>> rec.samples, rec.sample_rate
    (12500, 25000.0)
    """
    made = scenario_from(scenario)
    recording = simulate_rig(
        made.rig, duration=default_length(made) if duration is None else duration, seed=seed,
        sample_rate=made.recording.sample_rate, settling=made.recording.settling,
        wander=made.operating_point.slow_speed_wander, scenario=made.title,
    )  # fmt: skip
    return recording if truth else recording.without_truth()


def default_length(made: Scenario) -> float:
    """Return how long to record where nothing states it [s]: a table's length, else ``recording.duration``."""
    points = made.rig.run.set_points
    return made.recording.duration if points is None or isinf(points.length) else points.length
