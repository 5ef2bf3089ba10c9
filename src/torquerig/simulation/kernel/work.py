"""The work arrays of the loop, allocated before it starts, so that nothing is allocated within it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.arrays import Floats, Rows
from torquerig.simulation.term_kinds import Terms


class Work(NamedTuple):
    """One array per purpose; ``_k`` holds the stage's state, ``_sum`` the weighted slopes, ``_before`` the step's."""

    cosine: Floats  # per wave
    sine: Floats
    spring_torque: Floats  # per spring
    contact: Floats
    contact_before: Floats
    stiffness: Floats
    damping: Floats
    twisted: Floats
    twisting: Floats
    twisted_before: Floats
    twisting_before: Floats
    first_low: Floats  # what decides a contact, at both ends of where it changes
    second_low: Floats
    first_high: Floats
    second_high: Floats
    parted: Floats  # (1,) 1 where a contact changed while samples were kept
    gaps: Rows  # the springs that have one
    inverse_inertia: Floats  # per node
    theta_k: Floats
    omega_k: Floats
    theta_sum: Floats
    omega_sum: Floats
    opposing: Floats
    torque: Floats
    torque_before: Floats
    integral: Floats  # per drive
    command: Floats
    seen_angle: Floats
    seen_speed: Floats
    tau: Floats
    tau_k: Floats
    tau_sum: Floats
    bend: Floats  # per bristle friction
    bend_k: Floats
    bend_sum: Floats
    bend_slope: Floats
    bend_before: Floats
    load_now: Floats  # per load


def copied(work: Work) -> Work:
    """Return the same in arrays of their own."""
    arrays: dict[str, NDArray[Any]] = {name: array.copy() for name, array in work._asdict().items()}
    return Work(**arrays)


def work_for(terms: Terms) -> Work:
    """Return the arrays for a rig, all zero but for what the loop changes of the rig's own."""
    sizes = {
        "cosine": int(terms.waves.ladder[-1]) + terms.waves.first.size,
        "spring_torque": terms.springs.a.size,
        "parted": 1,
        "inverse_inertia": terms.inverse_inertia.size,
        "integral": terms.drives.on.size,
        "bend": terms.bristles.on.size,
        "load_now": terms.loads.on.size,
    }
    made: dict[str, NDArray[Any]] = {}
    size = 0
    for name in Work._fields:  # each group takes the size of its first
        size = sizes.get(name, size)
        made[name] = np.zeros(size)
    made |= {
        "stiffness": terms.springs.stiffness.copy(),
        "damping": terms.springs.damping.copy(),
        "inverse_inertia": terms.inverse_inertia.copy(),
        "gaps": np.flatnonzero(terms.springs.half_gap > 0).astype(np.uint64),
    }
    return Work(**made)
