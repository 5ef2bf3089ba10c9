"""Output of ``torquerig diagnose --check``: whether scenario and recordings match, and what is compared."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np

from torquerig.cli.suspicions import angle_sentences
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.diagnosis.motion.moved import BAND, moved_runs, under_measured_motion
from torquerig.diagnosis.rig_under_test import check_recordings, check_rig
from torquerig.diagnosis.sheet_ratio import at_ratio_of
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.recording import Recording
from torquerig.rig.reading_place import effort_unit
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured, what_is_compared
from torquerig.scenario.recorded.input_checks import as_driven, inputs_shown
from torquerig.scenario.recorded.sensor_priors import sensor_priors
from torquerig.simulation.condensation.beforehand import said_beforehand

_HEAD = ["recording", "samples", "per second", "compared channel", "rms", "motion"]


def checked(scenario: Scenario, recordings: Sequence[Recording]) -> str:
    """Return a table of what a diagnosis compares.

    Raises
    ------
    InputError, RecordingError
        If a diagnosis would reject the scenario or a recording before any computation.
    """
    recordings = as_driven(scenario, as_measured(recordings, scenario.rig))
    choices = (what_is_compared(one, scenario.rig) for one in recordings)
    compared = [wrapped(choice) for choice in choices if choice is not None]
    compared += [wrapped(shown) for one in recordings for shown in inputs_shown(scenario, one)]
    sensors = [wrapped(prior.sentence()) for prior in sensor_priors(scenario, recordings) if prior.states_something]
    is_moved = under_measured_motion(scenario.rig)
    rows = _of_motion(scenario, recordings) if is_moved else _of_speed_loop(scenario, recordings)
    names = sorted(scenario.uncertainties)
    fitted = f"parameters fitted before mechanisms are tested: {', '.join(names) or 'none, no parameter has a rel_sd'}"
    ratio = None if is_moved else kinematics_of(scenario.rig).ratio
    suspicious = [
        wrapped(f"suspicious: {each.name}: {sentence}")
        for each in recordings
        for sentence in angle_sentences(each, ratio=ratio)
    ]
    rates = dict.fromkeys(each.sample_rate for each in recordings)
    condensed = [text for rate in rates if (text := said_beforehand(scenario.rig, rate=rate))]
    last = "scenario and recordings match; no diagnosis was made"
    return "\n".join(
        [grid([_HEAD, *rows]), *compared, *sensors, *suspicious, *map(wrapped, condensed), wrapped(fitted), last]
    )


def _of_motion(scenario: Scenario, recordings: Sequence[Recording]) -> list[list[str]]:
    runs, rows = moved_runs(recordings, scenario.rig), []
    line = in_a_line(runs)
    for run in runs:
        effort, stroke = float(np.sqrt(np.mean(run.effort**2))), float(np.ptp(run.position))
        fastest = float(np.abs(run.speed).max())
        moved = (
            f"travel {stroke:.4g} m, up to {fastest:.3g} m/s"
            if line
            else f"travel {stroke:.4g} rad, up to {fastest:.3g} rad/s"
        )
        compared = next(name for name, one in run.recording.channels.items() if one is run.channel)
        rows.append([
            run.name, f"{run.recording.samples}", f"{run.rate:g}", f"{compared}, below {BAND * run.rate:g} Hz",
            f"{effort:.4g} {'N' if line else 'N*m'}", moved,
        ])  # fmt: skip
    return rows


def _of_speed_loop(scenario: Scenario, recordings: Sequence[Recording]) -> list[list[str]]:
    check_rig(scenario.rig)
    check_recordings(recordings)
    rows = []
    for each in at_ratio_of(recordings, scenario.rig):
        speed = "no set-point" if each.run.speed is None else f"{each.run.speed * 30 / pi:.5g} rpm"
        encoder = next((name for name in map(each.find, ("motor_angle", "angle", "tacho")) if name), None)
        motion = f"{each.run.profile}, {speed}, {each.run.occupancy_percent or 0:g} % occupancy"
        motion += f", {encoder}" if encoder else ", no encoder"
        rms = f"{float(np.sqrt(np.nanmean(each.torque() ** 2))):.4g} {effort_unit(scenario.rig)}"
        rows.append([each.name, f"{each.samples}", f"{each.sample_rate:g}", each.torque_name(), rms, motion])
    return rows
