"""The answer of a study made by hand: sentences, branches, figures, budget."""

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.decide.verdict import Certainty
from torquerig.document import read_document
from torquerig.metrics.figure import Figure
from torquerig.scenario.overrides import overridden
from torquerig.study.answer.uncertainty_budget import mean_range, uncertainty_budget
from torquerig.study.candidates import candidates
from torquerig.study.definition import open_study
from torquerig.study.results import ChainResult, DriveResult, StudyRuns
from torquerig.study.scoring import decide
from torquerig.study.verdict import verdict

PRESENT = "bldc-12n14p"
MOTORS = (PRESENT, "HDS60-0102A", "ESM06X-201-302", "ESM06X-401-302", "HDS6A-0104A")
LONGEST = 25  # words


def study(*settings):
    names = f"study.motors=[{', '.join(MOTORS)}]"
    few = (names, "study.gearboxes=[reference-5-1]", "study.filters.names=[none, low_pass_20Hz]", "study.draws=4")
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), [*few, *settings])
    return open_study(document, load_catalog(shipped_folder()))


def made(errors, *settings, servo=None, price=(280.0, 950.0), spread=0.02):
    """Runs with ``errors[motor] = (without filter, with low_pass_20Hz)`` [N m]; nothing is simulated."""
    opened = study(*settings)
    drives = tuple(
        _drive(one, errors[one.motor], servo=servo, price=price, spread=spread) for one in candidates(opened)
    )
    return StudyRuns(study=opened, drives=drives, mean_load=1.2, occupancy_percent=5.0, particle_size=5e-4,
                     output_speed=20.9)  # fmt: skip


def _drive(candidate, errors, *, servo, price, spread):
    is_new = candidate.motor != PRESENT
    missing = "" if not is_new else "motor.ripple.cogging_native"
    unknown = Figure(missing=f"whether {candidate.motor} is a servo motor")
    margins = {
        "speed_reserve": Figure(value=3.0), "speed_use": Figure(value=0.5),
        "sensor_peak": Figure(value=9.0, unit="N*m"),
        "torque_reserve": Figure(value=3.0), "continuous_output_torque": Figure(value=5.0, unit="N*m"),
        "servo": Figure(value=1.0) if is_new or servo else unknown, "new_parts": Figure(value=3.0 * is_new),
        "price": Figure(low=price[0], high=price[1], unit="EUR", missing=f"price of {candidate.motor}")
        if is_new else Figure(value=0.0, unit="EUR"),
    }  # fmt: skip
    chains = {
        name: ChainResult(
            chain=name, left_out=(), random_error=0.1 * error, effect=None,
            truth_error=Figure(value=error, low=(1 - spread) * error, high=(1 + spread) * error, unit="N*m",
                               source="by hand", missing=missing),
        )
        for name, error in zip(("none", "low_pass_20Hz"), errors, strict=True)
    }  # fmt: skip
    return DriveResult(
        candidate=candidate, margins=margins, out_of_reach="", motor_speed=100.0, torque_limit=2.0, kp=0.05,
        assumed={missing: "drawn"} if missing else {}, shares=None, chains=chains,
        disturbance=Figure(value=errors[0], unit="N*m", source="by hand"),
    )  # fmt: skip


def answer(runs):
    return verdict(decide(runs))


ALIKE = {PRESENT: (0.2, 0.05), **dict.fromkeys(MOTORS[1:], (0.2, 0.1))}


def test_no_sentence_is_longer_than_25_words_and_the_action_comes_first():
    for runs in (made(ALIKE), made(ALIKE, servo=True), made({**ALIKE, PRESENT: (1.0, 1.0)})):
        sentences = answer(runs).answer.sentences
        assert max(len(one.split()) for one in sentences) <= LONGEST
        assert sentences[0].split()[0] in ("Keep", "Buy", "No")
        assert sentences[-1].startswith("How sure: ")


def test_the_present_motor_may_stay_and_the_other_branch_names_motors_that_data_does_not_part():
    found = answer(made(ALIKE))
    assert found.answer.sentences[:3] == (
        "Keep bldc-12n14p 5:1 and add the filter low_pass_20Hz: reading error 0.200 -> 0.050 N m, no cost.",
        "Open question: is bldc-12n14p a servo motor?",
        "If not, the requirement servo motor eliminates this drive.",
    )
    assert "and 1 other cannot be distinguished on published data" in found.answer.sentences[3]
    assert "(reading error 0.098 to 0.102 N m)" in found.answer.sentences[3]  # 0.1 N m ± 2 %
    assert found.answer.sentences[4].startswith("Before you buy, ask the maker for the price of ")
    assert found.certainty is not Certainty.OPEN


