"""The referee's judgement of hand-written diagnoses."""

import json

import pytest

from proof.errors import ProofError
from proof.referee.claims import claim_of, read_claim
from proof.referee.figures import figures_of, unchanged
from proof.referee.judging import judged
from proof.referee.page import chapters_of, reason, write_page

MESH = {
    "mechanism": "gear_mesh", "in_library": True, "part": "gearbox", "counts": True, "nats": 40.0, "size_Nm": 0.1,
    "parameters": {"order_output": 57.0, "transmission_error_rad": 1e-4},
    "places": [{"domain": "order", "axis": "output_shaft", "at": 57.0, "width": 0.01}],
}  # fmt: skip
LINE = {
    "mechanism": "irrational_order", "in_library": False, "part": "drum", "counts": True, "nats": 90.0, "size_Nm": 0.2,
    "parameters": {"at": 3.2, "size": 0.2},
    "places": [{"domain": "order", "axis": "output_shaft", "at": 3.2, "width": 0.01}],
}  # fmt: skip


def answer(*effects, verdict, setup=(), name="FLEET", change=""):
    return {"set": name, "verdict": verdict, "effects": list(effects), "setup": list(setup), "change": change,
            "rig": {"drive": "belt", "plan": "several"},
            "turns_per_output_turn": {"output_shaft": 1.0, "motor_shaft": 4.0, "stage_1": 2.0}}  # fmt: skip


def finding(mechanism, confidence=0.9, equivalent_to=(), **parameters):
    rows = {name: {"value": value, "ci95": ci95, "unit": "1"} for name, (value, ci95) in parameters.items()}
    return {"mechanism": mechanism, "confidence": confidence, "equivalent_to": list(equivalent_to), "parameters": rows}


def said(verdict, *findings, **more):
    fit = {"before": {"heldout_misfit": 5.0}, "after": {"heldout_misfit": 1.2}}
    return claim_of({"verdict": verdict, "findings": list(findings), "fit": fit} | more)


def test_the_right_name_and_verdict_is_exact_and_its_size_is_measured():
    row = finding("gear_mesh", order_output=(57.0, [56.9, 57.1]), transmission_error_rad=(1.1e-4, [0.9e-4, 1.3e-4]))
    one = judged("a", answer(MESH, verdict="missing_physics"), said("missing_physics", row))
    assert one.exact
    assert one.confidences == ((0.9, True),)
    (size,) = one.sizes  # the order is a place, not a size
    assert (size.error, size.covered) == (pytest.approx(0.1), True)
    assert size.half_width == pytest.approx(0.2)


def test_a_name_that_is_not_there_is_false_whatever_else_is_right():
    one = judged(
        "a", answer(MESH, verdict="missing_physics"), said("missing_physics", finding("gear_mesh"), finding("cogging"))
    )
    assert not one.exact
    assert one.false_names == ("cogging",)
    assert one.confidences == ((0.9, True), (0.9, False))
    assert reason(one) == "false: cogging"


def test_an_alternative_counts_as_the_name():
    one = judged(
        "a",
        answer(MESH, verdict="missing_physics"),
        said("missing_physics", finding("cogging", equivalent_to=["gear_mesh"])),
    )
    assert one.exact
    listed = {
        "mechanism": "cogging",
        "confidence": 0.7,
        "equivalent_to": [{"mechanism": "gear_mesh"}],
        "parameters": {},
    }
    assert judged("a", answer(MESH, verdict="missing_physics"), said("missing_physics", listed)).exact


def test_an_effect_that_does_not_count_may_be_named_or_not():
    faint = MESH | {"counts": False}
    truth = answer(faint, verdict="adequate")
    assert judged("a", truth, said("adequate")).exact
    assert judged("a", truth, said("missing_physics", finding("gear_mesh"))).exact
    assert judged("a", truth, said("missing_physics", finding("backlash"))).false_names == ("backlash",)
    assert not judged("a", truth, said("unexplained")).exact
    assert judged("a", truth, said("unexplained")).accused is None  # the rig has an effect


def test_a_missed_effect_and_no_answer_are_wrong():
    assert judged("a", answer(MESH, verdict="missing_physics"), said("adequate")).missed == ("gear_mesh",)
    silent = judged("a", answer(MESH, verdict="missing_physics"), None, why_not="torquerig: no such file\n")
    assert not silent.exact
    assert reason(silent) == "torquerig: no such file"


@pytest.mark.parametrize(
    ("more", "right"),
    [
        ({"mismatch": [{"domain": "order", "axis": "output_shaft", "at": 3.21, "width": 0.0}]}, True),
        ({"mismatch": [{"domain": "order", "axis": "motor_shaft", "at": 0.8, "width": 0.0}]}, True),
        ({"mismatch": [{"domain": "order", "axis": "stage_1", "at": 1.6, "width": 0.0}]}, True),
        ({"mismatch": [{"domain": "order", "axis": "output_shaft", "at": 3.4, "width": 0.01}]}, False),
        ({"mismatch": [{"domain": "frequency", "axis": "Hz", "at": 3.2, "width": 0.0}]}, False),
        ({"mismatch": [{"domain": "order", "axis": "output_shaft", "at": 9.0, "width": 20.0}]}, False),
        ({"unnamed": [{"kind": "line_family", "axis": "output_shaft", "at": 1.6, "harmonics": [1, 2]}]}, True),
        (
            {"unnamed": [{"kind": "line_family", "axis": "output_shaft", "at": 3.2, "harmonics": [1], "minor": True}]},
            True,
        ),
        ({"unnamed": [{"kind": "tone", "axis": "Hz", "at": 3.2}]}, False),
        ({}, False),
    ],
)
def test_a_stranger_is_located_in_its_domain_and_at_its_place(more, right):
    one = judged("a", answer(LINE, verdict="unexplained", name="STRANGERS"), said("unexplained", **more))
    assert one.located is right
    assert one.exact  # no name, and the verdict
    assert one.modelled  # 5.0 to 1.2: 95 % of the excess over 1


