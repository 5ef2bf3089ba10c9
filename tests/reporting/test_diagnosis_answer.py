"""The first screen of a diagnosis, from its JSON: each verdict, both engines."""

import pytest

from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.page_answer import diagnosis_answer
from torquerig.reporting.diagnosis.sentences import fact_text

FIT = {"before": {"heldout_misfit": 4.0, "nominal": 5.0}, "after": {"heldout_misfit": 0.9}}
MESH = {"mechanism": "gear_mesh", "confidence": 0.97, "equivalent_to": [], "next_experiment": None, "parameters": {}}
SCALE = {
    "kind": "sensor_scale", "of": "torque_sensor", "stated": 1.0, "confidence": 0.97, "equivalent_to": [],
    "estimated": {"value": 2.0, "ci95": [1.98, 2.02], "unit": "1"},
}  # fmt: skip


def data(verdict, *findings, **more):
    return {"verdict": verdict, "findings": list(findings), "fit": FIT, "next_experiment": None, **more}


def words_of(answer):
    return max(len(one.split()) for text in answer.sentences for one in text.split(". "))


def test_what_is_missing_how_large_how_sure_and_what_next_in_this_order():
    answer = diagnosis_answer(data("missing_physics", MESH), percent=False)
    assert answer.sentences == (
        "The model lacks gear mesh.",
        "How sure: 97 % for gear mesh.",
        "Next: check the named part on the rig, and continue with the completed scenario.",
    )
    assert [one.value for one in answer.figures] == ["not computed", "97 %", "4 to 0.9"]


@pytest.mark.parametrize("verdict", ["adequate", "unexplained"])
def test_a_verdict_without_findings_says_what_to_do(verdict):
    answer = diagnosis_answer(data(verdict), percent=True)
    assert answer.sentences[-1].startswith("Next: ")
    assert answer.figures[0].value == "none"
    assert answer.figures[2].value == "400 %"
    assert words_of(answer) <= 25


@pytest.mark.parametrize(
    ("orders", "said"),
    [
        ((4.0,), "at order 4 of the motor shaft."),
        ((4.0, 7.0, 9.0, 11.0), "at order 4 of the motor shaft, at order 7 of the motor shaft and 2 more."),
    ],
)
def test_an_adequate_answer_says_which_small_residuals_are_left(orders, said):
    rows = [{"domain": "order", "axis": "motor_shaft", "at": order, "width": 0.01, "recordings": ["a.parquet"],
             "excess_dB": 9.0, "share_of_misfit": 0.1, "p_value": 1e-6} for order in orders]  # fmt: skip
    first = diagnosis_answer(data("adequate", mismatch=rows), percent=False).sentences[0]
    assert first == f"No physics of relevant size is missing. A small residual is left: {said}"


def test_a_wrong_set_up_fact_and_a_residual_in_newton_metres_come_from_the_second_engine():
    rms = {"unit": "N*m", "before": 1.69, "after": 0.44}
    answer = diagnosis_answer(data("setup_error", setup=[SCALE], rms=rms), percent=False)
    assert answer.sentences[0] == "A set-up fact is wrong: sensor scale of torque_sensor is 2, stated is 1."
    assert answer.sentences[1] == "The residual on held-out data falls from 1.69 to 0.44 N m rms."
    assert answer.sentences[-1].startswith("Next: correct the named fact")


def test_what_cannot_be_distinguished_is_said_and_a_long_run_is_left_to_its_section():
    long = "Record " + " ".join(["one more run"] * 20)
    alike = {**MESH, "equivalent_to": ["tooth_mesh"], "next_experiment": long}
    answer = diagnosis_answer(data("missing_physics", alike), percent=False)
    assert "How sure: 97 % for gear mesh; these recordings do not distinguish it from tooth mesh." in answer.sentences
    assert answer.sentences[-1] == "Next: record the run that the section Findings names."
    assert words_of(answer) <= 25


def test_the_first_sentence_states_place_and_size_of_what_is_missing():
    found = {"order_output": {"value": 84.0, "unit": "1/rev"}, "amplitude_Nm": {"value": 0.05394, "unit": "N*m"}}
    gap = {**MESH, "mechanism": "backlash", "parameters": {"gap_arcmin": {"value": 6.1, "unit": "arcmin"}}}
    answer = diagnosis_answer(data("missing_physics", {**MESH, "parameters": found}, gap), percent=False)
    assert answer.sentences[0] == (
        "The model lacks gear mesh (84 per output turn, 0.0539 N m) and backlash (6.1 arcmin)."
    )
    assert words_of(answer) <= 25
    alone = diagnosis_answer(data("missing_physics", {**MESH, "parameters": found}), percent=False)
    assert alone.sentences[0] == "The model lacks gear mesh (84 per output turn, 0.0539 N m)."


def test_many_findings_are_counted():
    many = [{**MESH, "mechanism": name} for name in ("a", "b", "c", "d", "e")]
    assert diagnosis_answer(data("missing_physics", *many), percent=False).sentences[0] == (
        "The model lacks a, b, c and 2 more."
    )


def test_a_wrong_number_is_called_by_its_name_and_another_fact_by_its_kind():
    assert fact_text({"kind": "parameter", "of": "motor.inertia"}) == "motor.inertia"
    assert fact_text({"kind": "sensor_scale", "of": "flange"}) == "sensor scale of flange"


def test_without_a_simulation_the_largest_finding_states_the_change_of_the_reading():
    small = {**MESH, "mechanism": "cogging", "size": {"value": 0.01, "unit": "N*m"}}
    large = {**MESH, "size": {"value": 0.2, "unit": "N*m"}}
    figure = diagnosis_answer(data("missing_physics", small, large), percent=False).figures[0]
    assert (figure.value, figure.note) == ("0.2 N m", "rms, by gear mesh")


def test_the_first_screen_of_a_measured_motion_states_the_error_and_a_residual_in_per_cent():
    rms = {"unit": "N", "before": 3.0, "after": 0.5}
    shown = first_screen(data("missing_physics", MESH, rms=rms, unnamed=[]), percent=True)
    assert "The error on held-out data changes from 3 to 0.5 N rms." in shown.sentences
    assert [one.value for one in shown.figures] == ["3 to 0.5 N", "97 %", "400 % to 90 %"]
