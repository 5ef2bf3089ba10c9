"""When an effect is called missing, and which of several is looked at first."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import convincing as judging
from torquerig.diagnosis.choosing import opened_gap
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit, misfit_sum
from torquerig.diagnosis.hypotheses import is_possible
from torquerig.diagnosis.judging import leftover
from torquerig.diagnosis.judging.leftover import detail_of
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.null_table import NullTable
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import order
from torquerig.mechanisms import CommutationRipple, StribeckFriction, TorsionalMode
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario


def model(rig: Rig, *levels: float) -> Calibrated:
    misfits = (Misfit(np.zeros(0), np.zeros(0), np.array(levels)),)
    cost = float(np.square(levels).sum())
    return Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), misfits, cost)


def trial(rig: Rig, name: str, *levels: float, before: Calibrated) -> Trial:
    fitted = model(rig, *levels)
    return Trial(Candidate(mechanism=name, parts=(), knobs=()), fitted, before.cost - fitted.cost)


@pytest.fixture
def case(wear_rig: Scenario) -> Case:
    before = model(wear_rig.rig, *[10.0] * 40)
    return Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())


def test_what_explains_its_places_comes_before_a_stand_in_that_gains_more(case: Case, wear_rig: Scenario) -> None:
    """The stand-in touches every place and leaves some of each; the effect makes half of them right."""
    stand_in = trial(wear_rig.rig, "blade_pass", *[4.5] * 40, before=case.model)
    effect = trial(wear_rig.rig, "gear_mesh", *[1.0] * 20, *[10.0] * 20, before=case.model)
    assert stand_in.gain > effect.gain
    assert judging.worth(case, effect) > judging.worth(case, stand_in)
    assert judging.convincing(case, effect, earlier=(), held=())
    assert not judging.convincing(case, stand_in, earlier=(), held=())


def test_of_two_that_explain_one_line_the_larger_gain_comes_first(case: Case, wear_rig: Scenario) -> None:
    """They claim the same, so that a rest tells no stand-in; at another line the one that explains all comes first."""
    line = order(42.0)
    rests = trial(wear_rig.rig, "commutation_ripple", *[3.0] * 40, before=case.model)
    whole = trial(wear_rig.rig, "cogging", *[1.0] * 36, *[10.0] * 4, before=case.model)
    rests, whole = (replace(each, candidate=replace(each.candidate, place=line)) for each in (rests, whole))
    assert rests.gain > whole.gain
    assert judging.worth(case, rests) < judging.worth(case, whole)
    assert judging.worthiest(case, [whole, rests]) is rests
    elsewhere = replace(rests, candidate=replace(rests.candidate, place=order(84.0)))
    assert judging.worthiest(case, [whole, elsewhere]) is whole


def test_of_what_explains_all_the_larger_gain_comes_first(case: Case, wear_rig: Scenario) -> None:
    """Shares of 0.99 and 1 differ by less than either is known to."""
    ripple = replace(trial(wear_rig.rig, "commutation_ripple", *[1.4] * 40, before=case.model), gain=3990.0)
    mesh = replace(trial(wear_rig.rig, "gear_mesh", *[1.0] * 40, before=case.model), gain=3950.0)
    assert judging.share_of(case, ripple) < judging.share_of(case, mesh)
    assert judging.worth(case, ripple) > judging.worth(case, mesh)


def test_a_model_that_misses_otherwise_asks_for_a_larger_gain(wear_rig: Scenario) -> None:
    """A gain of 50 is clear where each feature is right to its spread, and none where all are out by 1.5 spreads."""
    named = []
    for missed in (1.0, 1.5):
        before = model(wear_rig.rig, *[5.0, 5.0], *[missed] * 200)
        case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())
        effect = trial(wear_rig.rig, "gear_mesh", *[0.5] * 2, *[missed] * 200, before=before)
        assert 40 < effect.gain < 60
        named.append(judging.convincing(case, effect, earlier=(), held=()))
    assert named == [True, False]


def test_what_moves_the_slow_torque_alone_is_judged_there(wear_rig: Scenario) -> None:
    """Lines that moved with all other numbers are neither its places nor its failure."""
    lines = (10.0, 7.0)  # before and after
    before, after = (
        replace(
            model(wear_rig.rig, *levels),
            misfits=(Misfit(np.zeros(0), np.full(20, line), np.array(levels)),),
        )
        for levels, line in zip(([10.0] * 20, [0.5] * 20), lines, strict=True)
    )
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())
    drift, other = (
        Trial(Candidate(mechanism=name, parts=(), knobs=(), slow=slow), after, 1000.0)
        for name, slow in (("sensor_drift", True), ("gear_mesh", False))
    )
    assert judging.share_of(case, drift) == pytest.approx(1.0)
    assert judging.share_of(case, other) < 0.8


def test_what_does_not_suffice_alone_may_be_half_of_a_pair(case: Case, wear_rig: Scenario) -> None:
    much = trial(wear_rig.rig, "gear_mesh", *[4.5] * 40, before=case.model)
    little = trial(wear_rig.rig, "gear_mesh", *[9.5] * 40, before=case.model)
    described = replace(much, candidate=replace(much.candidate, description="noise"))
    assert [judging.promising(case, each) for each in (much, little, described)] == [True, False, False]
    slow = replace(much, candidate=replace(much.candidate, slow=True))
    assert judging.takes_much(case, slow)
    assert not judging.promising(case, slow), "the levels of a run stray beside it, all to one side"


def test_a_table_of_clean_rigs_asks_for_more_than_the_built_in_gain(case: Case, wear_rig: Scenario) -> None:
    effect = trial(wear_rig.rig, "gear_mesh", *[1.0] * 20, *[10.0] * 20, before=case.model)
    table = NullTable(key="", made_by="", seeds=(1,), clean_rigs=20, chance=0.002, thresholds={"gear_mesh": 1e5})
    other = replace(table, thresholds={"blade_pass": 1e5})
    judged = [
        judging.convincing(replace(case, thresholds=each), effect, earlier=(), held=()) for each in (table, other)
    ]
    assert judged == [False, True]


def test_no_drive_turns_its_torque_round_within_a_turn(wear_rig: Scenario) -> None:
    deep, shallow = (CommutationRipple(name="ripple", order_motor=42.0, depth=depth) for depth in (1.5, 0.4))
    for part, possible in ((deep, False), (shallow, True)):
        candidate = Candidate(mechanism="commutation_ripple", parts=(part,), knobs=())
        assert is_possible(candidate, wear_rig.rig + part) is possible


def test_a_branch_that_hardly_rings_is_no_mode(wear_rig: Scenario) -> None:
    for damping, possible in ((0.4, False), (0.06, True)):
        part = TorsionalMode(name="mode", after="wear_part", frequency=90.0, inertia=1e-3, damping_ratio=damping)
        candidate = Candidate(mechanism="torsional_mode", parts=(part,), knobs=())
        assert is_possible(candidate, wear_rig.rig + part) is possible


def test_a_branch_that_is_next_to_weightless_is_no_mode(wear_rig: Scenario) -> None:
    for inertia, possible in ((1.5e-5, False), (6e-5, True)):
        part = TorsionalMode(name="mode", after="wear_part", frequency=90.0, inertia=inertia, damping_ratio=0.02)
        candidate = Candidate(mechanism="torsional_mode", parts=(part,), knobs=(), above={"inertia": 3e-5})
        assert is_possible(candidate, wear_rig.rig + part) is possible


@pytest.mark.parametrize(
    ("static", "backward", "speed", "possible"),
    [(0.4, None, 50.0, True), (0.29, 0.5, 50.0, True), (0.05, None, 50.0, False), (0.4, 0.02, 50.0, False),
     (0.05, None, 1.0, True)],
)  # fmt: skip
def test_friction_that_sets_in_with_speed_is_drag(
    static: float, backward: float | None, speed: float, possible: bool, wear_rig: Scenario
) -> None:
    """But near standstill few samples tell how large it is."""
    part = StribeckFriction(
        name="friction", coulomb=0.3, static=static, stribeck_speed=speed,
        coulomb_backward=None if backward is None else 0.3, static_backward=backward,
    )  # fmt: skip
    candidate = Candidate(mechanism="stribeck_friction", parts=(part,), knobs=())
    assert is_possible(candidate, wear_rig.rig + part) is possible


@pytest.mark.parametrize(
    ("coulomb", "backward", "possible"), [(0.1, None, True), (0.03, None, False), (0.01, 0.1, True)]
)
def test_what_holds_many_times_what_slides_is_no_friction(
    coulomb: float, backward: float | None, possible: bool, wear_rig: Scenario
) -> None:
    part = StribeckFriction(
        name="friction", coulomb=coulomb, static=0.4, stribeck_speed=1.0,
        coulomb_backward=backward, static_backward=None if backward is None else 0.4,
    )  # fmt: skip
    candidate = Candidate(mechanism="stribeck_friction", parts=(part,), knobs=())
    assert is_possible(candidate, wear_rig.rig + part) is possible


def test_a_rest_is_detail_only_beside_what_was_found(case: Case, monkeypatch: pytest.MonkeyPatch) -> None:
    def every(one: Case) -> list[Misfit]:
        return list(one.model.misfits)

    monkeypatch.setattr(leftover, "_every", every)
    after = replace(case, model=model(case.nominal, 7.0, *[1.0] * 39))
    left = [Mismatch(domain="order", axis="motor_shaft", at=84.0, width=0.02, recordings=("run",), excess_dB=17.0,
                     share_of_misfit=1.0, p_value=1e-9)]  # fmt: skip
    assert detail_of(case, after, left) is None, "a hundredth of the misfit is no detail"
    strong = replace(case, model=model(case.nominal, *[3000.0] * 40))
    rest = detail_of(strong, after, left)
    assert rest is not None
    assert 0 < rest < 0.0025
    assert detail_of(strong, after, []) is None
    flying = [replace(left[0], domain="distribution")]
    assert detail_of(strong, after, flying) is None, "flights of flanks are no detail of anything"
    beside = replace(case, model=model(case.nominal, *[3000.0] * 38, 7.0, 7.0))
    after = replace(case, model=model(case.nominal, *[1.0] * 38, 7.0, 7.0))
    assert detail_of(beside, after, left) is None, "no detail stands where the effect changes nothing"


def test_where_nothing_stands_out_a_strong_effects_details_are_no_second_effect(
    case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    second = trial(wear_rig.rig, "torsional_mode", *[1.0] * 20, *[10.0] * 20, before=case.model)
    strong = replace(second, gain=200.0 * second.gain)
    left = Mismatch(
        domain="frequency", axis="Hz", at=90.0, width=5.0, recordings=("run1",), excess_dB=9.0,
        share_of_misfit=1.0, p_value=1e-9,
    )  # fmt: skip
    judged = []
    for places in ((), (left,)):
        monkeypatch.setattr(judging, "mismatches", lambda _, places=places: places)
        judged.append(judging.convincing(case, second, earlier=[strong], held=()))
    assert judged == [False, True]


@pytest.mark.parametrize(("loosens", "named"), [(("viscous",), True), ((), False)])
def test_what_moves_the_slow_torque_is_no_detail_of_a_line(
    loosens: tuple[str, ...], named: bool, case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A drag gained 360 beside a mesh that gained 105 000, more than which its details may."""
    monkeypatch.setattr(judging, "mismatches", lambda _: ())
    drag = trial(wear_rig.rig, "quadratic_drag", *[1.0] * 40, before=case.model)
    drag = replace(drag, candidate=replace(drag.candidate, loosens=loosens))
    mesh = replace(trial(wear_rig.rig, "gear_mesh", *[1.0] * 40, before=case.model), gain=200.0 * drag.gain)
    assert judging.convincing(case, drag, earlier=[mesh], held=()) is named