@pytest.mark.parametrize(("axis", "right"), [("rpm", True), ("s", False)])
def test_a_course_over_the_speed_is_in_the_domain_of_speed(axis, right):
    kink = {**LINE, "places": [{"domain": "speed", "axis": "rpm", "at": 30.0, "width": 0.2}]}
    course = {"unnamed": [{"kind": "level_course", "axis": axis, "at": 29.0}]}
    truth = answer(kink, verdict="unexplained", name="STRANGERS")
    assert judged("a", truth, said("unexplained", **course)).located is right


def test_a_model_that_keeps_the_excess_is_none():
    truth = answer(LINE, verdict="unexplained")
    same = {"before": {"heldout_misfit": 5.0}, "after": {"heldout_misfit": 4.0}}
    assert judged("a", truth, claim_of({"verdict": "unexplained", "fit": same})).modelled is False


def test_a_set_up_fault_is_reported_by_its_kind_or_class():
    fact = {"kind": "gear_ratio", "of": "gearbox", "stated": 3.0, "true": 3.2, "also": ["teeth"]}
    truth = answer(verdict="setup_error", setup=[fact], name="SET-UP")

    def setup(kind, **more):
        row = {"kind": kind, "of": "x", "estimated": {"value": 3.2, "ci95": [3.1, 3.3]}, "confidence": 0.9}
        return said("setup_error", setup=[row | more])

    assert judged("a", truth, setup("gear_ratio")).exact
    assert judged("a", truth, setup("teeth")).setup_reported
    assert judged("a", truth, setup("sensor_scale", equivalent_to=[{"kind": "gear_ratio"}])).setup_reported
    assert judged("a", truth, setup("sensor_scale")).setup_reported is False
    assert judged("a", truth, said("unexplained")).setup_reported is False  # a diagnosis without that key


def test_a_clean_rig_is_accused_by_a_verdict_or_a_name():
    truth = answer(verdict="adequate", name="CLEAN")
    assert judged("a", truth, said("adequate")).accused is False
    assert judged("a", truth, said("unexplained")).accused is True
    assert judged("a", truth, said("adequate")).clean_chi_square == 5.0


def test_a_change_that_must_not_matter_is_compared_with_the_rig_as_it_is():
    truth = answer(MESH, verdict="missing_physics", name="INVARIANCE", change="as_is")
    plain = judged("inv-00-as_is", truth, said("missing_physics", finding("gear_mesh")))
    same = judged("inv-00-sign", truth | {"change": "sign"}, said("missing_physics", finding("gear_mesh", 0.7)))
    other = judged("inv-00-speed_x4", truth | {"change": "speed_x4"}, said("adequate"))
    rows = [plain, same, other]
    assert [unchanged(one, rows) for one in rows] == [None, True, False]
    assert figures_of("INVARIANCE", rows).unchanged.hits == 1


def test_figures_have_exact_bounds():
    rows = [judged(str(i), answer(verdict="adequate", name="CLEAN"), said("adequate")) for i in range(59)]
    figures = figures_of("CLEAN", rows)
    assert figures.accused.hits == 0
    assert figures.accused.upper == pytest.approx(0.0495, abs=5e-4)  # 1 - 0.05^(1/59)
    assert figures.chi_square == 5.0
    assert figures.located.trials == 0


def test_the_page_lists_every_wrong_case_and_the_table_every_case(tmp_path):
    truth = answer(verdict="adequate", name="CLEAN")
    rows = [judged("right", truth, said("adequate")), judged("wrong", truth, said("unexplained", finding("clipping")))]
    written = write_page(tmp_path, rows, command="python -m proof fleet", seal="abc")
    text = written.markdown.read_text(encoding="utf-8")
    assert "| wrong | adequate |" in text
    assert "| right | adequate |" not in text
    assert "1 of 2 (<= 97 %)" in text  # Clopper and Pearson, one of two
    assert len(written.csv.read_text(encoding="utf-8").splitlines()) == 3
    assert "clipping" in written.html.read_text(encoding="utf-8")
    titles = [title for title, _ in chapters_of([figures_of("CLEAN", rows)], rows)]
    assert titles[0].startswith("Shares")


def test_a_file_that_is_no_diagnosis_is_refused_by_name(tmp_path):
    path = tmp_path / "x.json"
    path.write_text(json.dumps({"verdict": "perhaps"}))
    with pytest.raises(ProofError, match=r"x\.json.*perhaps"):
        read_claim(path)
