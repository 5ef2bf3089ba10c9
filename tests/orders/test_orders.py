"""The orders report and its telling."""

from math import pi

import pytest

from torquerig.errors import InputError
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.line_families import FAMILIES
from torquerig.orders.kinematics.order_report import orders_report
from torquerig.orders.kinematics.order_report_text import (
    ORDERS_HEADER,
    better_speed_sentence,
    orders_rows,
    orders_sentences,
)
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.reporting.figures.families import NAMES, SHORT

RPM = pi / 30
REPORT_MOTOR = Kinematics(pole_pairs=7, slots=12, ratio=5)


def test_rows_rise_in_frequency_and_fill_the_header():
    rows = orders_rows(orders_report(REPORT_MOTOR, 1000 * RPM))
    hertz = [float(row[0]) for row in rows]
    assert hertz == sorted(hertz)
    assert all(len(row) == len(ORDERS_HEADER) and all(row) for row in rows)
    assert ("100.00", "6", "30", "cogging per pole") in {row[:4] for row in rows}
    assert ("1400.00", "84", "420", "cogging") in {row[:4] for row in rows}


def test_cogging_and_its_count_per_magnet_are_told_apart_with_both_figures():
    sentence = orders_sentences(orders_report(REPORT_MOTOR, 1000 * RPM))[0]
    assert sentence.startswith("Cogging is at 1400.00 Hz: motor order 84, ")
    assert "Motor order 6 (100.00 Hz)" in sentence
    assert sentence.endswith("no cogging torque has this order.")


def test_words_of_the_reference_report_are_on_no_other_rig():
    report = orders_report(Kinematics(pole_pairs=4, slots=9, ratio=3, teeth=(Spur(20, 60),)), 700 * RPM)
    assert {line.family for line in report.lines} == set(FAMILIES) - {"intermediate", "belt", "bearing"}
    words = [text for row in orders_rows(report) for text in row] + list(orders_sentences(report))
    words += [text for names in (SHORT, NAMES) for text in names.values()]
    assert not [text for text in words if any(word in text for word in ("seed", "published", "report", "unknown"))]


def test_sentences_name_mains_equal_orders_better_speed_and_what_is_unknown():
    told = "\n".join(orders_sentences(orders_report(REPORT_MOTOR, 1000 * RPM)))
    assert "100 Hz is 2 x mains and, exactly, cogging per pole." in told
    assert "1400.00 Hz is cogging and six pulse x2: equal orders" in told
    assert "A better test speed is" in told
    assert "Equal orders coincide at any speed." in told
    assert "No gear mesh lines: tooth counts unknown." in told


@pytest.mark.parametrize(
    ("teeth", "gone"),
    [
        (Planetary(21, 84, 3), ()),  # 21/3 is whole: in phase, all are left
        (Planetary(22, 62, 3), ("gear mesh", "gear mesh x2", "gear mesh x4")),
        (Planetary(22, 62), ()),  # nobody counted the planets
        (Spur(20, 50), ()),
    ],
)
def test_mesh_lines_that_the_planets_cancel_are_marked(teeth, gone):
    """Parker 2000, JSV 236(4): harmonic l is left where l z_sun / n is whole."""
    report = orders_report(Kinematics(ratio=teeth.ratio, teeth=(teeth,)), 1000 * RPM)
    marked = [row[3].removesuffix(", cancelled") for row in orders_rows(report) if row[3].endswith(", cancelled")]
    assert tuple(marked) == gone
    told = [sentence for sentence in orders_sentences(report) if "planets cancel" in sentence]
    assert bool(told) == bool(gone)
    assert not gone or ", ".join(gone) in told[0]


def test_a_clear_speed_is_said_to_be_clear():
    assert better_speed_sentence(orders_report(REPORT_MOTOR, 970 * RPM)).startswith("At 970 rpm every line is")


def test_a_speed_without_remedy_is_said_to_have_none():
    report = orders_report(REPORT_MOTOR, 1000 * RPM, clearance=20.0)
    assert better_speed_sentence(report).startswith("No speed in the searched range keeps every line 20 Hz")


def test_without_slots_there_is_no_word_on_cogging():
    report = orders_report(Kinematics(pole_pairs=2, ratio=1), 1500 * RPM)
    assert not any("Cogging" in sentence for sentence in orders_sentences(report))


@pytest.mark.parametrize(("speed", "mains"), [(0.0, 50.0), (float("nan"), 50.0), (100.0, 0.0)])
def test_a_speed_or_mains_of_nothing_is_refused(speed, mains):
    with pytest.raises(InputError):
        orders_report(REPORT_MOTOR, speed, mains=mains)
