"""Scores against hand-made diagnoses whose worth is known, and against published figures."""

import json

import pytest
from click.testing import CliRunner

from proof.score import main as score
from proof.scoring.bounds import lower_bound, upper_bound
from proof.scoring.calibration import calibration_of
from proof.scoring.claims import Claim, Estimate, Finding, claim_of, read_claim
from proof.scoring.improvement import improvement_of
from proof.scoring.outcome import Outcome, TrueEffect, judge, match_findings
from proof.scoring.parameters import errors_of, figures
from proof.scoring.summary import called_unexplained, size_name, summarise
from proof.scoring.trial import trial_of
from proof.sealed import seal

MESH = TrueEffect("gear_mesh", True, 0.5, (), {"order_output": 84.0, "transmission_error_rad": 5e-5})
HUM = TrueEffect("mains_interference", True, 0.2, (), {"frequency_Hz": 50.0, "amplitude_V": 0.1})
COMB = TrueEffect("pwm_aliasing", True, 0.5, ("mains_interference",), {"frequency_Hz": 280.0})
CHIRP = TrueEffect("linear_chirp", False, 0.9, (), {"start_Hz": 400.0})


def says(verdict, *names, confidence=0.9, equivalent=()):
    return Claim(verdict, tuple(Finding(name, confidence, tuple(equivalent)) for name in names))


@pytest.mark.parametrize(
    ("due", "effects", "claim", "worth"),
    [
        ("adequate", (), says("adequate"), Outcome.EXACT),
        ("adequate", (), says("unexplained"), Outcome.UNEXPLAINED),
        ("adequate", (), says("missing_physics", "gear_mesh"), Outcome.FALSE_NAME),
        ("missing_physics", (MESH,), says("missing_physics", "gear_mesh"), Outcome.EXACT),
        (
            "missing_physics",
            (MESH,),
            says("missing_physics", "pwm_aliasing", equivalent=["gear_mesh"]),
            Outcome.IN_CLASS,
        ),
        ("missing_physics", (MESH,), says("missing_physics", "blade_pass"), Outcome.FALSE_NAME),
        ("missing_physics", (MESH,), says("adequate"), Outcome.MISSED),
        ("missing_physics", (MESH,), says("unexplained"), Outcome.UNEXPLAINED),
        ("missing_physics", (MESH,), says("unexplained", "gear_mesh"), Outcome.PARTIAL),
        ("missing_physics", (MESH, HUM), says("missing_physics", "gear_mesh"), Outcome.PARTIAL),
        ("missing_physics", (MESH, HUM), says("missing_physics", "mains_interference", "gear_mesh"), Outcome.EXACT),
        ("missing_physics", (MESH,), says("missing_physics", "gear_mesh", "gear_mesh"), Outcome.FALSE_NAME),
        ("missing_physics", (COMB,), says("missing_physics", "mains_interference"), Outcome.EXACT),
        ("unexplained", (CHIRP,), says("unexplained"), Outcome.EXACT),
        ("unexplained", (CHIRP,), says("adequate"), Outcome.MISSED),
        ("unexplained", (CHIRP,), says("missing_physics", "pwm_aliasing"), Outcome.FALSE_NAME),
        ("unexplained", (CHIRP, MESH), says("unexplained", "gear_mesh"), Outcome.EXACT),
        ("unexplained", (CHIRP, MESH), says("unexplained"), Outcome.PARTIAL),
        ("unexplained", (CHIRP, MESH), says("missing_physics", "gear_mesh"), Outcome.PARTIAL),
        ("adequate", (), None, Outcome.NO_ANSWER),
    ],
)
def test_a_diagnosis_is_worth(due, effects, claim, worth):
    assert judge(due, effects, claim) is worth


def test_a_name_is_matched_before_a_class():
    findings = (Finding("pwm_aliasing", 0.5, ("gear_mesh",)), Finding("gear_mesh", 0.9))
    matches = match_findings((MESH,), findings)
    assert [match.effect for match in matches] == [None, MESH]


