"""The arrays that a rig is lowered to, one tuple per kind of term; the kernel and the linear twin read them.

Nodes are numbered; the last index is the ground, whose angle and speed stay zero and whose torque is thrown away.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Rows = NDArray[np.uint64]  # unsigned: a signed index costs a test for counting from the end, a sixth of the run time
Starts = NDArray[np.int64]


RUNGS = 4  # a ladder of multiples is climbed four at a time: each four is the four before it times the fourth


class Waves(NamedTuple):
    """Cosines and sines of order times angle, each made once a step: one sine a base, its multiples, products."""

    base_node: Rows  # (bases,) node whose angle is taken
    base_order: Floats  # (bases,)
    ladder: Rows  # (bases + 1,) where the slots of the multiples 1, 2, 3, ... of each base start; whole fours
    first: Rows  # (products,) slot number ladder[-1] + i is the product of two earlier slots
    second: Rows


class Springs(NamedTuple):
    """Springs, dampers, gaps, gears; ``e`` rows are the kinematic error's waves."""

    a: Rows
    b: Rows
    stiffness: Floats
    damping: Floats
    half_gap: Floats
    inverse_ratio: Floats
    loss_mean: Floats  # (1/eta + eta) / 2
    loss_half: Floats  # (1/eta - eta) / 2
    e_first: Starts  # (springs + 1,) where each spring's error waves start
    e_slot: Rows
    e_order: Floats
    e_cos: Floats
    e_sin: Floats


class Harmonics(NamedTuple):
    """Torques, each a sum of ``cos * c - sin * s`` of its slots, on a node and against another."""

    on: Rows  # (pairs of nodes,)
    against: Rows
    first: Rows  # (pairs + 1,) where the waves of each pair start
    slot: Rows
    c: Floats
    s: Floats


class Frictions(NamedTuple):
    """Coulomb and static torque by direction: column 0 backward, column 1 forward."""

    on: Rows
    against: Rows
    coulomb: Floats  # (frictions, 2)
    excess: Floats  # (frictions, 2): static minus Coulomb
    inverse_stribeck: Floats
    viscous: Floats
    backward_extra: Floats  # viscous friction backward less that forward
    quadratic: Floats
    inverse_smoothing: Floats


class Varied(NamedTuple):
    """Springs whose stiffness has waves, relative to its mean."""

    spring: Rows
    damping_follows: Rows  # 1 where the damping varies alike
    first: Starts
    slot: Rows
    order: Floats
    c: Floats
    s: Floats


class Bristles(NamedTuple):
    """Bristle frictions; column 0 backward, column 1 forward."""

    on: Rows
    against: Rows
    stiffness: Floats
    damping: Floats
    coulomb: Floats  # (bristles, 2)
    excess: Floats  # (bristles, 2): static minus Coulomb
    inverse_stribeck: Floats
    viscous: Floats


class AngleLoads(NamedTuple):
    """Torques over the angle; all grids one after the other, each with its first point once more at its end."""

    on: Rows
    inverse_smoothing: Floats
    points_per_radian: Floats
    first: Starts  # (angle loads + 1,)
    values: Floats


class Loads(NamedTuple):
    """Sampled torques, linear between samples: they oppose a node's motion, or drive it where the smoothing is 0."""

    on: Rows
    inverse_smoothing: Floats
    samples: Floats  # (loads, settling + samples + 1)


class Blades(NamedTuple):
    """Half-wave-squared load pulses from a slot."""

    on: Rows
    slot: Rows
    c: Floats
    s: Floats
    amplitude: Floats
    inverse_smoothing: Floats


class Drives(NamedTuple):
    """Motors; ``reference`` holds the set-point of the speed at every sample, ``demand`` the torque beside the PI."""

    on: Rows
    against: Rows
    kp: Floats
    ki: Floats
    limit: Floats
    inverse_lag: Floats
    r_first: Starts
    r_slot: Rows
    r_c: Floats
    r_s: Floats
    breakdown: Floats  # slip speed of an induction machine's breakdown, 0 for a controlled drive
    reference: Floats  # (drives, settling + samples + 1)
    demand: Floats  # (drives, settling + samples + 1)


class Sensings(NamedTuple):
    """What each drive sees of its speed; the error's waves are made where they are needed, once a sample."""

    ideal: Rows  # 1 where it sees the true speed
    step: Floats  # (drives,) [rad] of a count, 0: continuous
    filter_time: Floats
    first: Starts
    order: Floats
    c: Floats
    s: Floats


class Imposed(NamedTuple):
    """Nodes whose motion is given at every sample."""

    on: Rows
    inertia: Floats  # what sits on the node: it moves by its torques once it is released
    release: Starts  # sample from which on it is no longer imposed
    angle: Floats  # (imposed, settling + samples + 1)
    speed: Floats


class Outputs(NamedTuple):
    """What to keep at every sample."""

    kind: Rows
    row: Rows


class Terms(NamedTuple):
    """All of a rig, as the kernel takes it."""

    inverse_inertia: Floats  # (nodes + 1,) [1/(kg m^2)], zero for the ground
    waves: Waves
    springs: Springs
    harmonics: Harmonics
    frictions: Frictions
    loads: Loads
    blades: Blades
    drives: Drives
    sensings: Sensings
    imposed: Imposed
    varied: Varied
    bristles: Bristles
    angle_loads: AngleLoads
