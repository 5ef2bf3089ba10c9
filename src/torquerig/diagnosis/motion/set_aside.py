"""Why a mechanism was not named on a rig under measured motion: it has no place there, or what was tried failed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from torquerig import mechanisms
from torquerig.diagnosis.motion.friction import carrier
from torquerig.diagnosis.motion.tried import Refused, Step
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import Gear, Link, Motor

CLASSES: Mapping[str, tuple[str, ...]] = {  # by the contract's name: what would state it, in the library
    "stribeck_friction": ("StribeckFriction", "LugreFriction"),
    "backlash": ("Backlash",),
    "cogging": ("Cogging",),
    "quadratic_drag": ("QuadraticDrag",),
    "sensor_drift": ("SensorDrift",),
    "torsional_mode": ("TorsionalMode",),
    "mains_interference": ("MainsInterference",),
    "clipping": ("Clipping",),
    "quantization": ("Quantization",),
    "signal_dropout": ("SignalDropout",),
}
_NO_CARRIER = "the rig has no moving part with an inertia"


def set_aside(
    nominal: Rig, steps: Sequence[Step], refused: Sequence[Refused], *, of_samples: Sequence[str] = ()
) -> dict[str, str]:
    """Return a reason for every mechanism that is looked for under measured motion and was not found.

    ``of_samples`` are those that the samples themselves showed.
    What was a rival of a finding is judged again beside all findings, so it stands here too, with that judgement.
    """
    found = [step.kept.candidate.mechanism for step in steps]
    beside = f"tested together with {' and '.join(found)}: ".replace("_", " ") if found else "tested: "
    answer: dict[str, str] = {}
    for one in refused:
        answer.setdefault(one.tried.candidate.mechanism, beside + one.why)
    for name in CLASSES:
        answer.setdefault(name, _untried(name, nominal, steps))
    return {name: why for name, why in sorted(answer.items()) if name not in (*found, *of_samples)}


def _untried(name: str, nominal: Rig, steps: Sequence[Step]) -> str:
    if not hasattr(mechanisms, CLASSES[name][0]):
        return "not in the library"
    if any(type(part).__name__ in CLASSES[name] for part in nominal.parts):
        return "the scenario already contains it"
    if any(one.candidate.mechanism == name for step in steps for one in step.tried):
        return "a finding explains the same residual, and the search for further mechanisms is complete"
    return _REASONS[name](nominal)


def _no_gap(rig: Rig) -> str:
    joined = any(isinstance(part, Gear | Link) for part in rig.parts)
    return "no backlash fits the residual" if joined else "the rig has no gear or link that could have backlash"


def _no_cogging(rig: Rig) -> str:
    imposed = imposed_part(rig)
    motor = rig.part(imposed.at) if imposed else None
    if not isinstance(motor, Motor):
        return "the moved part is not a motor"
    if motor.slots is None or motor.pole_pairs is None:
        return "the scenario does not state slots and poles of the motor"
    return "no unexplained line at an order that slots and poles allow"


def _no_carrier(rig: Rig) -> str:
    return _NO_CARRIER if carrier(rig) is None else "no residual requires it"


_REASONS: Mapping[str, Callable[[Rig], str]] = {
    "stribeck_friction": _no_carrier,
    "backlash": _no_gap,
    "cogging": _no_cogging,
    "quadratic_drag": _no_carrier,
    "sensor_drift": _no_carrier,
    "torsional_mode": _no_carrier,
    "mains_interference": lambda rig: "no line at the mains frequency",
    "clipping": lambda rig: "no samples stay at a limit, or the motion requires no more than the limit",
    "quantization": lambda rig: "the code step is small compared with the residual",
    "signal_dropout": lambda rig: "no dropouts in the samples",
}
