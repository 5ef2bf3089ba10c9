"""Conditions of a run that its sidecar does not state: from the scenario, or from the measured speed, and said so."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import numpy as np

from torquerig.inference.measured_run import measured_runs
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig

_CHANGES = 0.3  # of the largest mean speed of a part: loads make a drive at one set-point sway, its mean moves by less
_PARTS = 12  # of a recording: each holds some periods of the slowest sway of a drive
_POINTS = 101  # of a measured course of the speed
_SHOWS_SPEED = ("motor_angle", "motor_speed")


def with_occupancy(recordings: Sequence[Recording], rig: Rig) -> tuple[list[Recording], tuple[str, ...]]:
    """Return the recordings with the occupancy of the scenario where the load depends on it and none is stated."""
    percent = rig.run.occupancy_percent
    loads = [part for part in rig.parts if len(getattr(part, "mean_by_occupancy_percent", ())) > 1]
    if not loads or percent is None:
        return [*recordings], ()
    unstated = [each.name for each in recordings if each.run.occupancy_percent is None]
    made = [
        replace(each, run=replace(each.run, occupancy_percent=percent)) if each.name in unstated else each
        for each in recordings
    ]
    return made, tuple(
        f"{name}: the sidecar states no occupancy. That of the scenario, {percent:g} %, is used. Add "
        "occupancy_percent under run: of the sidecar."
        for name in unstated
    )


def with_measured_course(recordings: Sequence[Recording], rig: Rig) -> tuple[list[Recording], tuple[str, ...]]:
    """Return the recordings with the measured course of the speed where the sidecar states a steady run and it is none.

    The speed is that of a channel of the motor's angle or speed; pulses of a tacho are not looked at.
    """
    made, said = [], []
    for recording in recordings:
        shown = recording.run.profile == "steady" and any(map(recording.find, _SHOWS_SPEED))
        speed = measured_runs([recording], rig)[0].speed if shown else np.zeros(1)
        means = [float(part.mean()) for part in np.array_split(speed, min(_PARTS, speed.size))]
        low, high = min(means), max(means)
        if high - low <= _CHANGES * max(abs(low), abs(high)):
            made.append(recording)
            continue
        time = np.linspace(0, recording.duration, _POINTS)
        rows = Breakpoints(
            time=tuple(time.tolist()), speed=tuple(np.interp(time, recording.time(), speed).tolist())
        )  # fmt: skip
        run = replace(recording.run, profile="csv", set_points=Tabulated(rows=rows), speed=rows.top)
        made.append(replace(recording, run=run))
        said.append(
            f"{recording.name}: the sidecar states a steady run or no profile, but the measured speed goes from "
            f"{low * 30 / pi:.4g} to {high * 30 / pi:.4g} rpm. The measured course is used. State profile: ramp, "
            "profile: reversal or set_point: under run: of the sidecar."
        )
    return made, tuple(said)