@pytest.fixture
def judged_again(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> Callable[..., bool]:
    """Whether a first effect is convincing that explains a share of its places, and gains again on what is held out."""

    def judged(before: Calibrated, effect: Trial, *, share: float, held_gain: float, standing_out: bool = True) -> bool:
        places = ("somewhere",) if standing_out else ()
        monkeypatch.setattr(judging, "mismatches", lambda _: places)
        case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())
        monkeypatch.setattr(judging, "share_of", lambda *_: share)
        monkeypatch.setattr(judging, "misfits_of", lambda rig, held: held)
        of_before = iter([True, False])

        def missed(misfits: Sequence[Misfit]) -> float:
            if misfits:
                return misfit_sum(misfits)
            return 200.0 if next(of_before, False) else 200.0 - held_gain

        monkeypatch.setattr(judging, "misfit_sum", missed)
        return judging.convincing(case, effect, earlier=(), held=())

    return judged


@pytest.mark.parametrize(("held_gain", "share", "named"), [(30.0, 1.0, True), (5.0, 1.0, False), (30.0, 0.85, False)])
def test_a_small_gain_suffices_where_it_comes_again_on_what_no_fit_has_seen(
    held_gain: float, share: float, named: bool, wear_rig: Scenario, judged_again: Callable[..., bool]
) -> None:
    """Thirty is less than any single look may be trusted with; two looks that agree are another matter."""
    before = model(wear_rig.rig, *[1.0] * 40, 5.6)
    effect = trial(wear_rig.rig, "blade_pass", *[1.0] * 41, before=before)
    assert judged_again(before, effect, share=share, held_gain=held_gain) is named
    alike = replace(effect, candidate=replace(effect.candidate, resembled=True))
    assert not judged_again(before, alike, share=share, held_gain=held_gain - 5.0)
    enough_by_itself = held_gain + 20.0 > 0.7 * 40.0
    assert judged_again(before, alike, share=share, held_gain=held_gain + 20.0) is (enough_by_itself and share > 0.9)
    low_pass = replace(alike, candidate=replace(alike.candidate, as_loads=True))
    assert not judged_again(before, low_pass, share=share, held_gain=held_gain + 20.0), "laws of a load resemble it"


