"""Places, kinds and p-values of a diagnosis in words."""

from __future__ import annotations

import pytest

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.sentences import kind_text, p_value_text, place_text


def place(domain: str, axis: str, at: float, width: float) -> Mismatch:
    return Mismatch(
        domain=domain, axis=axis, at=at, width=width, recordings=("a",), excess_dB=20.0, share_of_misfit=0.5,
        p_value=1e-9,
    )  # fmt: skip


OUTPUT, MOTOR = "of the output shaft", "of the motor shaft"
TONE = place("frequency", "Hz", 281.12, 0.02)


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
