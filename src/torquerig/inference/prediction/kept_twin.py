"""What a twin says of a run that depends on few of its numbers, kept for the next rig that agrees in them."""

from __future__ import annotations

from collections.abc import Hashable

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.skirts import Skirts, skirts_of
from torquerig.inference.prediction.wound_up import held_shares
from torquerig.linear_twin.quasi_static import OPPOSING, QuasiStatic, quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load, Spring

Floats = NDArray[np.float64]


def loads_of(rig: Rig) -> tuple[Load, ...]:
    """Return the loads of a rig at its run."""
    return tuple(term for term in rig.terms() if isinstance(term, Load))


def clumping_of(rig: Rig) -> float:
    """Return the variance that few hits of its loads leave in the logarithm of the power in a time T, times T [s]."""
    return max((float(getattr(load.process, "clumping", 0.0)) for load in loads_of(rig)), default=0.0)


def load_key(twin: Twin) -> tuple[Hashable, ...]:
    """Return all that the density depends on which random loads make in the reading."""
    return twin.shafts, twin.cutoff, twin.scale, loads_of(twin.rig)


def kept_skirts(twin: Twin, seen: RunFeatures, node: str) -> Skirts | None:
    """Return the skirts of the lines of a node; see ``skirts_of``."""
    key = (twin.shafts, loads_of(twin.rig), node)
    return seen.kept.get("sway", key, lambda: skirts_of(twin, seen.run, node))


def level_balance(twin: Twin, seen: RunFeatures) -> QuasiStatic:
    """Return the slow torques at the moments of each part [N m], shape (levels, POINTS)."""
    return seen.kept.get(
        "levels", _slow_key(twin),
        lambda: quasi_static(
            twin, speed=seen.level_speed, acceleration=seen.level_acceleration, held=held_shares(twin, seen)
        ),
    )  # fmt: skip


def level_inertia(twin: Twin, seen: RunFeatures) -> Floats:
    """Return the change of the torque in the reading per acceleration of the motor [kg m^2], shape (levels,)."""

    def made() -> Floats:
        more = quasi_static(
            twin, speed=seen.level_speed, acceleration=seen.level_acceleration + 1.0, held=held_shares(twin, seen)
        )
        return np.asarray((more.sensor - level_balance(twin, seen).sensor).mean(axis=1))

    return seen.kept.get("inertia", _slow_key(twin), made)


def speed_balance(twin: Twin, seen: RunFeatures) -> QuasiStatic:
    """Return the slow torques at the speeds of each segment [N m], shape (segments x speeds,)."""
    speeds = seen.speeds.ravel()
    return seen.kept.get(
        "speeds", _slow_key(twin), lambda: quasi_static(twin, speed=speeds, acceleration=np.zeros(speeds.size))
    )


def _slow_key(twin: Twin) -> tuple[Hashable, ...]:
    """Return all that slow torques depend on: what opposes the motion, and the shafts between."""
    opposing = tuple(term for term in twin.terms if isinstance(term, (*OPPOSING, Spring)))
    return opposing, twin.scale, twin.rig.measured, twin.drives[0].on