@pytest.mark.parametrize(("bent", "held_gain", "named"), [(7.0, -8.0, True), (7.0, -30.0, False), (0.0, -8.0, False)])
def test_numbers_that_come_back_are_told_by_no_recording(
    bent: float, held_gain: float, named: bool, wear_rig: Scenario, judged_again: Callable[..., bool]
) -> None:
    """A line of the rig's own, bent far up, foretells blades at its order as well as blades do."""
    before = model(wear_rig.rig, *[1.0] * 40, 1.0 if bent else 8.0)
    before = replace(before, cost=before.cost + bent**2)
    effect = trial(wear_rig.rig, "blade_pass", *[1.0] * 41, before=before)
    effect = replace(effect, gain=before.cost - effect.model.cost)
    assert judged_again(before, effect, share=1.0, held_gain=held_gain) is named


@pytest.mark.parametrize(
    ("held_gain", "share", "named"), [(140.0, 0.58, True), (100.0, 0.58, False), (140.0, 0.5, False)]
)
def test_a_large_gain_may_leave_more_where_all_of_it_comes_again(
    held_gain: float, share: float, named: bool, wear_rig: Scenario, judged_again: Callable[..., bool]
) -> None:
    before = model(wear_rig.rig, *[1.5] * 40, 12.0)
    effect = trial(wear_rig.rig, "blade_pass", *[1.5] * 41, before=before)
    assert 100.0 < effect.gain < 150.0
    assert judged_again(before, effect, share=share, held_gain=held_gain) is named


