"""Cogging: lines over the rotor's angle at orders that slots and magnets allow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import lcm

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.lines import Line, lines_in
from torquerig.diagnosis.motion.moved import Moved
from torquerig.inference.knobs import Knob
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import Motor

_HIGHEST = 3  # times the native order
_PHASE_SPREAD = 0.1  # [rad]


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield cogging of the motor that is moved: its native order alone, and with every tolerance order that shows."""
    imposed = imposed_part(model.rig)
    motor = model.rig.part(imposed.at) if imposed else None
    if not isinstance(motor, Motor) or motor.slots is None or motor.pole_pairs is None:
        return
    if not hasattr(mechanisms, "Cogging") or model.rig.of_kind("cogging"):
        return
    poles = 2 * motor.pole_pairs
    native = lcm(motor.slots, poles)
    orders = [order for order in map(_whole, lines_in(model.residuals, runs)) if order is not None]
    allowed = [k for k in dict.fromkeys(orders) if _allowed(k, motor.slots, poles) and k <= _HIGHEST * native]
    if native in allowed:
        yield _cogging(model, runs, motor, [native], "native")
    if allowed and allowed != [native]:
        yield _cogging(model, runs, motor, allowed, "tolerances")


def _allowed(order: int, slots: int, poles: int) -> bool:
    return order > 0 and (order % slots == 0 or order % poles == 0)


def _whole(line: Line) -> int | None:
    near = round(line.at)
    return near if line.domain == "order" and abs(line.at - near) < max(line.width, 0.05) else None


def _cogging(
    model: FittedMotion, runs: Sequence[Moved], motor: Motor, orders: Sequence[int], variant: str
) -> Candidate:
    """Sizes and phases by least squares: what the motion takes is the torque's opposite."""
    angle = np.concatenate([run.position[run.seen] for run in runs])
    left = np.concatenate([residual[run.seen] for residual, run in zip(model.residuals, runs, strict=True)])
    columns = [wave(order * angle) for order in orders for wave in (np.cos, np.sin)]
    found = np.linalg.lstsq(np.column_stack([*columns, np.ones(angle.size)]), left, rcond=None)[0]
    sizes = {order: -(found[2 * i] - 1j * found[2 * i + 1]) for i, order in enumerate(orders)}
    slots, poles = int(motor.slots or 0), 2 * int(motor.pole_pairs or 0)
    part = mechanisms.Cogging(
        name="cogging", at=motor.name, slots=slots, pole_pairs=poles // 2,
        phases={order: float(np.angle(size)) for order, size in sizes.items()},
    ).with_amplitudes({order: float(abs(size)) for order, size in sizes.items()})  # fmt: skip
    knobs = [Knob(part.name, field, 0.3, key=key) for field, key in map(part.held_by, orders)]
    knobs += [Knob(part.name, "phases", _PHASE_SPREAD, key=order, factor=False) for order in orders]
    return Candidate(mechanism="cogging", parts=(part,), knobs=tuple(knobs), variant=variant)
