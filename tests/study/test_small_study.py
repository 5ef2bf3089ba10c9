"""A small study, run once: candidates, rules, out of reach, cells, verdict and what-if, and the same on any cores."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.decide.verdict import Certainty
from torquerig.document import read_document
from torquerig.errors import InputError, TorquerigError
from torquerig.metrics.figure import Figure
from torquerig.rig.parts import Gear, Motor, SpeedController
from torquerig.rig.terms import Inertia
from torquerig.scenario.kinematics import gears_to_sensor
from torquerig.scenario.overrides import overridden
from torquerig.study.candidate import Candidate
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.left_out import left_out_gearboxes
from torquerig.study.missing_data import missing_data_text
from torquerig.study.operating_points import points_of
from torquerig.study.results import DriveResult, StudyRuns
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide
from torquerig.study.verdict import verdict
from torquerig.study.what_if import changes

SMALL = (
    "study.duration=2 s",
    "study.draws=1",
    "study.motors=[bldc-12n14p, HDS5C-102A, GP-71M]",
    "study.gearboxes=[reference-5-1, economy-20-1]",
    "study.filters.names=[none, report_filter_code, low_pass_20Hz]",
)
TINY = (*SMALL, "study.draws=0", "study.motors=[bldc-12n14p]", "study.filters.names=[none, low_pass_20Hz]")


def study_with(settings: Sequence[str]) -> Study:
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), settings)
    return open_study(document, load_catalog(shipped_folder()))


@cache
def small() -> StudyRuns:
    return run_study(study_with(SMALL))


@cache
def tiny(*settings: str) -> StudyRuns:
    return run_study(study_with((*TINY, *settings)), workers=1)


def drive(name: str) -> DriveResult:
    return next(one for one in small().drives if one.candidate.name == name)


@pytest.mark.long
def test_candidates_are_all_motors_on_all_gearboxes_and_an_alias_keeps_its_name() -> None:
    assert [one.candidate.name for one in small().drives] == [
        "bldc-12n14p 5:1", "bldc-12n14p 20:1", "HDS5C-102A 5:1", "HDS5C-102A 20:1", "GP-71M 5:1", "GP-71M 20:1",
    ]  # fmt: skip
    alias = drive("HDS5C-102A 5:1")
    assert alias.recording is not None
    stands_for = small().study.catalog.motor("HDS5C-102A").stands_for
    assert stands_for
    assert stands_for != "HDS5C-102A"


def test_an_alias_runs_exactly_as_what_it_stands_for() -> None:
    study = study_with(TINY)
    stands_for = study.catalog.motor("HDS5C-102A").stands_for
    found = [
        scenario_of(replace(candidates(study)[0], motor=name), study, seed=3).rig
        for name in ("HDS5C-102A", str(stands_for))
    ]
    parts = [
        {part.name: replace(part, model="") if isinstance(part, Motor) else part for part in rig.parts} for rig in found
    ]
    assert parts[0] == parts[1]


def test_all_turn_the_output_at_the_same_speed() -> None:
    for one in small().drives:
        assert one.motor_speed == pytest.approx(one.candidate.ratio * 200 * pi / 30)
        if one.recording is not None:
            measured = one.recording.channels["true_output_speed_rad_s"].values.mean()
            assert measured == pytest.approx(200 * pi / 30, rel=2e-3)  # wander, and a load that comes and goes


def test_a_motor_that_cannot_reach_the_speed_is_said_and_not_simulated() -> None:
    slow = drive("GP-71M 20:1")
    assert slow.out_of_reach == "needs 4000 rpm, reaches at most 3000 rpm"
    assert slow.recording is None
    assert not slow.chains
    assert slow.disturbance.unknown
    assert slow.margins["speed_reserve"].high is None or slow.margins["speed_reserve"].high < 1
    decided = decide(small())
    assert not any("GP-71M 20:1" in name for name in decided.alternatives)
    assert "GP-71M 20:1" in decided.requirements.alternatives


def test_the_loop_of_every_drive_follows_the_one_rule() -> None:
    """kp = 2 pi f J and ki = kp 2 pi f_i, J all inertia reduced to the motor by the square of the ratio."""
    study = small().study
    for one in small().drives:
        rig = scenario_of(one.candidate, study, seed=study.settings.seed).rig
        inertia = sum(
            term.inertia / (1.0 if term.node == "motor" else one.candidate.ratio**2)
            for term in rig.terms()
            if isinstance(term, Inertia)
        )
        loop = next(part for part in rig.parts if isinstance(part, SpeedController))
        assert loop.kp == pytest.approx(2 * pi * 30 * inertia)
        assert loop.ki == pytest.approx(loop.kp * 2 * pi * 1.5)
        assert one.kp == loop.kp


def test_the_rule_gives_the_reference_gains_within_8_percent() -> None:
    """As scenarios/wear_rig.yaml says: 0.05 N m s/rad and 0.5 N m/rad."""
    rig = scenario_of(drive("bldc-12n14p 5:1").candidate, small().study, seed=1).rig
    loop = next(part for part in rig.parts if isinstance(part, SpeedController))
    assert (loop.kp, loop.ki) == (pytest.approx(0.05, rel=0.08), pytest.approx(0.5, rel=0.08))


def test_no_drive_can_break_the_sensor() -> None:
    study = small().study
    for one in small().drives:
        rig = scenario_of(one.candidate, study, seed=1).rig
        gain = np.prod([abs(gear.ratio) * gear.efficiency for gear in gears_to_sensor(rig)])
        assert one.torque_limit * gain <= 10.0 * (1 + 1e-12)
        assert one.candidate.name != "bldc-12n14p 20:1" or one.torque_limit * gain == pytest.approx(10.0)  # it binds
        assert one.margins["sensor_peak"].value == pytest.approx(one.torque_limit * gain)


def test_a_ratio_stated_in_the_rig_pins_the_gearbox() -> None:
    study = study_with((*TINY, "gearbox.ratio=10"))
    (only,) = candidates(study)
    assert (only.gearbox, only.ratio, only.name) == ("reference-5-1", 10.0, "bldc-12n14p 10:1")
    rig = scenario_of(only, study, seed=1).rig
    assert next(part for part in rig.parts if isinstance(part, Gear)).ratio == 10.0
    assert rig.run.speed_rpm == pytest.approx(2000)
    note = left_out_gearboxes(study)
    assert note.startswith("Not compared: economy-20-1. --set gearbox.ratio=10: rig.gearbox.ratio: 10 is stated")
    assert left_out_gearboxes(study_with(TINY)) == ""


@pytest.mark.long
def test_one_worker_and_two_give_the_same_numbers() -> None:
    one, two = tiny(), run_study(study_with(TINY), workers=2)
    for a, b in zip(one.drives, two.drives, strict=True):
        assert a.candidate == b.candidate
        assert a.shares == b.shares
        assert {name: made.truth_error for name, made in a.chains.items()} == {
            name: made.truth_error for name, made in b.chains.items()
        }
        assert a.recording is not None
        assert b.recording is not None
        assert np.array_equal(a.recording.torque(), b.recording.torque())


def test_progress_is_told_after_every_drive() -> None:
    told: list[tuple[int, int]] = []
    run_study(study_with((*TINY, "study.duration=0.5 s")), progress=lambda done, total, _: told.append((done, total)))
    assert told == [(0, 2), (1, 2), (2, 2)]  # first what earlier calls have kept


def test_figures_of_a_drive_with_copies_hold_all_copies() -> None:
    for one in small().drives:
        for made in one.chains.values():
            error = made.truth_error
            assert error.value is not None
            assert error.low is not None
            assert error.high is not None
            assert error.low <= error.value <= error.high
            assert error.low < error.high, "one drawn copy was asked for"


def test_shares_of_the_reading_are_all_there_and_sum_to_a_hundred() -> None:
    shares = drive("bldc-12n14p 5:1").shares
    assert shares is not None
    assert sum(shares.percent().values()) == pytest.approx(100)
    assert min(shares.percent().values()) > 0
    assert shares.mean == pytest.approx(1.0 + 0.010 * 200 * pi / 30, rel=0.1)  # load and viscous drag, hits and slow


def test_cells_carry_their_source_and_an_unknown_stays_unknown() -> None:
    decided = decide(small())
    for alternative in decided.matrix.alternatives:
        for criterion in decided.matrix.criteria:
            cell = decided.matrix.cells[(alternative, criterion.name)]
            known = cell.value is not None or cell.low is not None
            assert cell.source if known else cell.unknown_reason, (alternative, criterion.name)
    prices = [decided.matrix.cells[(name, "price")] for name in decided.matrix.alternatives if "HDS5C" in name]
    assert prices
    assert all(cell.value is None and cell.unknown_reason for cell in prices), "no maker states a price"


def test_the_present_drive_is_the_datum_of_the_pugh_matrix() -> None:
    decided = decide(small())
    assert decided.baseline == "bldc-12n14p 5:1 | none"
    assert decided.baseline in decided.matrix.alternatives


def test_the_best_is_ranked_first_and_named_by_the_verdict() -> None:
    decided = decide(small())
    ranked = decided.ranked()
    totals = dict(zip(decided.overall.alternatives, decided.overall.total.tolist(), strict=True))
    assert [totals[name] for name in ranked] == sorted(totals.values(), reverse=True)
    answer = verdict(decided)
    assert answer.winner in ranked
    assert answer.winner.split(" | ")[0] in answer.sentence
    assert answer.certainty in answer.sentence
    assert 0 <= answer.p_best <= answer.best_shares["together"] <= 1 + 1e-12
    assert [fact.gain for fact in answer.facts] == sorted((fact.gain for fact in answer.facts), reverse=True)


def test_all_filters_of_a_drive_share_a_draw_and_one_fact() -> None:
    """What the catalog lacks of a motor is lacking once, whatever filter stands behind the sensor."""
    matrix = decide(small()).matrix
    for one in small().drives:
        cells = [
            matrix.cell(name, "reading error") for name in matrix.alternatives if name.startswith(one.candidate.name)
        ]
        facts = {cell.fact for cell in cells if not cell.known}
        assert len(facts) <= 1
        if facts and "motor.ripple.cogging_native" in one.assumed:
            assert facts == {f"measured cogging and ripple of {one.candidate.motor}"}


def test_what_is_missing_is_asked_for_in_a_buyer_s_words() -> None:
    one = Candidate(motor="M1", gearbox="G1", ratio=5.0)
    told = missing_data_text("motor.inertia, gearbox.stiffness, gearbox.input_inertia", one)
    assert told == "inertia of M1, stiffness, input inertia of G1"
    assert missing_data_text("motor.inertia, motor.ripple.cogging_native", one) == "measured cogging and ripple of M1"
    assert missing_data_text("price of M1, price of G1", one) == "price of M1, price of G1"
    assert missing_data_text("", one) == ""


def test_a_study_without_a_better_filter_says_to_leave_things_as_they_are() -> None:
    runs = tiny("study.gearboxes=[reference-5-1]", "study.filters.names=[none]", "study.duration=0.5 s")
    kept = "Keep bldc-12n14p 5:1 as it is, with the filter none: reading error 0."
    assert verdict(decide(runs)).sentence.startswith(kept)
    assert verdict(decide(answered(runs))).sentence.startswith(kept)


def test_where_no_drive_meets_the_demands_nothing_survives() -> None:
    harder = overridden(small().study.document, [*SMALL, "continuous torque.min=1000"])
    runs = replace(small(), study=open_study(harder, small().study.catalog))
    answer = verdict(decide(runs))
    assert (answer.certainty, answer.winner) == (Certainty.NOBODY, "")


def test_two_names_of_one_motor_tie() -> None:
    """REF is an alias of the rig's motor: equal drives, equal totals; no draw can part them."""
    edits = ("study.motors=[bldc-12n14p, REF]", "study.gearboxes=[reference-5-1]", "study.draws=0")
    runs = run_study(study_with((*TINY, *edits)))
    assert verdict(decide(answered(runs))).certainty is Certainty.TIE