def test_an_effect_in_no_library_cannot_be_named():
    assert match_findings((CHIRP,), (Finding("linear_chirp", 0.9),))[0].effect is None


def test_exact_bounds_are_the_published_ones():
    # deciding on 200 sealed cases: 190 of 200 give 0.917; no false alarm in 59 bounds their share by 5 %
    assert lower_bound(190, 200) == pytest.approx(0.917, abs=5e-4)
    assert upper_bound(0, 59) == pytest.approx(0.0495, abs=1e-3)
    assert upper_bound(0, 9) == pytest.approx(1.0 - 0.05 ** (1.0 / 9.0))
    assert lower_bound(10, 10) == pytest.approx(0.05**0.1)
    assert lower_bound(0, 10) == 0.0
    assert upper_bound(10, 10) == 1.0


def test_errors_are_relative_and_intervals_cover_or_not():
    finding = Finding(
        "gear_mesh",
        0.9,
        parameters=(
            ("order_output", Estimate(84.0, (83.99, 84.01))),
            ("transmission_error_rad", Estimate(5.5e-5, (5.2e-5, 5.8e-5))),
            ("amplitude_Nm", Estimate(1.0, None)),
        ),
    )
    errors = errors_of(match_findings((MESH,), (finding,))[0])
    assert [error.error for error in errors] == pytest.approx([0.0, 0.1])
    assert [error.covered for error in errors] == [True, False]
    assert [error.first_named for error in errors] == [True, False]
    rows = figures(errors)
    assert (rows.count, rows.median, rows.covered) == (2, pytest.approx(0.05), 0.5)
    assert figures([]) is None


def test_a_drift_is_linear_or_not():
    linear = TrueEffect("sensor_drift", True, 0.5, (), {"span_V": -0.5, "time_constant_s": None})
    for stated, error in ((None, 0.0), (3.0, 1.0)):
        finding = Finding("sensor_drift", 0.9, parameters=(("time_constant_s", Estimate(stated, None)),))
        assert errors_of(match_findings((linear,), (finding,))[0])[0].error == error


def test_a_rig_in_which_nothing_was_named_has_gained_nothing_of_the_oracles():
    row = {"mechanism": "gear_mesh", "in_library": True, "size": 0.5, "also_right": [], "parameters": {}}
    answer = {"verdict": "missing_physics", "effects": [row], "plan": "typical", "wrong_parameters": False}
    oracle = Claim("missing_physics", (), 1.0, 0.4)
    missed = trial_of("a", answer, Claim("adequate", (), 1.0, 1.0), oracle=oracle)
    named = trial_of("b", answer, Claim("missing_physics", (Finding("gear_mesh", 0.9),), 1.0, 0.4), oracle=oracle)
    assert summarise([named]).of_oracle == pytest.approx(1.0)
    assert summarise([named, missed, missed]).of_oracle == 0.0
    assert summarise([named, missed, missed]).improvement == pytest.approx(0.6)


def test_improvement_is_told_beside_the_oracles():
    claim, oracle = Claim("missing_physics", (), 1.0, 0.46), Claim("missing_physics", (), 1.0, 0.4)
    gain = improvement_of(claim, oracle)
    assert gain.share == pytest.approx(0.54)
    assert gain.of_oracle == pytest.approx(0.9)
    assert not gain.harmed
    assert improvement_of(Claim("missing_physics", (), 1.0, 1.02), None).harmed
    assert improvement_of(Claim("adequate"), None) is None


def test_calibration_is_zero_where_nine_in_ten_are_right():
    honest = calibration_of([(0.9, True)] * 9 + [(0.9, False)])
    assert honest.expected_error == pytest.approx(0.0, abs=1e-12)
    assert honest.brier == pytest.approx(0.09)
    sure = calibration_of([(1.0, True), (1.0, False)])
    assert sure.expected_error == pytest.approx(0.5)
    assert sure.table[0].count == 2
    assert calibration_of([]) is None


