"""The closed vocabulary of physics: every part and every mechanism is a sum of these terms, and nothing else.

shafts       inertia, spring (gap, gear, errors), imposed motion      inputs   torques and motions given from outside
resistance   friction, bristles, loads over time and over angle       drives   drive, torque harmonics, applied torque

Each torque acts between two nodes, equal and opposite; ``GROUND`` is the frame. A node is a place on a shaft with one
angle; a term names nodes by the parts that open them. A rig that moves in a line uses the same terms with kg, N, m.
term   what all have in common

A new term is a reasoned change of three places: its class here (equation, nodes, mean torque), its kind in
``simulation/term_kinds/`` (arrays, share of the linear matrices), its torque in ``simulation/kernel/``.

Sign convention: positive torque on a node speeds it up in the positive direction; the torque of a spring is positive
when ``a`` runs ahead of ``b``, which is how a driving motor loads the sensor.
"""

from torquerig.rig.terms.drives import AppliedTorque, Drive, HarmonicTorque, Sensing
from torquerig.rig.terms.inputs import AngleProcess, LoadProcess, Motion, Signal
from torquerig.rig.terms.resistance import AngleLoad, BladeTorque, BristleFriction, Friction, Load
from torquerig.rig.terms.shafts import GROUND, ImposedMotion, Inertia, Spring, Wave
from torquerig.rig.terms.term import ShaftMotion, Term

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
    "Sensing",
    "ShaftMotion",
    "Signal",
    "Spring",
    "Term",
    "Wave",
]
