"""What a diagnosis would compare, and what looks wrong: ``torquerig diagnose --check`` and the studio show it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.inference.motion.imposed_run import BAND, imposed_runs
from torquerig.inference.rig_under_test import check_recordings, check_rig
from torquerig.orders.angle.suspicions import angle_sentences
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.recording import Recording
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.reading_place import effort_unit
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured, what_is_compared
from torquerig.scenario.recorded.gear_ratio import at_ratio_of
from torquerig.scenario.recorded.input_checks import as_driven, inputs_shown
from torquerig.scenario.recorded.sensor_priors import sensor_priors
from torquerig.simulation.condensation.beforehand import said_beforehand

_HEAD = ["recording", "samples", "per second", "compared channel", "rms", "motion"]


@dataclass(frozen=True, kw_only=True)
class RunCheck:
    """What a diagnosis of these recordings compares, and what looks wrong before it is made.

    Parameters
    ----------
    head, rows : sequence of str, sequence of rows
        Table of the recordings: samples, rate, compared channel, rms, motion.
    compared : tuple of str
        Which channel was chosen and why, and what drives the model.
    sensors : tuple of str
        What is known of the sensors' errors.
    suspicious : tuple of str
        Facts of channels and set-up that contradict each other, each with the name of its recording.
    condensed : tuple of str
        Which fast parts of the rig are condensed.
    fitted : tuple of str
        Uncertain parameters, which are fitted before mechanisms are tested.
    """

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    compared: tuple[str, ...]
    sensors: tuple[str, ...]
    suspicious: tuple[str, ...]
    condensed: tuple[str, ...]
    fitted: tuple[str, ...]

    def text(self) -> str:
        """Return it as ``torquerig diagnose --check`` prints it."""
        names = ", ".join(self.fitted) or "none, no parameter has a rel_sd"
        sentences = [*self.compared, *self.sensors, *(f"suspicious: {one}" for one in self.suspicious), *self.condensed]
        sentences.append(f"parameters fitted before mechanisms are tested: {names}")
        last = "scenario and recordings match; no diagnosis was made"
        return "\n".join([grid([self.head, *self.rows]), *map(wrapped, sentences), last])


def run_check(scenario: Scenario, recordings: Sequence[Recording]) -> RunCheck:
    """Return what a diagnosis would compare.

    Raises
    ------
    InputError, RecordingError
        If a diagnosis would reject the scenario or a recording before any computation.
    """
    recordings = as_driven(scenario, as_measured(recordings, scenario.rig))
    choices = (what_is_compared(one, scenario.rig) for one in recordings)
    compared = [choice for choice in choices if choice is not None]
    compared += [shown for one in recordings for shown in inputs_shown(scenario, one)]
    is_moved = imposed_part(scenario.rig) is not None
    ratio = None if is_moved else kinematics_of(scenario.rig).ratio
    rates = dict.fromkeys(each.sample_rate for each in recordings)
    return RunCheck(
        head=_HEAD,
        rows=_of_motion(scenario, recordings) if is_moved else _of_speed_loop(scenario, recordings),
        compared=tuple(compared),
        sensors=tuple(prior.sentence() for prior in sensor_priors(scenario, recordings) if prior.states_something),
        suspicious=tuple(
            f"{each.name}: {sentence}" for each in recordings for sentence in angle_sentences(each, ratio=ratio)
        ),
        condensed=tuple(text for rate in rates if (text := said_beforehand(scenario.rig, rate=rate))),
        fitted=tuple(sorted(scenario.uncertainties)),
    )


def _of_motion(scenario: Scenario, recordings: Sequence[Recording]) -> list[list[str]]:
    runs, rows = imposed_runs(recordings, scenario.rig), []
    line = effort_unit(scenario.rig) == "N"
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
