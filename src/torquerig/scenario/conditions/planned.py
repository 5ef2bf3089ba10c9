"""Set-points of the motor from the profile of a scenario."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from torquerig.recordings.profiles.duty_cycle import Segment, duty_cycle
from torquerig.recordings.profiles.from_file import read_profile
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load
from torquerig.scenario.conditions.profile_text import DutyCycleText, SegmentText, TableText


def planned(written: DutyCycleText | TableText, rig: Rig, *, motor_turns: float, folder: Path) -> Tabulated:
    """Return the profile in speeds of the motor.

    Parameters
    ----------
    rig : Rig
        At the occupancy that holds where a segment states none.
    motor_turns : float
        Motor turns per output turn [1].
    folder : Path
        Folder of the table's file.

    Raises
    ------
    InputError
        For an occupancy that the rig's load does not know, and a table with a gap.
    """
    if isinstance(written, TableText):
        rows, output = read_profile(folder / written.file)
        return Tabulated(rows=rows.times(motor_turns if output else 1.0), repeats=written.repeats)
    loaded = any(one.load_torque is not None or one.occupancy is not None for one in written.segments)
    segments = [
        Segment(
            duration=one.duration,
            speed=(one.motor_speed or 0.0) if one.output_speed is None else one.output_speed * motor_turns,
            ramp=one.ramp,
            load=_load(one, rig) if loaded else None,
            held=one.load_torque is not None,
        )
        for one in written.segments
    ]
    return duty_cycle(segments, repeats=written.repeats)


def mean_of_loads(rig: Rig) -> float:
    """Return the mean load torque of the rig at its operating point [N m]."""
    return sum(term.process.mean for term in rig.terms() if isinstance(term, Load))


def _load(one: SegmentText, rig: Rig) -> float:
    if one.load_torque is not None:
        return one.load_torque
    run = rig.run if one.occupancy is None else replace(rig.run, occupancy_percent=one.occupancy)
    return mean_of_loads(rig.at(run))
