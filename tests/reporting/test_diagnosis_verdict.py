"""The verdict of the first engine in sentences."""

from __future__ import annotations

from dataclasses import replace

import pytest

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.rules.sentences import verdict_sentence
from torquerig.reporting.diagnosis.sentences import MOTION_RESIDUAL

FIT = HeldOut(nominal=9.0, before=8.0, after=1.05, improvement=(0.87, 0.8, 0.9))
MESH = Finding(mechanism="gear_mesh", variant="", explanation="", confidence=0.9, parameters={}, gain=100.0)
BASE = Diagnosis(verdict="missing_physics", mismatch=(), findings=(MESH,), fit=FIT, recordings=())


def place(domain: str, axis: str, at: float, width: float) -> Mismatch:
    return Mismatch(
        domain=domain, axis=axis, at=at, width=width, recordings=("a",), excess_dB=20.0, share_of_misfit=0.5,
        p_value=1e-9,
    )  # fmt: skip


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
    both = verdict_sentence(replace(BASE, verdict="unexplained"), (TONE,))
    assert both.startswith("The model lacks gear mesh. With it, the mean")
    assert both.endswith(
        "No mechanism of the library explains the rest. The largest remaining residual is at 281.12 Hz."
    )


@pytest.mark.parametrize(("count", "end"), [(2, "Hz, and at one other place."), (3, "Hz, and at 2 other places.")])
def test_further_places_are_counted(count: int, end: str) -> None:
    assert verdict_sentence(replace(BASE, verdict="unexplained"), (TONE,) * count).endswith(end)
