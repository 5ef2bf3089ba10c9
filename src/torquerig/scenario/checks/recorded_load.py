"""Loads that only a simulation knows, which the required torque of a motor would leave out."""

from __future__ import annotations

from torquerig.errors import InputError
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import driven_motor
from torquerig.rig.parts import ReplayedTorque, TorqueController
from torquerig.scenario.model import Scenario


def refuse_unstated_load(scenario: Scenario) -> None:
    """Refuse a rig whose load is recorded or that of a second drive, where the profile does not state the load.

    Raises
    ------
    InputError
        With the first part whose torque the required torque of the motor does not contain, and the remedy.
    """
    if _profile_states_load(scenario):
        return
    for name, what in unstated_loads(scenario.rig).items():
        raise InputError(
            f"{scenario.document.place(('rig', name))}: {name} is {what}, which the required torque of the motor does "
            "not contain; replace it by a particle_load with the mean of the load (as in the shipped "
            "shaft_line_design.yaml), or state load_torque in every segment of operating_point: duty_cycle: and use "
            "that profile"
        )


def unstated_loads(rig: Rig) -> dict[str, str]:
    """Return each part whose torque no requirement contains, by name, with what it is."""
    driven = driven_motor(rig)
    found = {part.name: "a recorded load (replayed_torque)" for part in rig.parts_of(ReplayedTorque)}
    for drive in rig.parts_of(TorqueController):
        is_moved = drive.torque or drive.recording is not None or drive.from_ is not None
        if is_moved and drive.beside is None and driven is not None and drive.motor != driven.name:
            found[drive.name] = f"the drive of a second motor, {drive.motor} (torque_controller)"
    return found


def _profile_states_load(scenario: Scenario) -> bool:
    """Return whether the profile states a load torque for its whole length, which counts in place of the rig's."""
    point, course = scenario.operating_point, scenario.rig.run.set_points
    if point.profile == "duty_cycle" and point.duty_cycle is not None:
        return all(one.load_torque is not None for one in point.duty_cycle.segments)
    return isinstance(course, Tabulated) and course.rows.load is not None