def answered(runs: StudyRuns) -> StudyRuns:
    """The same runs, had the maker said that the rig's motor is a servo motor."""
    said = {"servo": Figure(value=1.0)}
    drives = (
        replace(one, margins={**one.margins, **said}) if one.margins["servo"].unknown else one for one in runs.drives
    )
    return replace(runs, drives=tuple(drives))


def test_a_question_about_the_present_motor_gives_both_branches_and_leaves_the_verdict_decided() -> None:
    before = verdict(decide(small()))
    assert before.certainty is not Certainty.OPEN
    assert before.answer.certainty_text == f"{before.certainty}, if bldc-12n14p is a servo motor"
    assert "Open question: is bldc-12n14p a servo motor?" in before.answer.sentences
    assert "If not, the requirement servo motor eliminates this drive." in before.answer.sentences
    assert any(sentence.startswith("Then") and "HDS5C-102A" in sentence for sentence in before.answer.sentences)
    asked = [fact for fact in before.facts if fact.fact == "whether bldc-12n14p is a servo motor"]
    assert asked[0].decisive
    assert any("ask the maker whether bldc-12n14p is a servo motor: " in told for told in before.open_facts)
    after = verdict(decide(answered(small())))
    assert after.certainty is before.certainty
    assert not after.answer.questions
    assert after.best_shares == pytest.approx(before.best_shares)


