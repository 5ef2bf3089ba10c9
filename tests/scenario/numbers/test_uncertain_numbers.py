"""Every number of a scenario takes an uncertainty: it is used, printed and written back, or refused."""

from __future__ import annotations

from dataclasses import replace
from math import log, sqrt
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.inference.knobs import Knob, nuisance_knobs, turned, unvaried
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

TEXT = """\
scenario: bench
operating_point: {output_speed: 60 rpm, load: {occupancy: 5 %}}
measured: sensor
rig:
  motor: {kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 2 N*m, pole_pairs: 4}
  sensor: {kind: torque_sensor, catalog: reference-10nm}
  drum: {kind: body, inertia: 20 kg*cm^2}
  loop: {kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}
  mesh: {kind: torque_ripple, at: drum, group: mechanical, amplitudes: {1: 0.10 N*m, 2: 40 mN*m}}
  load: {kind: particle_load, at: drum, mean_by_occupancy_percent: {0: 0.1 N*m, 5: 1.0 N*m, 20: 4 N*m}}
"""
FORMS = {
    # what is written: value, low, high of 1 N*m
    "{value: 1.0 N*m, rel_sd: 0.2}": (1.0, None, None),
    "{value: 1.0 N*m, rel_sd: 20 %}": (1.0, None, None),
    "1.0 N*m ± 10 %": (1.0, 0.9, 1.1),
    "1.0 N*m ±10%": (1.0, 0.9, 1.1),
    "100 N*cm +/- 10 %": (1.0, 0.9, 1.1),
    "1.0 N*m +- 0.2 N*m": (1.0, 0.8, 1.2),
    "1.0 N*m ± 200 mN*m": (1.0, 0.8, 1.2),
    "1.0 ± 0.2 N*m": (1.0, 0.8, 1.2),
    "(1.0 ± 0.2) N*m": (1.0, 0.8, 1.2),
    "{value: 1.0 N*m, low: 90 N*cm, high: 1.3 N*m}": (1.0, 0.9, 1.3),
    "{low: 90 N*cm, high: 1.3 N*m}": (None, 0.9, 1.3),
}
PLACES = {
    # name of the number: what stands there
    "load.mean_by_occupancy_percent.5": "5: 1.0 N*m",
    "mesh.amplitudes.2": "2: 40 mN*m",
    "motor.torque_limit": "torque_limit: 2 N*m",
}


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


def read(text: str, catalog: Catalog, *, seed: int = 1) -> Scenario:
    return read_scenario(parse_document(text, Path("bench.yaml")), catalog, seed=seed)


def value_of(made: Scenario, name: str) -> float:
    part, field, *key = name.split(".")
    held = getattr(made.rig.part(part), field)
    return float(held[float(key[0])] if key else held)


@pytest.mark.parametrize("name", PLACES)
@pytest.mark.parametrize("form", FORMS)
def test_every_form_at_every_place(form: str, name: str, catalog: Catalog) -> None:
    value, low, high = FORMS[form]
    there = PLACES[name]
    made = read(TEXT.replace(there, f"{there.split(':')[0]}: {form}"), catalog)
    known = made.uncertainties[name]
    assert known.value == pytest.approx(value_of(made, name))
    assert known.rel_sd == pytest.approx(0.2 if low is None or high is None else log(high / low) / sqrt(6))
    if value is None:
        assert low is not None
        assert high is not None
        assert low <= value_of(made, name) <= high
        other = read(TEXT.replace(there, f"{there.split(':')[0]}: {form}"), catalog, seed=2)
        assert value_of(other, name) != value_of(made, name)
        assert name in made.assumed
        assert name not in made.kept
    else:
        assert value_of(made, name) == pytest.approx(value)
        assert name in made.kept
    assert (known.low, known.high) == (pytest.approx(low), pytest.approx(high))