def test_an_answered_question_is_not_asked():
    found = answer(made(ALIKE, servo=True))
    assert not any("question" in one for one in found.answer.sentences)
    assert found.answer.certainty_text == found.certainty


def test_a_branch_with_one_clear_motor_says_what_to_buy():
    clear = {**ALIKE, "HDS60-0102A": (0.06, 0.055), "HDS6A-0104A": (0.9, 0.9)}
    found = answer(made(clear, price=(300.0, 310.0)))
    assert "Then: Buy HDS60-0102A 5:1 and use the filter " in found.sentence
    assert "price 300 to 310 EUR" in found.sentence


def test_where_no_drive_is_clearly_best_nothing_is_recommended_to_buy():
    poor = {**ALIKE, PRESENT: (2.0, 2.0)}
    found = answer(made(poor, "study.criteria.new parts.weight=0", "study.criteria.price.weight=0.3"))
    assert found.certainty is Certainty.OPEN
    assert found.answer.sentences[0].startswith("No drive is clearly best: ")
    assert not any(one.startswith("Buy") for one in found.answer.sentences)


def test_the_three_figures_are_error_price_and_confidence():
    error, price, sure = answer(made(ALIKE)).answer.figures
    assert (error.value, error.note) == ("0.050 N m", "rms; today 0.200 N m (-75 %)")
    assert (price.value, price.note) == ("0 EUR", "no part is changed")
    assert sure.value.endswith(" %")


def test_what_changes_the_answer_names_the_question_and_weights():
    found = answer(made(ALIKE))
    assert found.changes[0].startswith("Ask the maker whether bldc-12n14p is a servo motor: if not, ")
    assert all(one.startswith(("Ask", "Weight")) for one in found.changes)


def budget(*settings, **kwargs):
    runs = made(ALIKE, *settings, **kwargs)
    return uncertainty_budget(runs.drives[0], "low_pass_20Hz", runs)


def item(found, name):
    return next(one for one in found.items if one.name == name)


def test_the_budget_combines_known_items_and_lists_the_others():
    found = budget()
    spread = 2 * 0.02 * 0.05 / mean_range(5)
    assert found.combined == pytest.approx(sqrt(0.05**2 + 0.005**2 + spread**2))
    assert found.expanded == pytest.approx(2 * found.combined)
    assert item(found, "random load").kind == "A"
    assert {one.kind for one in found.items if one.name != "random load"} == {"B"}
    assert found.not_known == (
        "sensor class", "linearity and hysteresis", "zero", "temperature drift of the zero",
        "temperature drift of the sensitivity", "bending of the sensor",
    )  # fmt: skip
    assert all(one.remedy for one in found.items if one.standard is None)


def test_the_converter_is_shown_and_not_counted_twice():
    """16 bit over ±10 V at 1 V per N m: a step of 20/65536 N m, over sqrt(12)."""
    converter = item(budget(), "converter")
    assert converter.standard == pytest.approx(20 / 65536 / sqrt(12))
    assert not converter.is_counted


def test_what_the_scenario_states_of_the_sensor_is_counted():
    edits = ("torque_sensor.gain_tolerance=0.005", "torque_sensor.zero_tolerance=10 mN*m")
    found = budget(*edits)
    assert item(found, "sensor class").standard == pytest.approx(0.005 * 1.2 / sqrt(3))
    assert item(found, "zero").standard == pytest.approx(0.010 / sqrt(3))
    assert found.combined > budget().combined
    assert item(budget("torque_sensor.tare=true"), "zero").standard == 0.0


def test_what_the_catalog_states_of_the_sensor_is_counted():
    """Kistler 4503: linearity and hysteresis up to 0.1 % of 10 N m, cross-talk up to 1 %, drift per 10 K."""
    found = budget("torque_sensor.catalog=Kistler-4503-10nm")
    assert item(found, "linearity and hysteresis").standard == pytest.approx(0.001 * 10 / sqrt(3))
    assert item(found, "bending of the sensor").standard == pytest.approx(0.01 * 10 / sqrt(2))
    assert item(found, "sensor class").standard == pytest.approx(0.005 * 1.2 / sqrt(3))
    assert item(found, "temperature drift of the zero").standard is None
    assert "each 10 K adds up to 0.01 N m" in item(found, "temperature drift of the zero").remedy


