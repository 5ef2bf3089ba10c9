"""Findings and residuals of a diagnosis as values, from its JSON."""

from __future__ import annotations

from math import isnan

from torquerig.api.diagnosis_values import finding_of, mismatch_of, residual_of

ROW = {
    "mechanism": "gear_mesh", "part": "gearbox", "explanation": "The model lacks a gear mesh.", "confidence": 0.97,
    "parameters": {
        "amplitude_Nm": {"value": 0.2, "ci95": [0.1, 0.3], "unit": "N*m"},
        "order_output": {"value": 84.0, "ci95": None, "unit": "1/rev"},
    },
    "equivalent_to": ["tooth_mesh"], "next_experiment": "Record one more run.",
}  # fmt: skip


def test_a_finding_has_its_parameters_with_their_intervals():
    found = finding_of(ROW)
    size, place = found.parameters["amplitude_Nm"], found.parameters["order_output"]
    assert (size.value, size.low, size.high, size.unit) == (0.2, 0.1, 0.3, "N*m")
    assert isnan(place.low)
    assert (found.mechanism, found.variant, found.equivalent_to) == ("gear_mesh", "", ("tooth_mesh",))
    assert found.next_experiment == "Record one more run."


def test_a_residual_without_anything_to_improve_has_no_improvement():
    fit = {"metric": "", "before": {"heldout_misfit": 1.1, "nominal": 3.0}, "after": {"heldout_misfit": 1.0}}
    assert residual_of({**fit, "improvement": None}).improvement is None
    fell = residual_of({**fit, "improvement": {"value": 0.5, "ci95": [0.4, 0.6]}})
    assert (fell.nominal, fell.before, fell.after, fell.improvement) == (3.0, 1.1, 1.0, (0.5, 0.4, 0.6))


def test_a_place_keeps_the_names_of_its_recordings():
    row = {
        "domain": "order", "axis": "output_shaft", "at": 84.0, "width": 0.1, "recordings": ["a", "b"],
        "excess_dB": 20.0, "share_of_misfit": 0.5, "p_value": 1e-9,
    }  # fmt: skip
    assert mismatch_of(row).recordings == ("a", "b")
