"""A finding on a rig under measured motion, in the contract's words: parameters with intervals, and the sentence."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import exp, pi
from typing import Any

from torquerig.diagnosis.choosing.confidence import confidence
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.friction import viscous_at, without_peak
from torquerig.diagnosis.motion.friction_peak import dry_beside
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.tried import Step, Tried
from torquerig.diagnosis.outcome import Finding, Stated

_95 = 1.96
_ALIKE = 0.12  # a rival within this share of the winner's gain cannot be told from it
_ORDER_WIDTH = 0.01
_NAMES: Mapping[str, Mapping[str, tuple[str, str, str]]] = {  # field: name, unit where it turns, unit in a line
    "quadratic_drag": {"coefficient": ("coefficient_Nms2", "N m s^2/rad^2", "N s^2/m^2")},
    "sensor_drift": {"span": ("span_V", "N m", "N"), "time_constant": ("time_constant_s", "s", "s")},
    "torsional_mode": {
        "frequency": ("frequency_Hz", "Hz", "Hz"),
        "inertia": ("inertia_kgm2", "kg m^2", "kg"),
        "damping_ratio": ("damping_ratio", "1", "1"),
    },
}
_VARIANT = {
    "by_direction": "dry and viscous friction that depend on the direction",
    "stribeck": "dry friction with a larger static than sliding friction",
    "stribeck_by_direction": "dry friction with a larger static than sliding friction, which depends on the direction",
    "lugre": "dry friction with presliding deformation (LuGre)",
    "native": "cogging torque at its native order {order_motor:.0f}",
    "tolerances": "cogging torque at order {order_motor:.0f}, with the orders of unequal teeth and magnets",
    "linear": "a drift of the sensor zero",
    "exponential": "a drift of the sensor zero with a time constant of {time_constant_s:.3g} s",
}
_SIZES = (
    "coulomb_Nm", "coulomb_Nm_forward", "coulomb_Nm_backward", "gap_arcmin", "gap_m", "amplitude_Nm", "amplitude_V",
    "span_V", "coefficient_Nms2", "inertia_kgm2", "frequency_Hz",
)  # fmt: skip
_PLAIN = {
    "stribeck_friction": "dry friction",
    "mains_interference": "mains interference",
    "backlash": "backlash in {joint}",
    "quadratic_drag": "quadratic drag",
    "torsional_mode": "a torsional mode: a further inertia on a spring",
}


def finding(step: Step, final: FittedMotion, runs: Sequence[Moved]) -> Finding:
    """Return what is said of a step that was kept, with the numbers of the final model."""
    kept, candidate = step.kept, step.kept.candidate
    others: dict[str, float] = {}
    for one in step.tried:
        if one.candidate.mechanism != candidate.mechanism:
            others.setdefault(one.candidate.mechanism, one.gain)
    share = 1 - (1 - kept.fall) ** 2
    parameters = identifying(step, final, runs)
    listed = tuple(sorted(others.items(), key=lambda item: -item[1]))
    return Finding(
        mechanism=candidate.mechanism, variant=candidate.variant,
        explanation=_sentence(kept, parameters, share, listed),
        confidence=confidence(gain=kept.gain, share=share, rival=max(others.values(), default=0.0)),
        parameters=parameters, gain=kept.gain, alternatives=listed,
        equivalent_to=tuple(name for name, gain in listed if gain > (1 - _ALIKE) * kept.gain),
    )  # fmt: skip


def identifying(step: Step, final: FittedMotion, runs: Sequence[Moved]) -> dict[str, Stated]:
    """Return the contract's parameters of an effect in the final model; in a line their units are N and m."""
    candidate, line = step.kept.candidate, in_a_line(runs)
    part: Any = final.rig.part(candidate.parts[0].name)
    torque = "N" if line else "N m"
    if candidate.mechanism == "stribeck_friction":
        return _friction(part, final, torque, line)
    if candidate.mechanism == "backlash":
        name, factor, unit = ("gap_m", 1.0, "m") if line else ("gap_arcmin", 60 * 180 / pi, "arcmin")
        return {name: _stated(final, part.name, "gap", part.gap, unit, factor=factor)}
    if candidate.mechanism == "cogging":
        return _cogging(part, final, runs)
    if candidate.mechanism == "mains_interference":
        hum = _stated(final, part.name, "frequency", part.frequency, "Hz")
        unit, factor = _as_read(runs, torque)
        size = _stated(final, part.name, "amplitudes", part.amplitudes[0], unit, key=0, factor=factor)
        return {"frequency_Hz": hum, "amplitude_V": size}
    answer = {}
    for field, (name, turning, moving) in _NAMES[candidate.mechanism].items():
        value, unit, factor = getattr(part, field), moving if line else turning, 1.0
        if value is None:
            continue
        if name.endswith("_V"):
            unit, factor = _as_read(runs, unit)
        answer[name] = _stated(final, part.name, field, value, unit, factor=factor)
    return answer


def _as_read(runs: Sequence[Moved], unit: str) -> tuple[str, float]:
    """Return volts, and how many one of ``unit`` is, where the effort was read in volts; else the unit itself."""
    channel = runs[0].channel
    return ("V", 1 / abs(channel.si_per_unit)) if channel.unit == "V" else (unit, 1.0)


