"""Cogging: orders of the rotor's angle that slots and magnets allow."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import lcm, pi

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.motion.fitted_model import Fit, effort_scale
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis
from torquerig.inference.motion.imposed_run import BAND, ImposedRun
from torquerig.rig.assembly import Part
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import Motor

Floats = NDArray[np.float64]

_HIGHEST = 6  # times the native order: harmonics beyond are below a per cent


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield the native order, and all orders of unequal teeth and magnets; what the data do not need is dropped."""
    rig = fit.model.nominal
    imposed = imposed_part(rig)
    motor = rig.part(imposed.at) if imposed else None
    if not isinstance(motor, Motor) or motor.slots is None or motor.pole_pairs is None or rig.of_kind("cogging"):
        return
    poles, slots = 2 * motor.pole_pairs, motor.slots
    native = lcm(slots, poles)
    highest = min(_HIGHEST * native, max(_highest(run) for run in fit.runs))
    families = {
        "native": [native * k for k in range(1, _HIGHEST + 1)],
        "tolerances": [k for k in range(1, _HIGHEST * native + 1) if k % slots == 0 or k % poles == 0],
    }
    labels = {"native": f"cogging at order {native}", "tolerances": f"cogging at multiples of {slots} and {poles}"}
    for variant, every in families.items():
        orders = tuple(float(order) for order in every if order <= highest)
        if orders:
            yield Hypothesis(
                name="cogging", mechanism="cogging", variant=variant,
                label=f"{labels[variant]} per turn of {motor.name}",
                columns=Orders(orders), scale=effort_scale(fit.runs), log_odds=MECHANISM, axis="motor_shaft",
                at=float(native), orders=orders, written=Written(motor.name, slots, motor.pole_pairs, orders),
            )  # fmt: skip


@dataclass(frozen=True)
class Orders:
    """Cosine and sine of the rotor's angle at each order."""

    orders: tuple[float, ...]

    def __call__(self, run: ImposedRun) -> Floats:
        """Return the columns of a run, shape (samples, 2 orders)."""
        return np.column_stack([wave(order * run.position) for order in self.orders for wave in (np.cos, np.sin)])


@dataclass(frozen=True)
class Written:
    """The part of fitted sizes: the effort is the opposite of the torque."""

    at: str
    slots: int
    pole_pairs: int
    orders: tuple[float, ...]

    def __call__(self, sizes: Floats) -> tuple[Part, ...]:
        """Return the cogging part."""
        torque = {int(o): -(sizes[2 * i] - 1j * sizes[2 * i + 1]) for i, o in enumerate(self.orders)}
        part = mechanisms.Cogging(
            name="cogging", at=self.at, slots=self.slots, pole_pairs=self.pole_pairs,
            phases={order: float(np.angle(size)) for order, size in torque.items()},
        )  # fmt: skip
        return (part.with_amplitudes({order: float(abs(size)) for order, size in torque.items()}),)


def _highest(run: ImposedRun) -> float:
    return BAND * run.rate * 2 * pi / max(float(np.median(np.abs(run.speed))), 1e-9)
