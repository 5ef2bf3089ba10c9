"""Why a mechanism proposes nothing: the one plain reason that its own condition gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.parts import Body, Motor
from torquerig.rig.parts.gear_stage import gear_stages

_NO_PART = "the rig has no loaded part"


def why_none(name: str, case: Case) -> str:
    """Return why the mechanism ``name`` of the library had nothing to propose for what is left."""
    return _REASONS[name](case)


def _orders_left(case: Case) -> bool:
    return any(peak.place.domain == "order" for peak in case.left)


def _gear_mesh(case: Case) -> str:
    if not gear_stages(case.nominal):
        return "the rig has no gear"
    return (
        "no unexplained line at a whole order of a gear's output"
        if _orders_left(case)
        else "no unexplained line at any order"
    )


def _commutation_ripple(case: Case) -> str:
    if not case.nominal.parts_of(Motor):
        return "the rig has no motor"
    return (
        "no unexplained line at a whole order of the motor"
        if _orders_left(case)
        else "no unexplained line at any order"
    )


def _cogging(case: Case) -> str:
    if not any(motor.slots and motor.pole_pairs for motor in case.nominal.parts_of(Motor)):
        return "the scenario does not state slots and poles of the motor"
    return "no unexplained line at an order that slots and poles allow"


def _blade_pass(case: Case) -> str:
    if loaded_part(case.nominal) is None:
        return _NO_PART
    return (
        "no unexplained line at a whole order of the loaded part"
        if _orders_left(case)
        else "no unexplained line at any order"
    )


def _mains_interference(case: Case) -> str:
    return "no unexplained line at a multiple of 50 or 60 Hz that is independent of the speed"


def _pwm_aliasing(case: Case) -> str:
    return "no unexplained line of constant frequency above the mechanical range"


def _torsional_mode(case: Case) -> str:
    body = loaded_part(case.nominal)
    hung = body is not None and isinstance(case.nominal.part(body), Body)
    return "no further inertia on a spring fits the residual" if hung else "the rig has no body to attach it to"


def _sensor_bandwidth(case: Case) -> str:
    sensor = case.nominal.part(case.nominal.measured)
    return (
        "no lower cut-off frequency fits the residual"
        if isinstance(sensor, AmplifiedTorqueSensor)
        else "the sensor of the rig has no amplifier"
    )


def _bearing_defect(case: Case) -> str:
    if loaded_part(case.nominal) is None:
        return _NO_PART
    return "no frequency band above 400 Hz rings periodically with a shaft"


def _quadratic_drag(case: Case) -> str:
    return _NO_PART if loaded_part(case.nominal) is None else "the recordings do not differ in speed"


def _slow(case: Case) -> str:
    return _NO_PART if loaded_part(case.nominal) is None else "no residual of the slow torque requires it"


_REASONS: Mapping[str, Callable[[Case], str]] = {
    "gear_mesh": _gear_mesh,
    "commutation_ripple": _commutation_ripple,
    "cogging": _cogging,
    "blade_pass": _blade_pass,
    "mains_interference": _mains_interference,
    "pwm_aliasing": _pwm_aliasing,
    "torsional_mode": _torsional_mode,
    "sensor_bandwidth": _sensor_bandwidth,
    "bearing_defect": _bearing_defect,
    "quadratic_drag": _quadratic_drag,
    "stribeck_friction": _slow,
    "sensor_drift": _slow,
}
