"""Values that cannot hold together are named with both values; real and shipped entries contradict nothing."""

import pytest

from torquerig.catalog.checking.contradictions import contradictions
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import load_catalog, read_entry
from torquerig.catalog.shipped import shipped_folder

# Wittenstein premo 320 V, p. 30 [W1]: T0, I0, Kt, Rtt, Rth
PREMO = [(0.60, 0.35, 15.1, 1.19), (1.17, 0.39, 5.70, 0.94), (2.11, 0.52, 3.72, 0.81), (6.38, 0.54, 0.53, 0.54)]
TEXT = """name: mine
title: mine
kind: pmsm
rated_torque: {{value: {torque} N*m, evidence: DOC, source: p}}
peak_torque: {{value: 50 N*m, evidence: DOC, source: p}}
rated_speed: {{value: 3000 rpm, evidence: DOC, source: p}}
max_speed: {{value: 6000 rpm, evidence: DOC, source: p}}
current_loop_bandwidth: {{value: 1000 Hz, evidence: DOC, source: p}}
pole_pairs: {{value: 4, evidence: DOC, source: p}}
slots: {{value: 12, evidence: DOC, source: p}}
rotor_inertia: {{value: 0.4 kg*cm^2, evidence: DOC, source: p}}
coulomb_friction: {{value: 0.02 N*m, evidence: DOC, source: p}}
viscous_friction: {{value: 2e-5 N*m*s/rad, evidence: DOC, source: p}}
thermal_resistance: {{value: {thermal} K/W, evidence: DOC, source: p}}
ripple: {{cogging_native: {{value: 1 %, evidence: DOC, source: p}}}}
as_printed:
  evidence: DOC
  source: p
  torque_constant: {constant} N*m/A rms
  resistance: {resistance} ohm line-to-line
"""


def read(tmp_path, *, torque=1.17, constant=0.39, resistance=5.70, thermal=0.94, more=""):
    path = tmp_path / "mine.yaml"
    text = TEXT.format(torque=torque, constant=constant, resistance=resistance, thermal=thermal)
    path.write_text(text + more, encoding="utf-8")
    return read_entry(path, Motor)


@pytest.mark.parametrize(("torque", "constant", "resistance", "thermal"), PREMO)
def test_real_motors_do_not_contradict(tmp_path, torque, constant, resistance, thermal):
    motor = read(tmp_path, torque=torque, constant=constant, resistance=resistance, thermal=thermal)
    assert contradictions(motor) == []


def test_shipped_entries_do_not_contradict():
    catalog = load_catalog(shipped_folder())
    for shelf in (catalog.motors, catalog.gearboxes, catalog.sensors, catalog.couplings):
        for entry in shelf.values():
            assert contradictions(entry) == [], entry.name


def test_power_is_torque_times_speed(tmp_path):
    """1.17 N m at 3000 rpm are 367.6 W."""
    assert contradictions(read(tmp_path, more="  rated_power: 370 W\n")) == []
    (said,) = contradictions(read(tmp_path, more="  rated_power: 750 W\n"))
    assert said.startswith("rated_power 750 W is not rated_torque x rated_speed, which gives 367.6 W")


def test_a_resistance_that_would_burn_the_winding_is_named(tmp_path):
    assert contradictions(read(tmp_path, resistance=5.70)) == []
    (said,) = contradictions(read(tmp_path, resistance=11.4))
    assert "more than 155 K of class H; check whether the resistance is line-to-line" in said
    (said,) = contradictions(read(tmp_path, resistance=0.5))
    assert "could give much more than its rating" in said


def test_a_supply_below_the_back_emf_is_named(tmp_path):
    """0.39 N m/A at 6000 rpm makes 0.39 x 628.3 / sqrt(3) = 141 V."""
    supply = "supply_voltage: {value: %s V, evidence: DOC, source: p}\n"
    assert contradictions(read(tmp_path, more=supply % 230)) == []
    (said,) = contradictions(read(tmp_path, more=supply % 115))
    assert "makes 141 V at max_speed 6000 rpm, more than the supply of 115 V" in said


def test_a_stall_torque_below_the_rated_torque_is_named(tmp_path):
    more = "stall_torque: {value: 1.0 N*m, evidence: DOC, source: p}\n"
    assert "stall_torque 1 N*m is below rated_torque 1.17 N*m" in contradictions(read(tmp_path, more=more))[0]
