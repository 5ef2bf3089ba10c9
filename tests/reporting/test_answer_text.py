"""The answer of a diagnosis on the terminal: what is missing, how large, how sure, what next, in at most 15 lines."""

from __future__ import annotations

from typing import Any

import pytest

from torquerig.reporting.diagnosis.answer_text import MOST_LINES, answer_lines, nameless_text


def finding(name: str = "gear_mesh", **more: Any) -> dict[str, Any]:
    size = {"value": 0.12, "ci95": [0.11, 0.13], "unit": "N*m"}
    return {
        "mechanism": name,
        "confidence": 0.97,
        "parameters": {"amplitude_Nm": size},
        "next_experiment": None,
        **more,
    }


def diagnosis(**more: Any) -> dict[str, Any]:
    return {"verdict": "missing_physics", "findings": [finding()], "next_experiment": None, **more}


def test_the_answer_says_what_how_large_how_sure_and_what_next() -> None:
    rms = {"unit": "N*m", "before": 1.69, "after": 0.44}
    lines = answer_lines(diagnosis(rms=rms), verdict="The model lacks gear mesh.")
    assert lines[0] == "The model lacks gear mesh."
    assert lines[1] == "Rms residual on held-out data: 1.69 N m before, 0.44 N m after."
    assert lines[2] == "- gear mesh, 97 % sure: amplitude_Nm 0.12 (0.11 to 0.13) N m"
    assert lines[3].startswith("Next: check the named part on the rig")


def test_the_next_run_is_that_of_the_diagnosis() -> None:
    data = diagnosis(findings=[finding(next_experiment="Record a ramp to 1500 rpm.")])
    assert answer_lines(data, verdict="x")[-1] == "Next: Record a ramp to 1500 rpm."


@pytest.mark.parametrize("verdict", ["adequate", "missing_physics", "setup_error", "unexplained"])
def test_every_verdict_has_a_next_step(verdict: str) -> None:
    assert answer_lines(diagnosis(verdict=verdict, findings=[]), verdict="x")[1].startswith("Next: ")


def test_set_up_facts_and_effects_without_a_name_are_in_the_answer() -> None:
    value = {"value": 2.0, "ci95": [1.98, 2.02], "unit": "1"}
    setup = [{"kind": "sensor_scale", "of": "torque_sensor", "stated": 1.0, "estimated": value, "confidence": 0.9}]
    size = {"value": 0.3, "ci95": [0.2, 0.4], "unit": "N*m"}
    unnamed = [
        {"kind": "tone", "axis": "Hz", "at": 77.0, "size": size, "minor": minor, "confidence": 0.99}
        for minor in (False, True)
    ]
    rms = {"unit": "N*m", "before": 1.69, "after": 0.44}
    lines = answer_lines(diagnosis(setup=setup, unnamed=unnamed, rms=rms), verdict="x")
    assert lines[1] == "Rms residual on held-out data: 1.69 N m before, 0.44 N m after."
    assert "- sensor scale of torque_sensor: stated 1.0, estimated 2 (1.98 to 2.02); 90 % sure" in lines
    assert sum("no name: tone at 77 Hz, 0.3 (0.2 to 0.4) N m" in line for line in lines) == 1


def test_a_long_answer_keeps_its_end_and_says_where_the_others_are() -> None:
    lines = answer_lines(diagnosis(findings=[finding()] * 30), verdict="x", remarks=["a remark"] * 5)
    assert len(lines) == MOST_LINES
    assert lines[-1].startswith("Next: ") or "--model" in lines[-1]
    assert sum("--report" in line for line in lines) == 2, "of findings, and of remarks"


@pytest.mark.parametrize(
    ("kind", "axis", "at", "wanted"),
    [
        ("line_family", "motor_shaft", 12.0, "line family at order 12 of the motor shaft"),
        ("level_course", "time", 0.0, "a function of the time"),
        ("other", "speed", 0.0, "a function of the speed"),
        ("line_family", "cycles/m", 399.791, "line family at 399.791 cycles/m"),
    ],
)
def test_a_nameless_effect_has_a_place_only_where_it_is_at_one(kind, axis, at, wanted):
    assert nameless_text({"kind": kind, "axis": axis, "at": at}) == wanted


def test_a_fact_without_an_interval_and_what_looks_the_same() -> None:
    value = {"value": -16384.0, "ci95": [-16384.0, -16384.0], "unit": "1/rev"}
    fact = {"kind": "counts_per_rev", "of": "encoder", "stated": 16384.0, "estimated": value, "confidence": 0.99,
            "equivalent_to": ["sensor_sign"]}  # fmt: skip
    lines = answer_lines(diagnosis(setup=[fact]), verdict="x")
    assert (
        "- counts per rev of encoder: stated 16384.0, estimated -16384 1/rev; 99 % sure; the same could be sensor sign"
    ) in lines
