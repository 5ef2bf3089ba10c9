"""Dry friction: the same both ways, by direction, with a larger static value, with presliding."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, start_of
from torquerig.inference.knobs import Knob
from torquerig.inference.motion.fitted_model import Fit, effort_scale
from torquerig.inference.motion.hypotheses.shown import carrier, fitted_runs, least_squares, stroke, top_speed
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis
from torquerig.rig.assembly import Part
from torquerig.rig.imposed_part import imposed_part

_SIZE = 0.1  # of the rms effort: median of the prior of a friction that nobody knows, a decade wide
_SMOOTHED = {
    True: 2e-3,
    False: 0.1,
}  # of the top speed, by whether the part is imposed: a sharp sign behind a spring is stiff
_NO_PEAK = 1e-6  # of the top speed: a Stribeck speed that no sample sees
_FALLS, _HOLDS = 0.05, 1.5  # of the top speed; times the sliding friction
_BEND = 0.03  # of the stroke: median of the presliding, a decade wide
_DAMPED = 2e-3  # [s] damping over stiffness of the bristles
_LABELS = {
    "": "dry friction", "by_direction": "dry friction that depends on the direction",
    "stribeck": "dry friction with a larger static than sliding value",
    "stribeck_by_direction": "dry friction with a larger static than sliding value, by direction",
    "lugre": "dry friction with presliding deformation (LuGre)",
    "lugre_by_direction": "dry friction with presliding deformation (LuGre), by direction",
}  # fmt: skip


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield the variants at the last part that has an inertia, without the variant that the model has."""
    at, imposed = carrier(fit.model.nominal), imposed_part(fit.model.nominal)
    if at is None or imposed is None:
        return
    present = {(each.name, each.variant) for each in fit.model.additions}
    direct = fit.model.nominal.node(at) == fit.model.nominal.node(imposed.at)
    for each in _variants(fit, at, direct=direct):
        if (each.name, each.variant) not in present:
            yield each


def _variants(fit: Fit, at: str, *, direct: bool) -> Iterator[Hypothesis]:
    median, top = _SIZE * effort_scale(fit.runs), top_speed(fit)
    (ahead, back), (drag_ahead, drag_back) = _shown(fit, at)
    stated = any(part.kind == "stribeck_friction" and getattr(part, "at", "") == at for part in fit.model.nominal.parts)
    slope = median / top
    part = mechanisms.StribeckFriction(
        name=f"friction_{at}", at=at, coulomb=median, static=median, stribeck_speed=_NO_PEAK * top, viscous=slope,
        smoothing=_SMOOTHED[direct] * top,
    )  # fmt: skip
    soft = {"smoothing": 0.0} if direct else {}
    mean = start_of(0.5 * (ahead + back), median)
    sides = start_of(ahead, median), start_of(back, median)
    drags = start_of(drag_ahead, slope), start_of(drag_back, slope)
    both: dict[str, Any] = {"coulomb_backward": median, "static_backward": median}
    viscous: dict[str, Any] = {"viscous_backward": slope}
    yield _made(part, {"coulomb": mean, "viscous": start_of(0.5 * (drag_ahead + drag_back), slope)} | soft, "")
    one_way = {"coulomb": sides[0], "coulomb_backward": sides[1], "viscous": drags[0], "viscous_backward": drags[1]}
    one_way |= soft
    turning = _turns_back(fit)
    if turning:
        yield _made(replace(part, **both, **viscous), one_way, "by_direction")
    if direct and not stated:
        holds = replace(part, stribeck_speed=_FALLS * top, static=_HOLDS * median)
        yield _made(holds, {"coulomb": mean, "static": mean, "stribeck_speed": 0.0,
                            "viscous": start_of(0.5 * (drag_ahead + drag_back), slope)} | soft, "stribeck")  # fmt: skip
    if not turning:
        return
    stiffness = max(0.5 * (ahead + back), 0.1 * median) / (_BEND * stroke(fit))
    bristles = mechanisms.LugreFriction(
        name=part.name, at=at, coulomb=median, static=median, stribeck_speed=_NO_PEAK * top, stiffness=stiffness,
        damping=_DAMPED * stiffness, viscous=slope,
    )  # fmt: skip
    same = {"coulomb": mean, "stiffness": 0.0, "damping": 0.0, "viscous": drags[0]}
    yield _made(bristles, same, "lugre")
    ways = {"coulomb": sides[0], "coulomb_backward": sides[1], "stiffness": 0.0, "damping": 0.0,
            "viscous": drags[0]}  # fmt: skip
    yield _made(replace(bristles, **both), ways, "lugre_by_direction")


def _made(part: Part, starts: dict[str, float], variant: str) -> Hypothesis:
    spread = {"stribeck_speed": 1.0, "smoothing": 1.0, "stiffness": DECADE}
    return Hypothesis(
        name=part.name, mechanism="stribeck_friction", variant=variant, label=f"{_LABELS[variant]} at {part.at}",  # type: ignore[attr-defined]
        parts=(part,), knobs=tuple(Knob(part.name, field, spread.get(field, DECADE)) for field in starts),
        start=tuple(starts.values()), log_odds=MECHANISM,
    )  # fmt: skip


def _turns_back(fit: Fit) -> bool:
    """Return whether a twentieth of the motion goes the other way."""
    speed = np.concatenate([run.speed[run.samples_of(run.seen)] for run in fit.runs])
    return bool(0.05 < np.mean(speed[np.abs(speed) > 0.05 * np.abs(speed).max()] > 0) < 0.95)


def _shown(fit: Fit, at: str) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return dry and viscous friction forward and backward by a regression, with those of a present friction."""
    columns = []
    for run, _ in fitted_runs(fit):
        ahead = run.speed > 0
        columns.append(np.column_stack([ahead, ~ahead * -1.0, ahead * run.speed, ~ahead * run.speed]))
    found = [max(float(value), 0.0) for value in least_squares(fit, columns)]
    for part in fit.rig.parts:
        if part.name == f"friction_{at}":
            held: Any = part
            forth, back = held.coulomb, held.coulomb_backward
            found = [found[0] + forth, found[1] + (forth if back is None else back), found[2] + held.viscous,
                     found[3] + held.viscous]  # fmt: skip
    return (found[0], found[1]), (found[2], found[3])
