"""What an open value costs is the range of a figure over its interval; the figures are closed forms."""

from math import pi, sqrt

import pytest

from torquerig.catalog.checking.costs import costs
from torquerig.catalog.checking.figures import HOT, figures_of
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import load_catalog, read_classes, read_entry
from torquerig.catalog.sampling import nominal
from torquerig.catalog.shipped import shipped_folder

RPM = 2 * pi / 60
MOTOR = """name: mine
title: mine
kind: pmsm
rated_torque: {value: 1.2 N*m, evidence: DOC, source: p}
peak_torque: {value: 3.6 N*m, evidence: DOC, source: p}
rated_speed: {value: 3000 rpm, evidence: DOC, source: p}
max_speed: {value: 6000 rpm, evidence: DOC, source: p}
current_loop_bandwidth: {value: 1000 Hz, evidence: DOC, source: p}
pole_pairs: {value: 4, evidence: DOC, source: p}
slots: {value: 12, evidence: DOC, source: p}
rotor_inertia: {value: 0.4 kg*cm^2, evidence: DOC, source: p}
coulomb_friction: {value: 0.02 N*m, evidence: DOC, source: p}
viscous_friction: {value: 2e-5 N*m*s/rad, evidence: DOC, source: p}
torque_constant: {value: 0.4 N*m/Arms, evidence: DOC, source: p}
phase_resistance: {value: 2.5 ohm, evidence: DOC, source: p}
thermal_resistance: {value: 0.9 K/W, evidence: DOC, source: p}
thermal_time_constant: {value: 15 min, evidence: DOC, source: p}
price: {value: 200 EUR, evidence: DOC, source: p}
drive_price: {value: 300 EUR, evidence: DOC, source: p}
ripple:
  cogging_native: {value: 1 %, evidence: DOC, source: p}
  cogging_tolerance: {value: 0.5 %, evidence: DOC, source: p}
  six_pulse_ripple: {value: 2 %, evidence: DOC, source: p}
"""


def read(tmp_path, text=MOTOR):
    path = tmp_path / "mine.yaml"
    path.write_text(text, encoding="utf-8")
    return read_entry(path, Motor, read_classes(shipped_folder()))


def test_a_motor_that_is_documented_in_full_costs_nothing(tmp_path):
    assert costs(read(tmp_path)) == []


def test_figures_are_closed_forms(tmp_path):
    sample = nominal(read(tmp_path))
    found = {figure.name: figure.compute(sample) for figure in figures_of(sample.entry)}
    lines = [0.012, 0.006, 0.006, 0.024]
    assert found["torque lines at rated torque, rms at the motor's shaft"] == pytest.approx(
        sqrt(sum(one**2 for one in lines) / 2)
    )
    assert found["friction at rated speed"] == pytest.approx(0.02 + 2e-5 * 3000 * RPM)
    assert found["peak torque over rotor inertia"] == pytest.approx(90_000)
    assert found["current at rated torque"] == pytest.approx(3.0)
    assert found["copper loss at rated torque"] == pytest.approx(3 * 2.5 * HOT * 9)
    assert found["winding over ambient at rated torque"] == pytest.approx(3 * 2.5 * HOT * 9 * 0.9)
    assert found["voltage at largest speed"] == pytest.approx(0.4 * 6000 * RPM / sqrt(3))


def test_an_interval_of_cogging_is_a_range_of_the_torque_lines(tmp_path):
    text = MOTOR.replace("cogging_native: {value: 1 %", "cogging_native: {low: 0.5 %, high: 4 %")
    (cost,) = costs(read(tmp_path, text))
    ends = [sqrt(((1.2 * share) ** 2 + 2 * 0.006**2 + 0.024**2) / 2) for share in (0.005, 0.04)]
    assert cost.field == "ripple.cogging_native"
    assert f"{ends[0]:.3g}..{ends[1]:.3g} N*m" in cost.figure
    assert "disturbance" in cost.decides
    assert cost.ratio == pytest.approx(ends[1] / ends[0])


@pytest.mark.parametrize(
    ("line", "field", "figure"),
    [
        ("thermal_resistance", "thermal_resistance", "cannot be computed: winding over ambient at rated torque"),
        ("torque_constant", "torque_constant", "cannot be computed: current at rated torque, copper loss"),
        ("drive_price", "drive_price", "cannot be computed: price with drive"),
        ("  cogging_native", "ripple.cogging_native", "too small, computed without it"),
        ("  six_pulse_ripple", "ripple.six_pulse_ripple", "too small, computed without it"),
    ],
)
def test_what_is_unknown_leaves_its_figure_open(tmp_path, line, field, figure):
    text = "".join(f"{one}\n" for one in MOTOR.splitlines() if not one.startswith(line))
    found = costs(read(tmp_path, text))
    assert any(one.field == field and figure in one.figure and one.ratio == float("inf") for one in found)


def test_open_slots_cost_the_orders(tmp_path):
    found = costs(read(tmp_path, MOTOR.replace("slots: {value: 12,", "slots: {one_of: [9, 12],")))
    assert [(one.field, one.figure) for one in found] == [("pole_pairs, slots", "orders of cogging and ripple: 2 sets")]


def test_an_interval_that_hardly_matters_is_not_listed(tmp_path):
    text = MOTOR.replace(
        "rotor_inertia: {value: 0.4 kg*cm^2", "rotor_inertia: {low: 0.395 kg*cm^2, high: 0.405 kg*cm^2"
    )
    assert costs(read(tmp_path, text)) == []


def test_every_shipped_entry_is_checked():
    catalog = load_catalog(shipped_folder())
    for shelf in (catalog.motors, catalog.gearboxes, catalog.sensors, catalog.couplings):
        for entry in shelf.values():
            ratios = [one.ratio for one in costs(entry)]
            assert ratios == sorted(ratios, reverse=True)
            assert all(ratio > 1 for ratio in ratios)