def answer(verdict, *effects, plan="typical", wrong=False):
    rows = [
        {
            "mechanism": effect.mechanism,
            "in_library": effect.in_library,
            "size": effect.size,
            "also_right": list(effect.also_right),
            "parameters": effect.parameters,
        }
        for effect in effects
    ]
    return {"verdict": verdict, "wrong_parameters": wrong, "effects": rows, "plan": plan}


def test_all_trials_together():
    trials = [
        trial_of("a", answer("adequate"), says("adequate")),
        trial_of("b", answer("adequate", wrong=True), says("missing_physics", "gear_mesh", confidence=0.6)),
        trial_of("c", answer("missing_physics", MESH), says("missing_physics", "gear_mesh")),
        trial_of("d", answer("missing_physics", HUM), says("missing_physics", "cogging", equivalent=[HUM.mechanism])),
        trial_of("e", answer("unexplained", CHIRP), says("unexplained")),
    ]
    summary = summarise(trials)
    exact, within = summary.groups["all"]["all"]
    assert (exact.hits, within.hits, within.trials) == (3, 4, 5)
    assert (summary.false_names.hits, summary.false_on_blank.hits, summary.false_on_blank.trials) == (1, 1, 2)
    assert (summary.unexplained_where_due.hits, summary.unexplained_where_due.trials) == (1, 1)
    assert summary.class_size == pytest.approx(4.0 / 3.0)
    assert (summary.hedged_with_advice.hits, summary.hedged_with_advice.trials) == (0, 1)
    assert summary.calibration.count == 3
    assert set(summary.groups["hidden effects"]) == {
        "clean",
        "wrong parameters only",
        "one effect",
        "effects outside the library",
    }
    assert [size_name(trial) for trial in trials[2:]] == ["as in handbooks", "just visible to small", "far larger"]
    assert [called_unexplained(trial) for trial in trials] == [False, False, False, False, True]


def test_the_command_opens_the_seal_and_scores(tmp_path):
    seal({"case-001": answer("missing_physics", MESH), "case-002": answer("adequate")}, tmp_path)
    (tmp_path / "diagnoses").mkdir()
    text = {
        "schema": "torquerig.diagnosis/1",
        "verdict": "missing_physics",
        "mismatch": [],
        "findings": [
            {
                "mechanism": "gear_mesh",
                "explanation": "a mesh",
                "confidence": 0.97,
                "parameters": {"order_output": {"value": 84.0, "ci95": [83.99, 84.01], "unit": "1/rev"}},
                "equivalent_to": [],
                "next_experiment": None,
            }
        ],
        "fit": {"before": {"heldout_misfit": 1.0, "nominal": 1.3}, "after": {"heldout_misfit": 0.41}},
    }
    (tmp_path / "diagnoses" / "case-001.json").write_text(json.dumps(text))
    told = CliRunner().invoke(score, [str(tmp_path), "--wrong", "--json", str(tmp_path / "score.json")])
    assert told.exit_code == 0, told.output
    assert "exactly right: 1 of 2" in told.output
    assert "held-out residual removed: median 0.590" in told.output
    assert "case-002 typical: no diagnosis; true effects: none; diagnosis: none" in told.output
    assert json.loads((tmp_path / "score.json").read_text())["outcomes"]["exactly right"] == 1
    assert claim_of(text).findings[0].parameters[0][1].interval == (83.99, 84.01)


def test_what_is_no_diagnosis_is_refused_with_its_name(tmp_path):
    path = tmp_path / "case-001.json"
    path.write_text('{"verdict": "perhaps"}')
    with pytest.raises(Exception, match=r"case-001\.json: the file is not a diagnosis"):
        read_claim(path)