@pytest.mark.parametrize(
    ("held_gain", "share", "named"), [(100.0, 0.58, True), (60.0, 0.58, False), (100.0, 0.4, False)]
)
def test_where_nothing_stands_out_half_of_its_places_is_enough_for_what_comes_again(
    held_gain: float, share: float, named: bool, wear_rig: Scenario, judged_again: Callable[..., bool]
) -> None:
    """Laws that differ miss a little all over, and no effect is to explain them; no clean rig gains 75 there."""
    before = model(wear_rig.rig, *[1.5] * 40, 12.0)
    effect = trial(wear_rig.rig, "sensor_bandwidth", *[1.5] * 41, before=before)
    told = judged_again(before, effect, share=share, held_gain=held_gain, standing_out=False)
    assert told is named


@pytest.mark.parametrize(("features", "held_gain", "named"), [(60, 25.0, True), (60, 15.0, False), (40, 25.0, False)])
def test_what_falls_everywhere_a_little_has_no_places_of_its_own(
    features: int, held_gain: float, named: bool, wear_rig: Scenario, judged_again: Callable[..., bool]
) -> None:
    """Levels that were called random by a model without drag: each falls by less than chance moves it, all do."""
    before = model(wear_rig.rig, *[1.5] * features)
    effect = trial(wear_rig.rig, "quadratic_drag", *[0.6] * features, before=before)
    assert judged_again(before, effect, share=0.0, held_gain=held_gain, standing_out=False) is named


