"""A diagnosis in sentences."""

from __future__ import annotations

from dataclasses import replace

import pytest

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut, Mismatch
from torquerig.reporting.diagnosis.sentences import (
    MOTION_RESIDUAL,
    kind_text,
    p_value_text,
    place_text,
    verdict_sentence,
)

FIT = HeldOut(nominal=9.0, before=8.0, after=1.05, improvement=(0.87, 0.8, 0.9))
MESH = Finding(mechanism="gear_mesh", variant="", explanation="", confidence=0.9, parameters={}, gain=100.0)
BASE = Diagnosis(verdict="missing_physics", mismatch=(), findings=(MESH,), fit=FIT, recordings=())


def place(domain: str, axis: str, at: float, width: float) -> Mismatch:
    return Mismatch(
        domain=domain, axis=axis, at=at, width=width, recordings=("a",), excess_dB=20.0, share_of_misfit=0.5,
        p_value=1e-9,
    )  # fmt: skip


OUTPUT, MOTOR = "of the output shaft", "of the motor shaft"
TONE = place("frequency", "Hz", 281.12, 0.02)


def test_one_finding_is_named_with_the_fall_of_the_residual() -> None:
    said = verdict_sentence(BASE, ())
    assert said == (
        "The model lacks gear mesh. With it, the mean squared standardised residual on held-out data falls from 8 to "
        "1.05. A true model has about 1."
    )


def test_under_measured_motion_the_residual_falls_in_per_cent() -> None:
    fit = HeldOut(nominal=0.9, before=0.67, after=0.055, improvement=(0.9, 0.8, 0.95))
    said = verdict_sentence(replace(BASE, fit=fit), (), measure=MOTION_RESIDUAL)
    assert said.endswith(
        "With it, the rms residual on held-out data falls from 67 % to 5.5 % of the measured torque or force."
    )
    fine = verdict_sentence(replace(BASE, fit=fit, verdict="adequate", findings=()), (), measure=MOTION_RESIDUAL)
    open_end = verdict_sentence(replace(BASE, fit=fit, verdict="unexplained"), (), measure=MOTION_RESIDUAL)
    assert open_end.endswith("No single place shows the remaining residual; see the remarks.")
    assert fine.endswith("the rms residual on held-out data is 67 % of the measured torque or force.")


def test_an_equivalent_mechanism_is_in_the_sentence() -> None:
    alike = replace(BASE, findings=(replace(MESH, equivalent_to=("pwm_aliasing",)),))
    assert "gear mesh (or pwm aliasing; these recordings do not distinguish them)" in verdict_sentence(alike, ())


def test_two_findings_are_named_together() -> None:
    both = replace(BASE, findings=(MESH, replace(MESH, mechanism="quadratic_drag")))
    assert verdict_sentence(both, ()).startswith("The model lacks gear mesh and quadratic drag. With them, the mean")


def test_an_adequate_model_is_reported_with_its_residual() -> None:
    said = verdict_sentence(replace(BASE, verdict="adequate", findings=()), ())
    assert said.startswith("No physics is missing that these recordings can show.")
    assert "is 8." in said


def test_the_unexplained_is_located_and_never_named() -> None:
    alone = verdict_sentence(replace(BASE, verdict="unexplained", findings=()), (TONE,))
    assert alone == (
        "Something is missing that no mechanism of the library explains. "
        "The largest remaining residual is at 281.12 Hz."
    )
    beside = verdict_sentence(replace(BASE, verdict="unexplained"), (TONE,))
    assert beside.startswith("The model lacks gear mesh. With it, the mean")
    assert beside.endswith(
        "No mechanism of the library explains the rest. The largest remaining residual is at 281.12 Hz."
    )


@pytest.mark.parametrize(
    ("mismatch", "where", "kind"),
    [
        (place("order", "output_shaft", 84, 0.1), f"at order 84 {OUTPUT}", f"periodic in the angle {OUTPUT}"),
        (place("order", "motor_shaft", 6, 0.02), f"at order 6 {MOTOR}", f"periodic in the angle {MOTOR}"),
        (TONE, "at 281.12 Hz", "line of constant frequency"),
        (place("frequency", "Hz", 100.0, 50.0), "from 80 to 130 Hz", "frequency band"),
        (place("speed", "rpm", 3.0, 10.0), "in the slow torque at 3 rpm", "depends on the speed"),
        (place("speed", "m/s", -0.125, 0.01), "in the mean force at -0.125 m/s", "depends on the speed"),
        (place("order", "cycles/m", 399.69, 4.0), "at 399.69 cycles/m of the motion", "periodic in the position"),
        (place("time", "s", 3.25, 0.1), "at time 3.25 s", "transient"),
        (place("distribution", "V", 0.0, 0.05), "in the distribution of values at 0 V", "distribution of values"),
        (place("level", "m", 0.0462, 0.03), "at position 0.0462 m", "repeats at a position of the stroke"),
    ],
)  # fmt: skip
def test_a_place_is_said_in_neutral_terms(mismatch: Mismatch, where: str, kind: str) -> None:
    assert place_text(mismatch) == where
    assert kind_text(mismatch) == kind


def test_a_p_value_has_a_lower_bound() -> None:
    assert p_value_text(0.02) == "0.02"
    assert p_value_text(1e-40) == "< 1e-12"


@pytest.mark.parametrize(("count", "end"), [(2, "Hz, and at one other place."), (3, "Hz, and at 2 other places.")])
def test_further_places_are_counted(count: int, end: str) -> None:
    assert verdict_sentence(replace(BASE, verdict="unexplained"), (TONE,) * count).endswith(end)
