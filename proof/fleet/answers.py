"""Sealed answers of a fleet rig: due verdict, effects with size and places, set-up faults, true numbers and laws."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from proof.fleet.counting import Shown
from proof.fleet.draw import FleetCase
from proof.fleet.effect import Effect


def effect_answer(effect: Effect, one: Shown, *, in_library: bool = True) -> dict[str, Any]:
    """Return one effect: name, part, true parameters, size at the sensor [N m], places and likelihood ratio [nats]."""
    return {
        "mechanism": effect.kind,
        "in_library": in_library,
        "part": effect.part,
        "parameters": effect.parameters(),
        "size_Nm": one.size,
        "places": [place.as_dict() for place in effect.places()],
        "nats": round(one.nats, 2),
        "counts": one.counts,
    }


def answer_of(
    case: FleetCase, *, set_name: str, outside: Sequence[str] = (), setup: Sequence[dict[str, Any]] = ()
) -> dict[str, Any]:
    """Return the answer of a case; effects of the kinds ``outside`` are in no library."""
    rig, design = case.rig, case.rig.design
    effects = [
        effect_answer(effect, one, in_library=effect.kind not in outside)
        for effect, one in zip(rig.effects, case.shown, strict=True)
    ]
    counted = [effect for effect in effects if effect["counts"]]
    if any(not effect["in_library"] for effect in counted):
        verdict = "unexplained"
    elif counted:
        verdict = "missing_physics"
    else:
        verdict = "setup_error" if setup else "adequate"
    return {
        "set": set_name,
        "verdict": verdict,
        "effects": effects,
        "setup": list(setup),
        "rig": {
            "motor": design.motor_kind, "drive": design.drive, "load": design.load_kind, "plan": rig.plan,
            "angle": design.angle, "sample_rate_Hz": design.sample_rate, "rated_torque_Nm": design.scale.torque,
            "ratio": design.ratio,
        },
        "turns_per_output_turn": design.shafts(),
        "sensor": {"volts_per_Nm": float(design.parts[design.sensor]["sensitivity"].split()[0]),
                   "gain_error": rig.gain_error, "zero_Nm": rig.zero},
        "speed_error": rig.speed_error,
        "true_over_stated": rig.numbers(),
        "laws": vars(rig.laws),
    }  # fmt: skip