def test_a_line_is_judged_by_its_places_beside_numbers_that_stand_still(case: Case, wear_rig: Scenario) -> None:
    """Something else bends the numbers; with all of them free much moves with the line that is not its."""
    freed = trial(wear_rig.rig, "mains_interference", *[1.0] * 20, *[7.0] * 20, before=case.model)
    assert judging.share_of(case, freed) < 0.8
    assert judging.share_of(case, replace(freed, alone=0.95)) == 0.95


@pytest.mark.parametrize(("bends", "named"), [((), True), (("wear_part.inertia",), False)])
def test_no_mode_is_named_beside_noise_that_is_only_described(
    bends: tuple[str, ...], named: bool, case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the description of a band of noise leaves, a mode takes up; a low-pass does not."""
    monkeypatch.setattr(judging, "mismatches", lambda case: ("somewhere",))
    hump = trial(wear_rig.rig, "noise_hump", *[5.0] * 40, before=case.model)
    hump = replace(hump, candidate=replace(hump.candidate, description="noise of a fixed band"))
    found = trial(wear_rig.rig, "torsional_mode", *[1.0] * 40, before=case.model)
    found = replace(found, candidate=replace(found.candidate, resembled=True, bends=bends))
    assert judging.convincing(case, found, earlier=(hump,), held=()) is named
    assert judging.convincing(case, found, earlier=(), held=())


@pytest.mark.parametrize(
    ("share", "rest", "bends", "named"),
    [(0.85, 30.0, ("wear_part.inertia",), False), (0.95, 30.0, ("wear_part.inertia",), True),
     (0.85, 30.0, (), True), (0.85, 5.0, ("wear_part.inertia",), True)],
)  # fmt: skip
def test_a_mode_that_leaves_more_than_it_takes_explains_nearly_all_of_its_places(
    share: float, rest: float, bends: tuple[str, ...], named: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A shaft that stiffens as it twists moves the modes of some runs, and a mode beside it takes up a part of that."""
    monkeypatch.setattr(judging, "share_of", lambda *_: share)
    before = model(wear_rig.rig, *[10.0] * 6, *[rest] * 2, *[1.0] * 40)
    found = trial(wear_rig.rig, "torsional_mode", *[1.0] * 6, *[rest] * 2, *[1.0] * 40, before=before)
    found = replace(found, candidate=replace(found.candidate, resembled=True, bends=bends))
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())
    assert judging.convincing(case, found, earlier=(), held=()) is named


def test_a_zero_that_drifts_leaves_the_slow_torque_of_no_run_wrong(case: Case, wear_rig: Scenario) -> None:
    """A staircase of creep strays beside any smooth course, though that explains most of it."""
    named = []
    for rest in (1.0, 2.5):
        drift = trial(wear_rig.rig, "sensor_drift", *[rest] * 40, before=case.model)
        drift = replace(drift, candidate=replace(drift.candidate, slow=True))
        assert judging.share_of(case, drift) > 0.9
        named.append(judging.convincing(case, drift, earlier=(), held=()))
    assert named == [True, False]


