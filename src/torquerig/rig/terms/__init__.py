"""The closed vocabulary of physics: every part and every mechanism is a sum of these terms, and nothing else.

shafts       inertia, spring (gap, gear, errors), imposed motion      inputs   torques and motions given from outside
resistance   friction, bristles, loads over time and over angle       drives   drive, torque harmonics, applied torque

Each torque acts between two nodes, equal and opposite; ``GROUND`` is the frame. A node is a place on a shaft with one
angle; a term names nodes by the parts that open them. A rig that moves in a line uses the same terms with kg, N, m.
A new term is a reasoned change here, in ``simulation/arrays.py``, ``simulation/rows.py``, ``simulation/kernel/`` and
``simulation/linear.py``; everything else comes for free.

Sign convention: positive torque on a node speeds it up in the positive direction; the torque of a spring is positive
when ``a`` runs ahead of ``b``, which is how a driving motor loads the sensor.
"""

from torquerig.rig.terms.drives import AppliedTorque, Drive, HarmonicTorque, Sensing
from torquerig.rig.terms.inputs import AngleProcess, LoadProcess, Motion, Signal
from torquerig.rig.terms.resistance import AngleLoad, BladeTorque, BristleFriction, Friction, Load
from torquerig.rig.terms.shafts import GROUND, ImposedMotion, Inertia, Spring, Wave

Resistance = Friction | BristleFriction | Load | AngleLoad | BladeTorque
Term = Inertia | Spring | ImposedMotion | HarmonicTorque | AppliedTorque | Drive | Resistance

__all__ = [
    "GROUND",
    "AngleLoad",
    "AngleProcess",
    "AppliedTorque",
    "BladeTorque",
    "BristleFriction",
    "Drive",
    "Friction",
    "HarmonicTorque",
    "ImposedMotion",
    "Inertia",
    "Load",
    "LoadProcess",
    "Motion",
    "Resistance",
    "Sensing",
    "Signal",
    "Spring",
    "Term",
    "Wave",
]
