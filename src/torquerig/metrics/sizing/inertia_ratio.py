"""Ratio of the driven inertia to the inertia of the rotor."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.rig.drive_train import drive_train
from torquerig.rig.terms import Inertia


def inertia_ratio(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``inertia_ratio``: all inertia but the rotor's, seen from the motor, over the rotor's [1].

    The gearbox counts as load. ``sum(J r^2) / J_rotor``. Makers of servo drives require at most 3 to 10, depending on
    the stiffness of the shafts; a rig that measures torque behind the gear needs a small one, see ``load_fidelity``.
    """
    return {
        "inertia_ratio": over_intervals(drive.data, lambda v: ratio_of(drive, v), source="inertias through the gears")
    }


def ratio_of(drive: SizedDrive, values: Values) -> float:
    """Return the ratio for one set of values [1]."""
    rig = drive.with_values(values)
    node = rig.node(drive.part.name)
    train = drive_train(rig, node)
    rotor = sum(one.inertia for one in train.terms if isinstance(one, Inertia) and one.node == node)
    return (train.inertia - rotor) / rotor