@pytest.mark.parametrize(("gain", "resembled", "named"), [(30.0, True, False), (2.0, True, True), (30.0, False, True)])
def test_what_looks_like_a_low_pass_beside_impacts_is_their_ring(
    gain: float, resembled: bool, named: bool, case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(judging, "mismatches", lambda case: ("somewhere",))
    found = trial(wear_rig.rig, "sensor_bandwidth", *[1.0] * 40, before=case.model)
    found = replace(found, candidate=replace(found.candidate, resembled=resembled))
    impacts = replace(found, candidate=Candidate(mechanism="bearing_defect", parts=(), knobs=()))
    impacts = replace(impacts, gain=gain * found.gain)
    case = replace(case, seen=cast("tuple[Features, ...]", (SimpleNamespace(band=np.zeros(0)),)))
    assert judging.convincing(case, found, earlier=(impacts,), held=()) is named


@pytest.mark.parametrize(("own", "of_earlier", "named"), [(("viscous",), (), True), (("viscous",), ("viscous",), False),
                                                           ((), (), False)])  # fmt: skip
def test_a_second_effect_of_the_slow_torque_is_trusted_as_a_first_beside_one_that_has_none(
    own: tuple[str, ...], of_earlier: tuple[str, ...], named: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Drag beside blades: it leaves some of its places, and gains again on what no fit has seen."""
    monkeypatch.setattr(judging, "mismatches", lambda _: ())
    monkeypatch.setattr(judging, "share_of", lambda *_: 0.58)
    monkeypatch.setattr(judging, "misfits_of", lambda rig, held: held)
    of_before = iter([True])
    monkeypatch.setattr(judging, "misfit_sum", lambda _: 200.0 if next(of_before, False) else 100.0)
    before = model(wear_rig.rig, *[1.5] * 40, 12.0)
    drag = trial(wear_rig.rig, "quadratic_drag", *[1.5] * 41, before=before)
    drag = replace(drag, candidate=replace(drag.candidate, loosens=own))
    blades = trial(wear_rig.rig, "blade_pass", *[1.5] * 41, before=before)
    blades = replace(blades, candidate=replace(blades.candidate, loosens=of_earlier, place=order(2.6)))
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=before, left=())
    assert judging.convincing(case, drag, earlier=(blades,), held=()) is named


@pytest.mark.parametrize(
    ("flights", "named"), [([0, 5, 9, 6], True), ([0, 0, 20, 0], False), ([0, 3, 3, 2], False)],
    ids=["many, in three runs", "in one run", "few"],
)  # fmt: skip
def test_a_gap_whose_flights_are_seen_may_leave_half(
    flights: list[int], named: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """How flanks meet is another law's than the model's, and leaves a rest of the chatter; what slips shows one run."""
    seen = [SimpleNamespace(flown=count) for count in flights]
    monkeypatch.setattr(opened_gap, "flights_beyond_lines", lambda features: features.flown)
    before = model(wear_rig.rig, *[10.0] * 40)
    case = Case(nominal=wear_rig.rig, runs=(), seen=cast("tuple[Features, ...]", tuple(seen)), model=before, left=())
    gap, mode = (trial(wear_rig.rig, name, *[6.2] * 40, before=before) for name in ("backlash", "torsional_mode"))
    assert 0.45 < judging.share_of(case, gap) < 0.55
    assert judging.convincing(case, gap, earlier=(), held=()) is named
    assert not judging.convincing(case, mode, earlier=(), held=())


@pytest.mark.parametrize(("closed", "named"), [(200.0, True), (30.0, False)])
def test_a_line_that_goes_where_flanks_stay_closed_is_named_beside_a_gap_that_gained_much(
    closed: float, named: bool, case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What gains less than a quarter of a gap may be its detail; not where the gap changes nothing."""
    monkeypatch.setattr(judging, "gained_by_closed_lines", lambda *_: closed)
    case = replace(case, model=replace(case.model, corrections=(cast("Correction", object()),)))
    line = trial(wear_rig.rig, "cogging", *[1.0] * 40, before=case.model)
    gap = replace(trial(wear_rig.rig, "backlash", *[10.0] * 40, before=case.model), gain=5 * line.gain)
    assert judging.convincing(case, line, earlier=(gap,), held=()) is named
