"""A part whose motion is imposed has no mode: it neither asks for a condensation nor is counted as a fast motion."""

from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.rig.assembly import Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.condensation.accuracy import accuracy, fastest_motion
from torquerig.simulation.condensation.beforehand import said_beforehand
from torquerig.simulation.condensation.lowered_for import lower_for
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower

RATE = 1000.0
RIG = """
operating_point: {}
measured: sensor
rig:
  hub: {kind: body, inertia: 1.0e-7 kg*m^2}
  sensor: {kind: torque_sensor, stiffness: 1 kN*m/rad, damping: 0 N*m*s/rad, inertia: 0 kg*m^2,
           sensitivity: 1 V/(N*m), bandwidth: 100 Hz, noise_rms: 0 mV}
  drum: {kind: body, inertia: 0.001 kg*m^2}
  DRIVE
"""
MOVED = "motion: {kind: imposed_motion, at: hub, from: channel angle}"


def rig(drive: str = "", **words: str) -> Rig:
    text = RIG.replace("DRIVE", drive)
    for word, value in words.items():
        text = text.replace(word, value)
    return read_scenario(parse_document(text, Path("rig.yaml")), Catalog(), seed=0).rig


def test_the_fastest_motion_is_that_of_the_parts_that_move_freely() -> None:
    free, held = lower(rig(), 0), lower(rig(MOVED), 0)
    clamped = sqrt(1000 / 0.001) / (2 * pi)  # the drum on the sensor, the hub held
    assert fastest_motion(held) == pytest.approx(clamped, rel=1e-9)
    assert fastest_motion(free) == pytest.approx(sqrt(1000 * (1 / 1e-7 + 1 / 0.001)) / (2 * pi), rel=1e-6)


def test_a_light_part_that_is_moved_asks_for_no_condensation() -> None:
    assert "condensed" in said_beforehand(rig(), rate=RATE)
    assert said_beforehand(rig(MOVED), rate=RATE) == ""
    assert lower_for(rig(MOVED), 0, rate=RATE).condensation is None


def test_what_is_condensed_behind_a_moved_part_is_judged_by_its_motion() -> None:
    # a light hub behind the moved one: 16 kHz, far above 500 Hz
    further = "flange: {kind: coupling, stiffness: 1 kN*m/rad, damping: 0 N*m*s/rad, inertia: 1.0e-7 kg*m^2}\n  sensor:"
    made = rig(MOVED, **{"sensor: {": further + " {"})
    small = lower_for(made, 0, rate=RATE)
    assert small.condensation is not None
    error = small.condensation.accuracy
    assert 0 < error.response < 5e-3
    assert error.fastest[0] == pytest.approx(sqrt(2000 / 1e-7) / (2 * pi), rel=1e-3)
    assert error.fastest[1] == pytest.approx(sqrt(500 / 0.001) / (2 * pi), rel=1e-3)


def test_a_rig_that_is_all_moved_has_no_motion_of_its_own() -> None:
    text = "operating_point: {}\nmeasured: motion\nrig:\n  hub: {kind: body, inertia: 1.0e-4 kg*m^2}\n  " + MOVED
    whole = lower(read_scenario(parse_document(text, Path("rig.yaml")), Catalog(), seed=0).rig, 0)
    assert fastest_motion(whole) == 0.0
    assert matrices(whole).held_at(np.array([0])).nodes == ()
    same = accuracy(whole, whole, band=500.0, acting=["hub"], read=[])
    assert (same.shift, same.response) == (0.0, 0.0)