@pytest.mark.parametrize("form", FORMS)
def test_a_written_scenario_has_the_same_rig_and_uncertainties(form: str, catalog: Catalog) -> None:
    text = TEXT
    for there in PLACES.values():
        text = text.replace(there, f"{there.split(':')[0]}: {form}")
    text = text.replace("60 rpm", "60 rpm ± 5 %").replace("occupancy: 5 %", "occupancy: {low: 4 %, high: 5 %}")
    made = read(text, catalog)
    again = read(made.text(), catalog, seed=9)
    assert again.rig == made.rig
    assert again.operating_point == made.operating_point
    assert again.uncertainties == made.uncertainties
    assert not set(again.assumed) & set(made.uncertainties)


def test_a_plain_number_is_not_uncertain(catalog: Catalog) -> None:
    made = read(TEXT, catalog)
    assert not made.kept
    assert not [name for name in made.uncertainties if not name.startswith("sensor.")]


def test_an_uncertain_set_point_is_drawn_and_the_rig_turns_with_it(catalog: Catalog) -> None:
    text = TEXT.replace("60 rpm", "{low: 50 rpm, high: 70 rpm}")
    speeds = {read(text, catalog, seed=seed).rig.run.speed_rpm for seed in (1, 2)}
    assert len(speeds) == 2
    assert all(speed is not None and 50 < speed < 70 for speed in speeds)
    assert "operating_point.output_speed" in read(text, catalog).assumed


def test_items_of_a_list_may_be_uncertain(catalog: Catalog) -> None:
    gear = "  gear: {kind: gear, ratio: 5, stiffness: 11300 N*m/rad, damping: 2 N*m*s/rad, output_inertia: 7 kg*cm^2}\n"
    errors = "[{low: 10 urad, high: 50 urad}, 2 urad]"
    error = f"  te: {{kind: gear_mesh, gear: gear, order_output: 84, transmission_error: {errors}}}\n"
    made = read(TEXT.replace("  sensor:", f"{gear}  sensor:").replace("  load:", f"{error}  load:"), catalog)
    known = made.uncertainties["te.transmission_error.0"]
    assert (known.low, known.high) == (pytest.approx(1e-5), pytest.approx(5e-5))
    assert made.rig.part("te").transmission_error[0] == known.value  # type: ignore[attr-defined]
    assert Knob("te", "transmission_error", known.rel_sd, key=0) in nuisance_knobs(
        made.rig, made.uncertainties, occupancies=[]
    )


def test_a_numbers_unit_follows_the_motion(catalog: Catalog) -> None:
    slide = "  slide: {kind: slide, mass: 2 kg ± 10 %, coulomb: {low: 15 N, high: 20 N}}\n"
    made = read(TEXT.replace("  loop:", f"{slide}  loop:"), catalog)
    assert made.uncertainties["slide.mass"].low == pytest.approx(1.8)
    assert made.assumed["slide.coulomb"].endswith("N of ? (15..20 N)")


def test_a_diagnosis_varies_what_is_stated_and_states_the_remaining(catalog: Catalog) -> None:
    text = TEXT.replace("5: 1.0 N*m", "5: {value: 1.0 N*m, rel_sd: 0.2}").replace("2: 40 mN*m", "2: 40 mN*m ± 10 %")
    made = read(text.replace("60 rpm", "60 rpm ± 5 %"), catalog)
    knobs = {knob.name: knob for knob in nuisance_knobs(made.rig, made.uncertainties, occupancies=[5.0])}
    assert knobs["load.mean_by_occupancy_percent.5"].spread == 0.2  # stated, not the 0.05 of every load
    assert knobs["mesh.amplitudes.2"].spread == pytest.approx(log(1.1 / 0.9) / sqrt(6))
    moved = turned(made.rig, [knobs["mesh.amplitudes.2"]], np.array([1.0]))
    assert moved.part("mesh").amplitudes[2.0] > 0.04  # type: ignore[attr-defined]
    (sentence,) = unvaried(made.rig, made.uncertainties)
    assert "operating_point.output_speed" in sentence


