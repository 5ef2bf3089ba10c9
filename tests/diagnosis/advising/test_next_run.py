"""What one speed or one current cannot tell is said, and the run that is advised tells it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import pytest
from threadpoolctl import threadpool_limits

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.choosing.search import Tried, excess
from torquerig.diagnosis.choosing.set_aside import set_aside
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.diagnosis.outcome import Finding
from torquerig.mechanisms import Cogging, CommutationRipple, PwmAliasing
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario

Record = Callable[..., Recording]
COMB = tuple(PwmAliasing(name=f"tone{k}", frequency=281.12 * k, amplitude=0.015 / k) for k in (1, 2, 3))
COGGING = Cogging(name="hidden", slots=12, pole_pairs=7, native=0.03)
RIPPLE = CommutationRipple(name="hidden", order_motor=84.0, depth=0.08)


@pytest.fixture(autouse=True, scope="module")
def _one_thread() -> Iterator[None]:
    """As the command sets it: threads of small matrices only spin beside the simulations."""
    with threadpool_limits(limits=1, user_api="blas"):
        yield


def told(scenario: Scenario, record: Record, parts: Sequence[Part], runs: Sequence[tuple[float, float]]) -> Outcome:
    """Diagnose runs at (rpm, occupancy) of the scenario's rig with further parts, without an encoder for tones."""
    rig = scenario.rig
    for part in parts:
        rig = rig + part
    encoder = not isinstance(parts[0], PwmAliasing)
    made = [record(rig, 20 + k, rpm=rpm, occupancy=load, encoder=encoder) for k, (rpm, load) in enumerate(runs)]
    return diagnose(scenario, made)


def advised(finding: Finding, *, load: float) -> tuple[float, float]:
    """Return the speed [rpm] and the occupancy [%] that the advice names."""
    assert finding.next_experiment is not None
    found = re.match(
        r"Repeat at (\d+) rpm(?: (at idle)| with an occupancy of ([\d.]+) %)?\. There, ", finding.next_experiment
    )
    assert found is not None, finding.next_experiment
    return float(found[1]), 0.0 if found[2] else float(found[3] or load)


@pytest.fixture(scope="module")
def comb_at_one_speed(known_rig: Scenario, record: Record) -> Outcome:
    return told(known_rig, record, COMB, [(1000, 5)])


@pytest.mark.long
def test_at_one_speed_an_order_and_a_fixed_frequency_are_one_class(comb_at_one_speed: Outcome) -> None:
    (finding,) = comb_at_one_speed.diagnosis.findings
    assert {finding.mechanism, *finding.equivalent_to} == {"gear_mesh", "pwm_aliasing"}
    gains = dict(finding.alternatives)
    (other,) = finding.equivalent_to
    # both expect the same lines, so the fits differ by no more than where a fit stops
    assert gains[other] == pytest.approx(finding.gain, rel=0.01)
    assert comb_at_one_speed.diagnosis.verdict == "missing_physics"


@pytest.mark.long
def test_a_second_speed_is_advised_and_tells(comb_at_one_speed: Outcome, known_rig: Scenario, record: Record) -> None:
    rpm, load = advised(comb_at_one_speed.diagnosis.findings[0], load=5)
    assert abs(rpm / 1000 - 1) > 0.2
    (finding,) = told(known_rig, record, COMB, [(1000, 5), (rpm, load)]).diagnosis.findings
    assert finding.mechanism == "pwm_aliasing"
    assert finding.variant == "comb"
    assert finding.equivalent_to == ()
    assert finding.next_experiment is None


@pytest.mark.parametrize(
    ("truth", "name"), [(COGGING, "cogging"), pytest.param(RIPPLE, "commutation_ripple", marks=pytest.mark.full)]
)
@pytest.mark.long
def test_at_one_current_cogging_is_the_twelfth_harmonic_until_another_load_is_run(
    truth: Part, name: str, known_rig: Scenario, record: Record
) -> None:
    """12 slots and 14 poles: LCM(12, 14) = 84 = 12 x 7 pole pairs (Zhu & Howe 2000 for the order)."""
    (finding,) = told(known_rig, record, [truth], [(300, 5)]).diagnosis.findings
    assert {"cogging", "commutation_ripple"} <= {finding.mechanism, *finding.equivalent_to}
    rpm, load = advised(finding, load=5)
    (finding,) = told(known_rig, record, [truth], [(300, 5), (rpm, load)]).diagnosis.findings
    assert finding.mechanism == name
    assert finding.equivalent_to == ()


@pytest.mark.long
def test_every_mechanism_is_found_fitted_or_set_aside_with_a_reason(comb_at_one_speed: Outcome) -> None:
    diagnosis = comb_at_one_speed.diagnosis
    (finding,) = diagnosis.findings
    fitted = {finding.mechanism, *(name for name, _ in finding.alternatives)}
    aside = set(diagnosis.set_aside)
    assert not fitted & aside
    contract = {
        "gear_mesh", "commutation_ripple", "torsional_mode", "backlash", "stribeck_friction", "bearing_defect",
        "mains_interference", "sensor_bandwidth", "sensor_drift", "clipping", "quantization", "pwm_aliasing",
        "blade_pass", "quadratic_drag", "signal_dropout", "cogging",
    }  # fmt: skip
    assert fitted | aside == contract
    assert diagnosis.set_aside["quadratic_drag"] == "the recordings do not differ in speed"
    assert diagnosis.set_aside["backlash"] == "the torque is near zero in no recording, so no contact loss is possible"
    assert all(len(reason) > 10 for reason in diagnosis.set_aside.values())


@pytest.mark.long
def test_what_was_fitted_in_vain_says_how_little_went(comb_at_one_speed: Outcome) -> None:
    before, model = comb_at_one_speed.before, comb_at_one_speed.after.model
    vain = Trial(Candidate(mechanism="torsional_mode", parts=(), knobs=()), model, 0.5 * excess(before))
    said = set_aside(before, Tried((vain,), ()), known=())["torsional_mode"]
    assert said.startswith("fitted with all parameters: it removes 50% of the significant residual, and ")
    within = replace(before, model=replace(before.model, cost=0.0))
    assert "within random error" in set_aside(within, Tried((vain,), ()), known=())["torsional_mode"]
    assert "torsional_mode" not in set_aside(before, Tried((vain,), ()), known=("torsional_mode",))


@pytest.mark.long
def test_a_mechanism_that_is_not_there_is_set_aside_for_that(
    comb_at_one_speed: Outcome, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(mechanisms, "SensorDrift")
    monkeypatch.delattr(mechanisms, "Backlash")
    said = set_aside(comb_at_one_speed.before, Tried((), ()), known=())
    assert said["sensor_drift"] == said["backlash"] == "not in the library"
