"""A diagnosis in sentences."""

from __future__ import annotations

from dataclasses import replace

import pytest

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut, Mismatch
from torquerig.reporting.diagnosis.sentences import EFFORT, chance_text, kind_text, place_text, verdict_sentence

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


def test_one_finding_is_one_sentence() -> None:
    said = verdict_sentence(BASE, ())
    assert said == (
        "The model lacks gear mesh; with it the misfit on data that no fit has seen falls from 8 to 1.05, where a true "
        "model has about 1."
    )


def test_under_measured_motion_an_error_falls_in_per_cent() -> None:
    fit = HeldOut(nominal=0.9, before=0.67, after=0.055, improvement=(0.9, 0.8, 0.95))
    said = verdict_sentence(replace(BASE, fit=fit), (), yardstick=EFFORT)
    assert said.endswith("with it the error on data that no fit has seen falls from 67 % to 5.5 % of the effort.")
    fine = verdict_sentence(replace(BASE, fit=fit, verdict="adequate", findings=()), (), yardstick=EFFORT)
    open_end = verdict_sentence(replace(BASE, fit=fit, verdict="unexplained"), (), yardstick=EFFORT)
    assert open_end.endswith("what speaks against the model stands at no place, but in the remarks.")
    assert fine.endswith("the model's error on data that no fit has seen is 67 % of the effort.")


def test_what_cannot_be_told_is_in_the_sentence() -> None:
    alike = replace(BASE, findings=(replace(MESH, equivalent_to=("pwm_aliasing",)),))
    assert "gear mesh (or pwm aliasing, which these recordings cannot tell)" in verdict_sentence(alike, ())


def test_two_findings_are_named_together() -> None:
    both = replace(BASE, findings=(MESH, replace(MESH, mechanism="quadratic_drag")))
    assert verdict_sentence(both, ()).startswith("The model lacks gear mesh and quadratic drag; with them the misfit")


def test_nothing_missing_is_said_with_the_misfit() -> None:
    said = verdict_sentence(replace(BASE, verdict="adequate", findings=()), ())
    assert said.startswith("Nothing is missing that these recordings can show")
    assert "is 8," in said


def test_the_unexplained_is_located_and_never_named() -> None:
    alone = verdict_sentence(replace(BASE, verdict="unexplained", findings=()), (TONE,))
    assert alone == (
        "Something is missing that no mechanism of the library explains: what is left stands at 281.12 Hz."
    )
    beside = verdict_sentence(replace(BASE, verdict="unexplained"), (TONE,))
    assert beside.startswith("The model lacks gear mesh, and the misfit")
    assert beside.endswith("no mechanism of the library explains the rest: what is left stands at 281.12 Hz.")


@pytest.mark.parametrize(
    ("mismatch", "where", "kind"),
    [
        (place("order", "output_shaft", 84, 0.1), f"at order 84 {OUTPUT}", f"periodic in the angle {OUTPUT}"),
        (place("order", "motor_shaft", 6, 0.02), f"at order 6 {MOTOR}", f"periodic in the angle {MOTOR}"),
        (TONE, "at 281.12 Hz", "fixed in frequency"),
        (place("frequency", "Hz", 100.0, 50.0), "from 80 to 130 Hz", "a band of the spectrum"),
        (place("speed", "rpm", 3.0, 10.0), "in the slow torque at 3 rpm", "goes with the speed"),
        (place("speed", "m/s", -0.125, 0.01), "in the mean force at -0.125 m/s", "goes with the speed"),
        (place("order", "cycles/m", 399.69, 4.0), "at 399.69 cycles/m of the motion", "periodic in the position"),
        (place("level", "m", 0.0462, 0.03), "where the motion passes 0.0462 m", "comes again at a place of the stroke"),
    ],
)  # fmt: skip
def test_a_place_is_said_in_neutral_terms(mismatch: Mismatch, where: str, kind: str) -> None:
    assert place_text(mismatch) == where
    assert kind_text(mismatch) == kind


def test_a_chance_is_stated_down_to_a_bound() -> None:
    assert chance_text(0.02) == "0.02"
    assert chance_text(1e-40) == "< 1e-12"
