"""motulator's two masses and synchronous machine, by the interface of release 0.5 (Python 3.11) or of 0.18 (newer)."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

Slope = Callable[[float, NDArray[np.float64]], NDArray[np.float64]]


def _model() -> Any:
    return pytest.importorskip("motulator.drive.model", reason="motulator is not installed (pip install motulator)")


def two_masses(*, motor: float, load: float, stiffness: float, damping: float) -> Slope:
    """Return d/dt of (motor speed, load speed, twist) at 1 N m on the motor [kg m2, N m/rad, N m s/rad]."""
    model = _model()
    numbers = {"J_M": motor, "J_L": load, "K_S": stiffness, "C_S": damping, "B_L": 0.0}
    old = not hasattr(model, "SynchronousMachinePars")
    if old:
        system = model.TwoMassMechanicalSystem(par=SimpleNamespace(**numbers), tau_L=lambda _: 0.0)
        system.state.exp_j_theta_M = 1.0
    else:
        system = model.TwoMassMechanicalSystem(**numbers)

    def slope(time: float, values: NDArray[np.float64]) -> NDArray[np.float64]:
        system.state.w_M, system.state.w_L, system.state.theta_ML = (complex(value) for value in values)
        system.inp.tau_M = 1.0
        system.set_outputs(time)
        made = system.rhs() if old else system.rhs(time)
        by_name = dict(zip(("w_M", "theta_M", "w_L", "theta_ML") if old else vars(system.state), made, strict=True))
        return np.array([np.real(by_name[name]) for name in ("w_M", "w_L", "theta_ML")])

    return slope


class Machine:
    """motulator's synchronous machine in coordinates of its rotor."""

    def __init__(self, *, pole_pairs: int, resistance: float, inductance: float, flux: float) -> None:
        model = _model()
        numbers = {"n_p": pole_pairs, "R_s": resistance, "L_d": inductance, "L_q": inductance, "psi_f": flux}
        self.old = not hasattr(model, "SynchronousMachinePars")
        if self.old:
            pars = pytest.importorskip("motulator.drive.utils").SynchronousMachinePars
        else:
            pars = model.SynchronousMachinePars
        self.machine = model.SynchronousMachine(pars(**numbers))

    def torque(self, flux: complex) -> float:
        """Return the torque [N m] at a stator flux [V s]."""
        if self.old:
            self.machine.state.psi_s = flux
            return float(self.machine.tau_M)
        self.machine.state.psi_s_dq = flux
        self.machine.set_outputs(0.0)
        return float(self.machine.out.tau_M)

    def slope_without_voltage(self, flux: complex, speed: float) -> complex:
        """Return d(flux)/dt [V] with shorted terminals at a speed [rad/s] of the rotor."""
        inputs, state = self.machine.inp, self.machine.state
        inputs.w_M = speed
        if self.old:
            state.psi_s, state.exp_j_theta_m, inputs.u_ss = flux, 1.0, 0.0
        else:
            state.psi_s_dq, state.theta_m, inputs.u_s_ab = flux, 0j, 0j
        self.machine.set_outputs(0.0)
        return complex((self.machine.rhs() if self.old else self.machine.rhs(0.0))[0])
