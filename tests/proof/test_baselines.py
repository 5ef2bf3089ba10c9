"""The baselines against signals whose every part is known."""

import numpy as np
import pytest
from threadpoolctl import threadpool_limits

from proof.baselines import BASELINES, TITLES
from proof.baselines.calibrated import Calibrated, CalibratedRun
from proof.baselines.named_lines import named_lines
from proof.baselines.refit_only import refit_only
from proof.baselines.residual_fft import lines_of, residual_fft
from proof.baselines.sparse_regression import sparse_regression
from proof.baselines.stlsq import plain_stlsq, pysindy_stlsq, stlsq
from proof.baselines.verdict import Named, verdict
from proof.prove.diagnosing import nominal_scenario
from proof.scoring.claims import claim_of

RATE, DURATION = 4000.0, 6.0
RIG = nominal_scenario().rig
TIME = np.arange(int(RATE * DURATION)) / RATE


@pytest.fixture(autouse=True)
def _one_thread():
    """As in the workers of a proof: threads of small products only wait for each other."""
    with threadpool_limits(limits=1):
        yield


def run_of(torque, speed, *, profile="steady"):
    """A run at constant or moving speed [rad/s] of the motor."""
    speed = np.broadcast_to(np.asarray(speed, dtype=float), TIME.shape)
    angle = np.cumsum(speed) / RATE
    held = np.arange(TIME.size) * 6 // TIME.size % 3 == 2
    return CalibratedRun(
        rate=RATE, torque=torque, angle=angle, speed=np.array(speed), steady=profile == "steady", held=held
    )


def outcome_of(*runs):
    return Calibrated(runs=runs, nominal=RIG, rig=RIG, diagnosis={"recordings": []})


def noise(seed):
    return 0.005 * np.random.default_rng(seed).standard_normal(TIME.size)


def test_a_line_takes_the_name_of_the_nearest_one():
    speed = 2 * np.pi * 17.1
    run = run_of(1.0 + 0.05 * np.cos(83 / 5 * speed * TIME) + noise(1), speed)
    (line,) = lines_of(run, RIG)
    assert line.frequency == pytest.approx(83 / 5 * 17.1, abs=0.2)
    assert line.amplitude == pytest.approx(0.05, rel=0.2)
    said = residual_fft(outcome_of(run))
    assert (said["verdict"], [row["mechanism"] for row in said["findings"]]) == ("missing_physics", ["gear_mesh"])
    assert said["findings"][0]["parameters"]["order_output"]["value"] == 83.0


def test_a_line_of_the_model_and_its_sidebands_are_no_residual():
    speed = 2 * np.pi * 17.1
    orders = (7.0, 7.0 - 0.2, 7.0 + 0.2, 12.0)
    torque = 1.0 + sum(0.05 * np.cos(order * speed * TIME) for order in orders) + noise(2)
    assert list(lines_of(run_of(torque, speed), RIG)) == []
    assert residual_fft(outcome_of(run_of(torque, speed)))["verdict"] == "adequate"


def test_a_line_that_stands_nowhere_is_unexplained():
    speed = 2 * np.pi * 17.1
    said = residual_fft(outcome_of(run_of(1.0 + 0.1 * np.cos(2 * np.pi * 1403.0 * TIME) + noise(3), speed)))
    assert (said["verdict"], said["findings"]) == ("unexplained", [])


def test_a_fixed_line_at_one_speed_is_taken_for_the_order_that_stands_there():
    """The spectrum of one speed cannot tell; that is what the baseline is there to show."""
    speed = 2 * np.pi * 50.0 * 5 / 83  # order 83 stands on 50 Hz
    rows = [row.mechanism for row in named_lines(RIG, motor_speed=speed) if abs(row.frequency - 50.0) < 1e-9]
    assert {"mains_interference", "gear_mesh"} <= set(rows)


@pytest.mark.parametrize("threshold", [0.05, 0.3])
def test_pysindys_stlsq_and_the_plain_one_agree(threshold):
    pytest.importorskip("pysindy")
    rng = np.random.default_rng(4)
    columns = rng.standard_normal((400, 12))
    truth = np.zeros(12)
    truth[[1, 5, 7]] = 2.0, -0.7, 0.1
    target = columns @ truth + 0.01 * rng.standard_normal(400)
    own, theirs = (f(columns, target, threshold=threshold) for f in (plain_stlsq, pysindy_stlsq))
    assert np.flatnonzero(own).tolist() == [i for i in (1, 5, 7) if abs(truth[i]) > threshold]
    np.testing.assert_allclose(own, theirs, atol=1e-6)
    assert not stlsq(columns, 1e-3 * target, threshold=threshold).any()


@pytest.mark.long
def test_sparse_regression_finds_windage_on_a_ramp_and_nothing_where_nothing_is():
    speed = np.linspace(15.0, 150.0, TIME.size)
    bare = 1.0 + 0.02 * speed / 5 + noise(5)
    other = run_of(1.0 + 0.02 * 20 + noise(6), 100.0)
    said = sparse_regression(outcome_of(run_of(bare, speed, profile="ramp"), other))
    assert (said["verdict"], said["findings"]) == ("adequate", [])
    drag = 4e-4 * (speed / 5) ** 2
    flat = run_of(1.0 + 0.02 * 20 + 4e-4 * 20**2 + noise(6), 100.0)
    said = sparse_regression(outcome_of(run_of(bare + drag, speed, profile="ramp"), flat))
    assert said["verdict"] == "missing_physics"
    assert "quadratic_drag" in [row["mechanism"] for row in said["findings"]]
    assert said["fit"]["after"]["heldout_misfit"] < 0.5 * said["fit"]["before"]["heldout_misfit"]


def test_sparse_regression_finds_a_mesh_order_with_its_teeth():
    speed = np.linspace(60.0, 100.0, TIME.size)
    run = run_of(np.zeros(TIME.size), speed, profile="ramp")
    torque = 1.0 + 0.1 * np.cos(83 / 5 * run.angle) + noise(7)
    said = sparse_regression(outcome_of(run_of(torque, speed, profile="ramp")))
    assert said["findings"][0]["mechanism"] == "gear_mesh"
    assert said["findings"][0]["parameters"]["order_output"]["value"] == 83.0


def test_refitting_alone_says_adequate_where_nothing_differs():
    fit = {"metric": "mean square", "before": {"heldout_misfit": 1.0, "nominal": 4.0}}
    for places, word in (([], "adequate"), ([{"at": 84.0}], "unexplained")):
        diagnosis = {"recordings": [], "mismatch": places, "fit": fit}
        said = refit_only(Calibrated(runs=(), nominal=RIG, rig=RIG, diagnosis=diagnosis))
        assert (said["verdict"], said["fit"]["after"]["heldout_misfit"]) == (word, 1.0)


def test_a_baselines_verdict_is_scored_as_a_diagnosis_is():
    named = Named(mechanism="cogging", confidence=0.7, explanation="so", parameters={"order_motor": 84.0})
    claim = claim_of(verdict("missing_physics", outcome_of(), [named]))
    assert (claim.verdict, claim.findings[0].mechanism, claim.after) == ("missing_physics", "cogging", None)
    assert dict(claim.findings[0].parameters)["order_motor"].value == 84.0
    assert set(BASELINES) < set(TITLES)
