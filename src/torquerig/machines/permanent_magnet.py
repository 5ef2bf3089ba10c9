"""The permanent-magnet machine, phase by phase: what BLDC and PMSM have in common.

Nomenclature: v, i, e per phase, star point not connected; theta mechanical, p pole pairs; peak phase quantities.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi, sqrt
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from torquerig.machines.back_emf import BackEmf, HarmonicEmf
from torquerig.machines.checks import check_fields
from torquerig.parameter import Parameter

Floats = NDArray[np.float64]
Shares = tuple[float, float, float]
PHASE_LAG = np.array([0.0, 2 * pi / 3, 4 * pi / 3])


@dataclass(frozen=True, kw_only=True)
class PermanentMagnetMachine:
    """``v = R i + L di/dt + e``, ``e = p w lambda s(p theta)``, ``T = p lambda sum_x s_x i_x``.

    The torque is written with the unit shape s and not as power over speed, so that it holds at standstill.
    ``phase_inductance`` is self minus mutual inductance, the same at every angle and current; no cogging.
    ``resistance_unbalance`` is what the resistance of each phase, cable and connector included, differs from the
    common one, as a share; the control is tuned for the common one.
    ``flux_linkage`` is the peak of e over the electrical speed where the shape is one (with a trapezoid, its flat top).

    Source: Pillay & Krishnan 1989, IEEE Trans. Industry Applications 25(2), part II, abc model.
    """

    pole_pairs: Annotated[int, Parameter("1", "pole pairs", low=1)]
    phase_resistance: Annotated[float, Parameter("ohm", "resistance of one phase", above=0)]
    phase_inductance: Annotated[float, Parameter("H", "inductance of one phase", above=0)]
    flux_linkage: Annotated[float, Parameter("V*s", "flux linkage of one phase, per electrical radian", above=0)]
    back_emf: BackEmf = field(default_factory=HarmonicEmf)
    resistance_unbalance: Annotated[Shares, Parameter("1", "extra resistance of a phase", above=-1)] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def time_constant(self) -> float:
        """The time constant of the current without control, L/R [s]."""
        return self.phase_inductance / self.phase_resistance

    def phase_shapes(self, angle: Floats) -> Floats:
        """Return the unit back-EMF of the three phases, shape (n, 3), at mechanical ``angle`` (n,) [rad]."""
        return self.back_emf.shape(self.pole_pairs * np.asarray(angle)[:, None] - PHASE_LAG)

    def torque(self, angle: Floats, currents: Floats) -> Floats:
        """Return the torque (n,) [N*m] of phase ``currents`` (n, 3) [A] at mechanical ``angle`` (n,) [rad]."""
        shapes = self.phase_shapes(angle)
        return np.asarray(self.pole_pairs * self.flux_linkage * np.sum(shapes * currents, axis=1), dtype=np.float64)


def flux_from_torque_constant(torque_constant: float, *, pole_pairs: int) -> float:
    """Return the flux linkage [V s/rad] of a data sheet's torque constant [N*m per ampere rms], sinusoidal machine.

    ``T = 3/2 p lambda sqrt(2) I_rms``.
    """
    return torque_constant / (1.5 * sqrt(2) * pole_pairs)


def flux_from_voltage_constant(volts_per_krpm: float, *, pole_pairs: int) -> float:
    """Return the flux linkage [V s/rad] of a voltage constant in V rms, line to line, per 1000 rpm, sinusoidal machine.

    ``U = sqrt(3/2) p w lambda``. Divide by sqrt(2) first where peak volts are stated; stated phase to neutral,
    multiply by sqrt(3).
    """
    return volts_per_krpm / (1000 * pi / 30) * sqrt(2 / 3) / pole_pairs