def test_the_drift_over_the_stated_change_of_temperature_is_counted():
    """Kistler 4503: zero up to 0.1 % of 10 N m and sensitivity up to 0.1 % of the mean 1.2 N m, each per 10 K."""
    found = budget("torque_sensor.catalog=Kistler-4503-10nm", "operating_point.temperature_change=15 K")
    assert item(found, "temperature drift of the zero").standard == pytest.approx(0.001 * 10 * 1.5 / sqrt(3))
    assert item(found, "temperature drift of the sensitivity").standard == pytest.approx(0.001 * 1.2 * 1.5 / sqrt(3))
    assert item(found, "temperature drift of the zero").is_counted
    assert found.not_known == ("zero",)
    still = budget("torque_sensor.catalog=Kistler-4503-10nm", "operating_point.temperature_change=0 K")
    assert item(still, "temperature drift of the zero").standard == 0.0
    by_hand = [
        0.05, 0.005, 2 * 0.02 * 0.05 / 2.326, 0.005 * 1.2 / sqrt(3), 0.01 / sqrt(3), 0.015 / sqrt(3),
        0.0018 / sqrt(3), 0.1 / sqrt(2),
    ]  # fmt: skip
    assert found.combined == pytest.approx(sqrt(sum(one**2 for one in by_hand)), rel=1e-4)


def test_a_temperature_without_a_catalog_entry_leaves_the_drift_unknown_and_says_what_is_missing():
    found = item(budget("operating_point.temperature_change=15 K"), "temperature drift of the zero")
    assert found.standard is None
    assert "name a catalog entry at the sensor" in found.remedy


def test_a_force_sensor_has_its_budget_in_newtons():
    """Class 0.2 % of 400 N, zero within 2 N, 16 bit over ±10 V at 5 mV/N: a step of 20 / 65536 / 0.005 N."""
    document = overridden(
        read_document(shipped_scenarios() / "linear_axis.yaml"), ["force_sensor.zero_tolerance=2 N", "study.draws=4"]
    )
    opened = open_study(document, load_catalog(shipped_folder()))
    name = opened.settings.filters.names[0]
    drive = _drive(candidates(opened)[0], (0.3, 0.3), servo=None, price=(1.0, 2.0), spread=0.0)
    chain = replace(
        next(iter(drive.chains.values())), chain=name, truth_error=Figure(value=0.3, low=0.3, high=0.3, unit="N")
    )
    drive = replace(drive, chains={name: chain}, shares=None, disturbance=replace(drive.disturbance, unit="N"))
    runs = StudyRuns(study=opened, drives=(drive,), mean_load=400.0, occupancy_percent=40.0, particle_size=5e-4,
                     output_speed=0.05)  # fmt: skip
    found = uncertainty_budget(drive, name, runs)
    assert found.unit == "N"
    assert item(found, "sensor class").standard == pytest.approx(0.002 * 400 / sqrt(3))
    assert item(found, "sensor class").basis.startswith("sensitivity within 0.2 % of 400 N,")
    assert item(found, "zero").standard == pytest.approx(2 / sqrt(3))
    assert item(found, "converter").standard == pytest.approx(20 / 65536 / 0.005 / sqrt(12))
    assert "bending of the sensor" not in {one.name for one in found.items}  # it does not turn
    assert found.not_known == (
        "linearity and hysteresis", "temperature drift of the zero", "temperature drift of the sensitivity",
    )  # fmt: skip


def test_one_sample_of_open_values_leaves_their_item_unknown():
    runs = made(ALIKE, "study.draws=0")
    found = uncertainty_budget(runs.drives[1], "none", runs)
    assert "open catalog data" in found.not_known
    assert "draws" in item(found, "open catalog data").remedy


def test_the_mean_range_is_that_of_normal_samples():
    """d2 of control charts: 1.128, 1.693, 2.059, 2.326 (Montgomery, Statistical Quality Control, appendix VI)."""
    assert [mean_range(n) for n in (2, 3, 4, 5)] == pytest.approx([1.128, 1.693, 2.059, 2.326], abs=6e-4)
    drawn = np.random.default_rng(3).standard_normal((20_000, 8))
    assert np.ptp(drawn, axis=1).mean() == pytest.approx(mean_range(8), rel=0.01)  # 20 000 ranges, 0.3 % each


def test_without_survivors_the_answer_says_so():
    runs = made(ALIKE)
    none = replace(runs, study=study("study.requirements.continuous torque.min=1000"))
    found = verdict(decide(none))
    assert found.certainty is Certainty.NOBODY
    assert found.answer.sentences[0] == "No drive meets the requirements."
    assert found.answer.figures == ()
