"""The phases of a drawn motor: resistance, inductance, flux linkage, back-EMF and DC link, and what was assumed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import exp, log, pi, sqrt

from torquerig.catalog.drawing import Drawn
from torquerig.catalog.motor import Motor
from torquerig.errors import InputError
from torquerig.parameter import Estimate
from torquerig.recordings.recording import random_for
from torquerig.units import in_unit

VOLTAGE_RESERVE = 1.1  # DC link over what the largest speed needs at rated torque, where no supply is stated
WOUND = ("phase_resistance", "phase_inductance", "torque_constant")  # all grow with the number of turns
TURNS = "one number of turns for resistance, inductance and torque constant"


@dataclass(frozen=True)
class DrawnPhases:
    """One possible copy of the phases.

    Parameters
    ----------
    values : mapping of str to float
        By field of the part ``motor_phases`` [SI]; without ``flat_angle`` the back-EMF is a sine.
    fifth : float
        Fifth harmonic of the back-EMF [1], 0 where the shape is a trapezoid or nothing is stated.
    assumed : mapping of str to str
        What no document states: the value taken and where it comes from, by field.
    """

    values: Mapping[str, float]
    fifth: float
    assumed: Mapping[str, str]


def drawn_phases(copy: Drawn[Motor], seed: int) -> DrawnPhases:
    """Return the phases of a motor under six-step commutation (kind bldc) or field-oriented control (pmsm).

    Resistance, inductance and torque constant are intervals over windings of many and of few turns. They are drawn
    with one rank, because more turns raise all three; independent draws would make motors that do not exist. Where no
    supply is stated, the DC link is what the largest speed needs at rated torque, and a tenth more: the number of turns
    then drops out of the ripple.

    Raises
    ------
    InputError
        When the file states nothing of one of the three, or the motor has no magnets.
    """
    motor = copy.entry
    if motor.kind == "induction":
        raise InputError(f"{motor.name}: an induction motor has no back-EMF of magnets; leave from_phase_level out")
    rank = float(random_for(seed, f"{motor.stands_for or motor.name}.turns").uniform())
    wound, assumed = {}, {}
    for field in WOUND:
        known: Estimate = getattr(motor, field)
        if known.unknown:
            raise InputError(
                f"{motor.name}: nothing is known of {field}, which from_phase_level needs; state low and high with "
                "their evidence in its file"
            )
        wound[field] = known.value if known.documented and known.value is not None else _at(known, rank)
        if not known.documented:
            shown = f"{in_unit(wound[field], known.unit):.3g} {known.unit} of {known.shown()} ({known.evidence})"
            assumed[field] = f"{shown}, {TURNS}"
    pairs = copy.count("pole_pairs")
    flux = wound["torque_constant"] / (2 * pairs if motor.kind == "bldc" else 1.5 * sqrt(2) * pairs)
    if "torque_constant" in assumed:
        assumed["flux_linkage"] = f"{flux:.3g} V*s, from a torque constant of {assumed.pop('torque_constant')}"
    link, source = _dc_link(copy, wound["phase_resistance"], flux)
    shape, fifth, said = _shape(copy)
    return DrawnPhases(
        values={
            "phase_resistance": wound["phase_resistance"],
            "phase_inductance": wound["phase_inductance"],
            "flux_linkage": flux,
            "dc_link": link,
            **shape,
        },
        fifth=fifth,
        assumed={**assumed, "dc_link": source, **said},
    )


def _at(known: Estimate, rank: float) -> float:
    """Return the value at a rank 0..1 of the interval, log-uniform where the catalog's rule says so."""
    low, high = known.bounds
    return exp(log(low) + rank * log(high / low)) if low > 0 and high / low > 5 else low + rank * (high - low)


def _dc_link(copy: Drawn[Motor], resistance: float, flux: float) -> tuple[float, str]:
    """Return the DC link [V]: the supply's peak, or what the largest speed needs at rated torque with a reserve."""
    if "supply_voltage" in copy.values:
        link = sqrt(2) * copy.value("supply_voltage")
        return link, f"{link:.0f} V, the rectified peak of {copy.entry.supply_voltage.shown()}"
    pairs, speed, torque = copy.count("pole_pairs"), copy.value("max_speed"), copy.value("rated_torque")
    across = 2.0 if copy.entry.kind == "bldc" else sqrt(3)
    per_ampere = pairs * flux * (2.0 if copy.entry.kind == "bldc" else 1.5)
    link = VOLTAGE_RESERVE * across * (flux * pairs * speed + resistance * torque / per_ampere)
    return link, f"{link:.3g} V, a tenth more than {speed * 30 / pi:.0f} rpm needs at rated torque; no supply is stated"


def _shape(copy: Drawn[Motor]) -> tuple[dict[str, float], float, dict[str, str]]:
    field = "emf_flat_angle" if copy.entry.kind == "bldc" else "emf_fifth"
    known: Estimate = getattr(copy.entry, field)
    if known.unknown:
        return {}, 0.0, {"emf_harmonics": "none: the file states nothing of the back-EMF's shape"}
    value = copy.value(field)
    if field == "emf_fifth":
        return {}, value, {"emf_harmonics": f"fifth {value:.2%} of {known.shown()} ({known.evidence})"}
    return (
        {"flat_angle": value},
        0.0,
        {"flat_angle": f"{value * 180 / pi:.0f} deg of {known.shown()} ({known.evidence})"},
    )
