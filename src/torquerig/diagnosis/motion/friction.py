"""Dry friction of the part that moves: the same both ways, by direction, holding more than it slides, or bending."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.lines import moving
from torquerig.diagnosis.motion.moved import Moved
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import Body, Motor, Slide
from torquerig.rig.terms import Friction

Floats = NDArray[np.float64]

PEAKED, PEAKED_BY_DIRECTION = "stribeck", "stribeck_by_direction"
_KINDS = ("stribeck_friction", "lugre_friction")
_BOTH_WAYS = 0.05  # of the time in motion
_LEAST_PEAK = 1.05  # times what slides
_SMOOTHED, _SMOOTHED_BEHIND = 2e-3, 0.1  # of the top speed; behind a spring a sharper sign asks for tiny steps
_BENDS = (0.01, 0.05, 0.2)  # of the stroke: how far the bristles bend before they slide
_DAMPED = 2e-3  # [s] of the bristles, s1 over s0
HOLDS, FALLS = 1.5, 0.05  # times what slides; of the top speed, by which it has fallen to that
_NO_PEAK = 1e-6  # of the top speed: a Stribeck speed that no sample sees
_SHARED = 0.1
STOOD_IN = ("viscous", "viscous_backward", "coulomb")  # of a model, fitted in place of what is missing
_LEAST = 1e-3  # of the effort: where a regression finds nothing to start from


def carrier(rig: Rig) -> str | None:
    """Return the last part with an inertia, on which friction and drag are tried, or None."""
    named = [part.name for part in rig.parts if isinstance(part, Slide | Body | Motor)]
    return named[-1] if named else None


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield dry friction the same both ways, by direction, with a peak at standstill, and with presliding.

    Starting values are those of a regression.
    """
    at = carrier(model.rig)
    if at is None or not hasattr(mechanisms, "StribeckFriction") or any(p.kind in _KINDS for p in model.rig.parts):
        return
    ahead, back, drag_ahead, drag_back = _regressed(model, runs)
    top = max(float(np.abs(run.speed).max()) for run in runs)
    imposed = imposed_part(model.rig)
    direct = imposed is not None and model.rig.node(imposed.at) == model.rig.node(at)
    dry = 0.5 * (ahead + back)
    part = mechanisms.StribeckFriction(
        name="stribeck_friction", at=at, coulomb=dry, static=dry, stribeck_speed=_NO_PEAK * top,
        smoothing=(_SMOOTHED if direct else _SMOOTHED_BEHIND) * top,
    )  # fmt: skip
    viscous = () if _has_viscous(model.rig, at) else ("viscous",)
    drag: dict[str, Any] = {"viscous": 0.5 * (drag_ahead + drag_back)} if viscous else {}
    yield _candidate(replace(part, **drag), ("coulomb", *viscous), "")
    if not turns_back(runs):
        return
    both: dict[str, Any] = {"coulomb": ahead, "static": ahead, "coulomb_backward": back, "static_backward": back}
    share = _SHARED * sum(viscous_at(model.rig, at))  # where the part has some already, a share to tell them apart by
    sliding: dict[str, Any] = {"viscous": max(drag_ahead, share), "viscous_backward": max(drag_back, share)}
    ways = ("coulomb", "coulomb_backward", *sliding)
    yield _candidate(replace(part, **both, **sliding), ways, "by_direction")
    peak: dict[str, Any] = {"static": HOLDS * dry, "stribeck_speed": FALLS * top}
    yield _candidate(replace(part, **drag, **peak), ("coulomb", *peak, *viscous), PEAKED)
    peak |= {"static": HOLDS * ahead, "static_backward": HOLDS * back}
    yield _candidate(replace(part, **{**both, **sliding, **peak}), (*ways, *peak), PEAKED_BY_DIRECTION)
    if not hasattr(mechanisms, "LugreFriction"):
        return
    stroke = max(float(np.ptp(run.position)) for run in runs)
    for bend in _BENDS:
        stiffness = max(ahead, back) / (bend * stroke)
        bristles = mechanisms.LugreFriction(
            name="stribeck_friction", at=at, **both, stribeck_speed=_NO_PEAK * top, stiffness=stiffness,
            damping=_DAMPED * stiffness, **drag,
        )  # fmt: skip
        yield _candidate(bristles, ("coulomb", "coulomb_backward", "stiffness", "damping", *viscous), "lugre")


def turns_back(runs: Sequence[Moved]) -> bool:
    """Whether the motion goes both ways, for a twentieth of its time at the least, so that the two can be told."""
    speed = np.concatenate([run.speed[run.seen & moving(run)] for run in runs])
    return bool(_BOTH_WAYS < np.mean(speed > 0) < 1 - _BOTH_WAYS)


def possible(part: Part, variant: str) -> bool:
    """Whether a friction that was fitted with a peak holds more than it slides; all else is possible.

    A peak narrower than the speed over which the sign is smoothed is the sign's own shape.
    """
    if variant not in (PEAKED, PEAKED_BY_DIRECTION):
        return True
    values: Any = part
    if values.stribeck_speed < values.smoothing:
        return False
    sides = [(values.coulomb, values.static)]
    sides += [] if values.static_backward is None else [(values.coulomb_backward, values.static_backward)]
    return all(holds >= _LEAST_PEAK * slides for slides, holds in sides)


def without_peak(part: Part, knobs: Sequence[Knob]) -> Part:
    """Return a friction whose static value no knob fitted, so that no sample saw it, with the sliding one for it."""
    if part.kind not in _KINDS or any((knob.part, knob.field) == (part.name, "static") for knob in knobs):
        return part
    values: Any = part
    return cast("Part", replace(values, static=values.coulomb, static_backward=values.coulomb_backward))


def viscous_at(rig: Rig, at: str) -> tuple[float, float]:
    """Return the whole viscous friction of the shaft of ``at``, forward and backward [N m s/rad] or [N s/m]."""
    node = rig.node(at)
    terms = [term for term in rig.terms() if isinstance(term, Friction) and term.on == node]
    back = sum(t.viscous if t.viscous_backward is None else t.viscous_backward for t in terms)
    return sum(term.viscous for term in terms), back


def _has_viscous(rig: Rig, at: str) -> bool:
    return viscous_at(rig, at)[0] > 0


def _candidate(part: Part, fields: Sequence[str], variant: str) -> Candidate:
    knobs = tuple(Knob(part.name, field, 1.0) for field in fields)
    return Candidate(mechanism="stribeck_friction", parts=(part,), knobs=knobs, variant=variant, loosens=STOOD_IN)


def _regressed(model: FittedMotion, runs: Sequence[Moved]) -> tuple[float, float, float, float]:
    """Dry and viscous friction by direction that the residuals show while the part moves, none below a trace."""
    rows: list[Floats] = []
    left: list[Floats] = []
    for run, residual in zip(runs, model.residuals, strict=True):
        mask = run.seen & moving(run)
        speed = run.speed[mask]
        ahead = speed > 0
        rows.append(np.column_stack([ahead, ~ahead * -1.0, ahead * speed, ~ahead * speed]))
        left.append(residual[mask] + model.zero)
    values = np.concatenate(left)
    found = np.linalg.lstsq(np.vstack(rows), values, rcond=None)[0]
    dry = _LEAST * float(np.sqrt(np.mean(values**2)))
    quick = max(float(np.abs(run.speed).max()) for run in runs)
    ahead_dry, back_dry, ahead_drag, back_drag = (float(value) for value in found)
    return max(ahead_dry, dry), max(back_dry, dry), max(ahead_drag, dry / quick), max(back_drag, dry / quick)