def test_a_stated_load_spectrum_goes_before_the_assumed_one(catalog: Catalog) -> None:
    made = read(TEXT.replace("at: drum, mean_by", "at: drum, hit_rms: {value: 0.1, rel_sd: 0.02}, mean_by"), catalog)
    knobs = [knob for knob in nuisance_knobs(made.rig, made.uncertainties, occupancies=[]) if knob.field == "hit_rms"]
    assert [knob.spread for knob in knobs] == [0.02]


def test_an_interval_around_zero_is_added_and_not_multiplied(catalog: Catalog) -> None:
    made = read(TEXT.replace("2: 40 mN*m}", "2: 40 mN*m}, phases: {1: {value: 0, low: -0.5, high: 0.5}}"), catalog)
    (knob,) = (knob for knob in nuisance_knobs(made.rig, made.uncertainties, occupancies=[]) if knob.field == "phases")
    assert not knob.factor
    assert knob.spread == pytest.approx(1 / sqrt(6))


FAULTS = {
    "unknown key": ("{value: 1 N*m, relsd: 0.1}", r"percent\.5\.relsd: unknown key; did you mean 'rel_sd'\?"),
    "half an interval": ("{low: 1 N*m}", r"percent\.5: an interval needs both low and high"),
    "interval and rel_sd": ("{low: 1 N*m, high: 2 N*m, rel_sd: 0.1}", r"percent\.5: an interval and a rel_sd"),
    "low above high": ("{low: 3 N*m, high: 2 N*m}", r"low '3 N\*m' is above high"),
    "value outside": ("{value: 5 N*m, low: 1 N*m, high: 2 N*m}", r"the value is outside low and high"),
    "no value": ("{rel_sd: 0.1}", r"the value is missing"),
    "zero with rel_sd": ("{value: 0 N*m, rel_sd: 0.1}", r"0 has no relative standard deviation; write an interval"),
    "bad rel_sd": ("{value: 1 N*m, rel_sd: much}", r"percent\.5\.rel_sd: 'much' is no standard deviation"),
    "low without unit": ("{low: 1, high: 2 N*m}", r"percent\.5\.low: 1 has no unit"),
    "tolerance without unit": ("1 N*cm ± 0.2", r"the tolerance has no unit; write ± 0\.2 N\*cm or ± 0\.2 %"),
    "tolerance of another kind": ("1 N*m ± 2 rpm", r"'2 rpm' is a speed; a torque is wanted"),
    "negative tolerance": ("1 N*m ± -0.2 N*m", r"negative tolerance"),
    "below a bound": ("1 N*m ± 2 N*m", r"-1\.0 N\*m is out of range: mean load torque must be at least 0"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_what_cannot_be_an_uncertainty_is_refused(name: str, catalog: Catalog) -> None:
    written, said = FAULTS[name]
    with pytest.raises(InputError, match=rf"bench\.yaml:10: rig\.load\.mean_by_occupancy_.*{said}"):
        read(TEXT.replace("5: 1.0 N*m", f"5: {written}"), catalog)


@pytest.mark.parametrize(
    ("there", "written", "said"),
    [
        ("pole_pairs: 4", "pole_pairs: {value: 4, rel_sd: 0.1}", r"motor\.pole_pairs: a count is a whole number"),
        ("occupancy: 5 %", "occupancy: 5 % ± 10 %", r"load\.occupancy: .* share of the value or percentage points"),
    ],
)
def test_counts_and_ambiguous_per_cents_are_refused(there: str, written: str, said: str, catalog: Catalog) -> None:
    with pytest.raises(InputError, match=said):
        read(TEXT.replace(there, written), catalog)


def test_a_stated_catalog_value_stays_uncertain_in_a_sizing(catalog: Catalog) -> None:
    made = read(TEXT.replace("reference-10nm", "reference-10nm, stiffness: 900 N*m/rad ± 5 %"), catalog)
    assert made.uncertainties["sensor.stiffness"].low == pytest.approx(855)
    assert replace(made, seed=3).kept["sensor.stiffness"].startswith("900 N*m/rad")
