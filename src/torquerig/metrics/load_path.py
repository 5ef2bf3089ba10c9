"""What the shafts make of a load on its way to the sensor: why two drives read another rms of the same load."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from torquerig.rig.assembly import Rig


@dataclass(frozen=True, kw_only=True)
class LoadPath:
    """The torque in the sensor per torque of the load, by the linear twin with its speed loop closed.

    Parameters
    ----------
    inertia_share : float
        ``J1 / (J1 + J2)`` [1], J1 before and J2 behind the sensor, referred to its shaft: the share of a load that
        changes faster than the speed loop and slower than the first mode.
    largest : float
        The largest gain [1], at a torsional mode.
    at : float
        Its frequency [Hz].
    """

    inertia_share: float
    largest: float
    at: float


def load_path(rig: Rig) -> LoadPath | None:
    """Return the way of the load to the sensor; None for a rig without a load or without a sensor spring."""
    from torquerig.metrics.sizing.load_fidelity import frequencies_of, reading_per_load, rigid_fidelity
    from torquerig.rig.terms import Load, Spring

    terms = rig.terms()
    if not any(isinstance(term, Load) for term in terms):
        return None
    if not any(isinstance(term, Spring) and term.name == rig.measured for term in terms):
        return None
    frequencies = frequencies_of(rig)
    gain = np.abs(reading_per_load(rig, frequencies, closed=True))
    peak = int(np.argmax(gain))
    return LoadPath(inertia_share=rigid_fidelity(rig), largest=float(gain[peak]), at=float(frequencies[peak]))