def _friction(part: Any, final: FittedMotion, torque: str, line: bool) -> dict[str, Stated]:
    drag = viscous_at(final.rig, part.at)
    slope = "N s/m" if line else "N m s/rad"
    answer: dict[str, Stated] = {}
    ways = ("forward", "backward") if part.coulomb_backward is not None else ("",)
    peaked = without_peak(part, final.knobs) is part
    beside = dry_beside(final.rig, part)
    for way in ways:
        back, end = "_backward" if way == "backward" else "", f"_{way}" if way else ""
        dry = _stated(final, part.name, f"coulomb{back}", getattr(part, f"coulomb{back}"), torque)
        holds = _stated(final, part.name, f"static{back}", getattr(part, f"static{back}"), torque) if peaked else dry
        dry, holds = (_more(one, beside[way == "backward"]) for one in (dry, holds))
        answer |= {f"coulomb_Nm{end}": dry, f"static_Nm{end}": holds}
        if peaked:
            falls = _stated(final, part.name, "stribeck_speed", part.stribeck_speed, "m/s" if line else "rad/s")
            answer[f"stribeck_rad_s{end}"] = falls
        whole, own = drag[way == "backward"], "viscous_backward" if way == "backward" else "viscous"
        if whole > 0:
            known = [(knob.part, knob.field) for knob in final.knobs]
            rows = ((part.name, own), (part.name, "viscous"), (part.at, own), (part.at, "viscous"))
            owner, field = next((row for row in rows if row in known), rows[0])
            answer[f"viscous_Nms{end}"] = _stated(final, owner, field, whole, slope)
    if hasattr(part, "stiffness"):
        answer["stiffness"] = _stated(
            final, part.name, "stiffness", part.stiffness, torque + ("/m" if line else "/rad")
        )
    return answer


def _cogging(part: Any, final: FittedMotion, runs: Sequence[Moved]) -> dict[str, Stated]:
    sizes = part.amplitudes()
    largest = max(sizes, key=lambda at: sizes[at])
    field, key = part.held_by(largest)
    answer = {
        "order_motor": Stated(value=largest, low=largest - _ORDER_WIDTH, high=largest + _ORDER_WIDTH, unit="1/rev")
    }
    answer["amplitude_Nm"] = _stated(final, part.name, field, sizes[largest], "N m", key=key)
    channel = runs[0].channel
    if channel.unit == "A":
        answer["amplitude_A"] = _stated(
            final, part.name, field, sizes[largest], "A", key=key, factor=1 / abs(channel.si_per_unit)
        )
    return answer


def _stated(
    final: FittedMotion, part: str, field: str, value: float, unit: str, *, key: object = None, factor: float = 1.0
) -> Stated:
    value *= factor
    for index, knob in enumerate(final.knobs):
        if (knob.part, knob.field, knob.key) == (part, field, key):
            reach = _95 * final.sigma(index) * knob.spread
            if knob.factor:
                return Stated(value=value, low=value * exp(-reach), high=value * exp(reach), unit=unit)
            return Stated(value=value, low=value - reach * factor, high=value + reach * factor, unit=unit)
    return Stated(value=value, low=value, high=value, unit=unit)


def _more(stated: Stated, by: float) -> Stated:
    """Return a number with so much added that other parts of the same shaft make."""
    return replace(stated, value=stated.value + by, low=stated.low + by, high=stated.high + by)


def _sentence(kept: Tried, parameters: Mapping[str, Stated], share: float, rivals: Sequence[tuple[str, float]]) -> str:
    candidate = kept.candidate
    what = _VARIANT.get(candidate.variant) or _PLAIN.get(candidate.mechanism, candidate.mechanism.replace("_", " "))
    values = {name: stated.value for name, stated in parameters.items()}
    joint = getattr(candidate.parts[0], "gear", "")
    said = f"The model lacks {what.format(joint=joint, **values)}{_sizes(parameters)}."
    beside = f"With {kept.beside.replace('_', ' ')} in the model, it" if kept.beside else "It"
    said += f" {beside} explains {100 * share:.0f} % of the remaining squared residual."
    helping = [(name, gain) for name, gain in rivals if gain > 0]
    if not helping:
        return f"{said} No other mechanism of the library reduces it."
    name, gain = helping[0]
    return f"{said} The best alternative, {name.replace('_', ' ')}, has {100 * gain / kept.gain:.0f} % of its gain."


def _sizes(parameters: Mapping[str, Stated]) -> str:
    """Return the parameters that state how large an effect is, with units, in brackets."""
    stated = {name: parameters[name] for name in _SIZES if name in parameters}
    ways = {name: f" {name.rpartition('_')[2]}" for name in stated if name.endswith(("_forward", "_backward"))}
    sizes = [f"{one.value:.3g} {one.unit}{ways.get(name, '')}" for name, one in stated.items()]
    return f" ({', '.join(sizes)})" if sizes else ""


def relative_error(model: FittedMotion, runs: Sequence[Moved], *, held: bool = True) -> float:
    """Return the rms residual over the rms effort, of what was held out or of what fits saw [1]."""
    masks = [run.held if held else run.seen for run in runs]
    effort = [run.effort[mask] for run, mask in zip(runs, masks, strict=True) if mask.any()]
    return root_mean_square(model.of(runs, held=held)) / root_mean_square(effort)
