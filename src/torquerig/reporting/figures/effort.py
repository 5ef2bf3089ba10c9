"""The words and the unit of what is measured, for the axes of figures: a torque, or a force in a line."""

from __future__ import annotations

from torquerig.recordings.recording import Recording


def effort_name(recording: Recording) -> str:
    """Return ``torque``, or ``force`` where a force is measured."""
    return recording.channels[recording.torque_name()].quantity


def effort_unit(recording: Recording) -> str:
    """Return the SI unit of what is measured as an axis shows it: ``N m``, or ``N`` of a force."""
    return shown_unit(recording.torque_unit())


def shown_unit(unit: str) -> str:
    """Return a unit as an axis shows it: ``N m`` for ``N*m``."""
    return unit.replace("*", " ")
