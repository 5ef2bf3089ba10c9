"""A catalog motor with ripple calculated from its phases: ``ripple: from_phase_level`` in a scenario."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from torquerig.catalog.entry import estimates
from torquerig.catalog.motor import Motor
from torquerig.catalog.phases import sample_phases
from torquerig.errors import InputError, did_you_mean
from torquerig.scenario.catalog_values.filled import Filled, FromCatalog
from torquerig.scenario.catalog_values.from_catalog import sample_of
from torquerig.units import written_quantity

SOURCES = ("from_catalog", "from_phase_level")
UNITS = {
    "phase_resistance": "ohm",
    "phase_inductance": "H",
    "flux_linkage": "V*s",
    "dc_link": "V",
    "flat_angle": "rad",
}
PHASES = (
    "rated_current", "torque_constant", "phase_resistance", "phase_inductance", "emf_flat_angle", "emf_fifth",
    "dead_time", "supply_voltage",
)  # fmt: skip
"""Fields of a motor's file that the phases depend on."""


def is_from_phase_level(written: object, place: str) -> bool:
    """Return whether ``ripple:`` of a motor is ``from_phase_level``; InputError for another word."""
    if written not in SOURCES:
        raise InputError(f"{place}: {written!r} is no source of a ripple; {did_you_mean(str(written), SOURCES)}")
    return written == "from_phase_level"


def with_phase_level(filled: Filled, motor: Motor, *, seed: int) -> Filled:
    """Return the motor with its phases and their commutation in place of the six-pulse line of its class.

    Known lines of other orders, cogging and the class's lines of the current sensors stay. An induction motor has no
    commutation: it keeps the lines of its class.

    Raises
    ------
    InputError
        When resistance, inductance or torque constant are unknown.
    """
    if motor.kind == "induction":
        text = "lines of its class: an induction motor has no commutation"
        return replace(filled, assumed={**filled.assumed, "ripple": text})
    sample = sample_of(motor, seed)
    phases = sample_phases(sample, seed)
    pairs = sample.count("pole_pairs")
    values: dict[str, Any] = {field: written_quantity(value, UNITS[field]) for field, value in phases.values.items()}
    values |= {"kind": "motor_phases", "motor": filled.name, "pole_pairs": pairs}
    if "current_loop_bandwidth" in filled.values:
        values["current_loop_bandwidth"] = filled.values["current_loop_bandwidth"]
    if phases.fifth:
        values["emf_harmonics"] = {5: phases.fifth}
    kept = tuple(effect for effect in filled.effects if effect.values.get("order_motor") != 6 * pairs)
    stated = {key: text for key, text in filled.assumed.items() if key != "ripple.six_pulse_ripple"}
    taken = {key: one for key, one in filled.taken.items() if key != "ripple.six_pulse_ripple"}
    known, maker = dict(estimates(motor)), motor.stands_for or motor.name
    taken |= {
        key: FromCatalog(entry=maker, field=key, known=known[key], used=sample.values[key])
        for key in PHASES
        if key in sample.values
    }
    return replace(
        filled,
        assumed=stated,
        taken=taken,
        effects=(
            *kept,
            Filled(name=f"{filled.name}.phases", values=values, assumed=phases.assumed),
            _commutation(filled.name, motor, sample.values.get("dead_time", 0.0)),
        ),
    )


def _commutation(name: str, motor: Motor, dead_time: float) -> Filled:
    """Return the effect of the phase-level model, with its source in words."""
    if motor.kind == "bldc":
        text = "from the phase-level model at the set-point: six-step commutation, no line put in"
        return Filled(
            name=f"{name}.commutation", values={"kind": "six_step_commutation", "at": name}, assumed={"lines": text}
        )
    known = motor.dead_time
    text = "from the phase-level model at the set-point: field-oriented control, no line put in"
    assumed = {"lines": text}
    if dead_time:
        assumed["dead_time"] = f"{dead_time * 1e6:.2g} us of {known.shown()} ({known.evidence})"
    values = {"kind": "field_oriented_control", "at": name, "dead_time": written_quantity(dead_time, "s")}
    return Filled(name=f"{name}.commutation", values=values, assumed=assumed)
