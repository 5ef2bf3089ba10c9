"""Phases of a sampled motor: resistance, inductance, flux linkage, back-EMF and DC link, with the assumptions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import exp, log, pi, sqrt

from torquerig.catalog.chosen_draws import draws_of
from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import Sample
from torquerig.errors import InputError
from torquerig.parameter import Estimate
from torquerig.units import in_unit

VOLTAGE_RESERVE = 1.1  # [1] DC link over the need of the largest speed at rated torque, if no supply is stated
WOUND = ("phase_resistance", "phase_inductance", "torque_constant")  # all grow with the number of turns
TURNS = "one number of turns for resistance, inductance and torque constant"


@dataclass(frozen=True)
class PhaseSample:
    """One Monte Carlo sample of the phases.

    Parameters
    ----------
    values : mapping of str to float
        By field of the part ``motor_phases`` [SI]; without ``flat_angle`` the back-EMF is a sine.
    fifth : float
        Fifth harmonic of the back-EMF [1], 0 where the shape is a trapezoid or nothing is stated.
    assumed : mapping of str to str
        Values that no document states, with their source, by field.
    """

    values: Mapping[str, float]
    fifth: float
    assumed: Mapping[str, str]


def sample_phases(sample: Sample[Motor], seed: int) -> PhaseSample:
    """Return the phases of a motor under six-step commutation (kind bldc) or field-oriented control (pmsm).

    Resistance, inductance and torque constant are intervals over windings of many and of few turns. They are sampled
    with one common rank, because more turns increase all three; independent samples would give motors that do not
    exist. Without a stated supply, the DC link is 10 % above the need of the largest speed at rated torque; the ripple
    then does not depend on the number of turns.

    Raises
    ------
    InputError
        When the file states nothing of one of the three, or the motor has no magnets.
    """
    motor = sample.entry
    if motor.kind == "induction":
        raise InputError(f"{motor.name}: an induction motor has no back-EMF of magnets; remove from_phase_level")
    rank = float(draws_of(seed, f"{motor.stands_for or motor.name}.turns").uniform())
    wound, assumed = {}, {}
    for field in WOUND:
        known: Estimate = getattr(motor, field)
        if known.unknown:
            raise InputError(
                f"{motor.name}: {field} is unknown, but from_phase_level needs it; state low and high with "
                "their evidence in its file"
            )
        wound[field] = known.value if known.documented and known.value is not None else _at(known, rank)
        if not known.documented:
            shown = f"{in_unit(wound[field], known.unit):.3g} {known.unit} of {known.shown()} ({known.evidence})"
            assumed[field] = f"{shown}, {TURNS}"
    pairs = sample.count("pole_pairs")
    flux = wound["torque_constant"] / (2 * pairs if motor.kind == "bldc" else 1.5 * sqrt(2) * pairs)
    if "torque_constant" in assumed:
        assumed["flux_linkage"] = f"{flux:.3g} V*s, from a torque constant of {assumed.pop('torque_constant')}"
    link, source = _dc_link(sample, wound["phase_resistance"], flux)
    shape, fifth, notes = _shape(sample)
    return PhaseSample(
        values={
            "phase_resistance": wound["phase_resistance"],
            "phase_inductance": wound["phase_inductance"],
            "flux_linkage": flux,
            "dc_link": link,
            **shape,
        },
        fifth=fifth,
        assumed={**assumed, "dc_link": source, **notes},
    )


def _at(known: Estimate, rank: float) -> float:
    """Return the value at a rank 0..1 of the interval, log-uniform where high/low > 5."""
    low, high = known.bounds
    return exp(log(low) + rank * log(high / low)) if low > 0 and high / low > 5 else low + rank * (high - low)


def _dc_link(sample: Sample[Motor], resistance: float, flux: float) -> tuple[float, str]:
    """Return the DC link [V]: the supply's peak, or the need of the largest speed at rated torque with a reserve."""
    if "supply_voltage" in sample.values:
        link = sqrt(2) * sample.value("supply_voltage")
        return link, f"{link:.0f} V, the rectified peak of {sample.entry.supply_voltage.shown()}"
    pairs, speed, torque = sample.count("pole_pairs"), sample.value("max_speed"), sample.value("rated_torque")
    across = 2.0 if sample.entry.kind == "bldc" else sqrt(3)
    per_ampere = pairs * flux * (2.0 if sample.entry.kind == "bldc" else 1.5)
    link = VOLTAGE_RESERVE * across * (flux * pairs * speed + resistance * torque / per_ampere)
    return link, f"{link:.3g} V, 10 % above the need of {speed * 30 / pi:.0f} rpm at rated torque; no supply is stated"


def _shape(sample: Sample[Motor]) -> tuple[dict[str, float], float, dict[str, str]]:
    field = "emf_flat_angle" if sample.entry.kind == "bldc" else "emf_fifth"
    known: Estimate = getattr(sample.entry, field)
    if known.unknown:
        return {}, 0.0, {"emf_harmonics": "none: the file does not state the shape of the back-EMF"}
    value = sample.value(field)
    if field == "emf_fifth":
        return {}, value, {"emf_harmonics": f"fifth {value:.2%} of {known.shown()} ({known.evidence})"}
    return (
        {"flat_angle": value},
        0.0,
        {"flat_angle": f"{value * 180 / pi:.0f} deg of {known.shown()} ({known.evidence})"},
    )