@pytest.mark.long
def test_what_if_shows_each_drive_before_and_after() -> None:
    found = changes(tiny(), tiny("load.occupancy=21"))
    assert [change.before for change in found] == ["bldc-12n14p 5:1", "bldc-12n14p 20:1"]
    for change in found:
        assert change.after == change.before
        assert change.error_before is not None
        assert change.error_after is not None
        assert change.error_after > 2 * change.error_before, "hits and slow variation grow with the mean of the load"


def test_an_edit_that_changes_nothing_shows_no_change() -> None:
    for change in changes(tiny(), tiny("load.occupancy=5")):
        assert change.error_after == change.error_before
        assert change.disturbance_after == change.disturbance_before


def test_points_are_occupancies_at_the_default_size_then_sizes_at_the_default_occupancy() -> None:
    study = study_with(TINY)
    points = points_of(study)
    assert [point.occupancy_percent for point in points] == [5, 11, 15, 21, 5, 5, 5, 5]
    assert [round(1e3 * point.particle_size, 2) for point in points] == [0.5, 0.5, 0.5, 0.5, 0.25, 0.32, 0.78, 0.98]
    assert len({point.name for point in points}) == len(points)
    there = scenario_of(candidates(study)[0], points[3].applied(study), seed=1).rig.run
    assert (there.occupancy_percent, there.particle_size) == (21, 0.5e-3)


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("study.motors=[HDS6A-0104A]", "the present motor 'bldc-12n14p' is not among the motors of the study"),
        ("output_speed=400 rpm", None),
        ("output_speed=1500 rpm", "the present motor 'bldc-12n14p' is out of reach"),
        ("study.motors=[foo]", "there is no motor 'foo' in the catalog"),
        ("present.gearbox=foo", r"study\.present\.gearbox: there is no gearbox 'foo'"),
        ("reading error.weight=-1", "-1 is out of range; it must be at least 0"),
        ("study.draws=-1", "-1 is out of range; it must be at least 0"),
        ("study.criteria={}", r"study\.criteria"),
    ],
)
def test_a_study_that_cannot_be_decided_is_refused_before_it_runs(setting: str, said: str | None) -> None:
    def opened() -> None:
        run_study(study_with((*TINY, "study.duration=0.5 s", setting)))

    if said is None:
        opened()
        return
    with pytest.raises(TorquerigError, match=said):
        opened()


def test_a_rig_of_two_gears_is_told_that_a_study_exchanges_one() -> None:
    second = "rig.belt={kind: gear, ratio: 2, stiffness: 900 N*m/rad, damping: 1 N*m*s/rad, output_inertia: 1 kg*cm^2}"
    told = r"the rig has 2 parts that the study could exchange as its stage \(gearbox, belt\); name one with exchange"
    with pytest.raises(InputError, match=told):
        candidates(study_with((*TINY, second)))
