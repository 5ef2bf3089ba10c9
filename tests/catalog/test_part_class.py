"""A class fills what a data sheet does not state, with intervals of the evidence CLASS."""

from pathlib import Path

import pytest

from torquerig.catalog.motor import Motor
from torquerig.catalog.part_class import KINDS
from torquerig.catalog.reading import load_catalog, read_classes, read_entry
from torquerig.catalog.sampling import nominal, sample_entry
from torquerig.catalog.shipped import shipped_folder
from torquerig.errors import InputError

SHEET = """name: mine
title: "motor of a sheet"
kind: pmsm
like: servo-60mm-400W
rated_torque: {value: 1.27 N*m, evidence: DOC, source: "p. 1"}
rotor_inertia: {value: 0.277 kg*cm^2, evidence: DOC, source: "p. 1"}
"""


@pytest.fixture(scope="module")
def classes():
    return read_classes(shipped_folder())


def read(tmp_path, classes, text=SHEET):
    path = tmp_path / "mine.yaml"
    path.write_text(text, encoding="utf-8")
    return read_entry(path, Motor, classes)


def refused(tmp_path, classes, text):
    with pytest.raises(InputError) as caught:
        read(tmp_path, classes, text)
    assert len(str(caught.value).splitlines()) == 1
    return str(caught.value)


def test_a_class_fills_what_is_not_stated_and_nothing_else(tmp_path, classes):
    motor = read(tmp_path, classes)
    assert motor.rated_torque.value == 1.27
    assert motor.rotor_inertia.documented
    for field in ("coulomb_friction", "viscous_friction", "current_loop_bandwidth", "peak_torque"):
        value = getattr(motor, field)
        assert value.evidence == "CLASS"
        assert value.source.startswith("class servo-60mm-400W: ")
        assert not value.documented
    assert motor.coulomb_friction.bounds == pytest.approx((0.01, 0.04))
    assert motor.ripple.cogging_native.bounds == pytest.approx((0.002, 0.02))
    assert motor.ripple.cogging_native.evidence == "CLASS"


def test_a_stated_ripple_is_kept_and_the_others_are_filled(tmp_path, classes):
    motor = read(tmp_path, classes, SHEET + 'ripple:\n  cogging_native: {value: 1 %, evidence: DOC, source: "p. 1"}\n')
    assert motor.ripple.cogging_native.value == 0.01
    assert motor.ripple.six_pulse_ripple.evidence == "CLASS"


def test_known_lines_are_not_mixed_with_shares_of_a_class(tmp_path, classes):
    lines = "ripple:\n  known_lines:\n    mechanical: {1: {value: 0.02 N*m, evidence: DOC, source: 'p. 1'}}\n"
    assert read(tmp_path, classes, SHEET + lines).ripple.cogging_native.unknown


def test_another_winding_takes_no_electrical_value_of_the_class(tmp_path, classes):
    printed = 'as_printed:\n  evidence: DOC\n  source: "p. 1"\n  torque_constant: 1.1 N*m/A rms\n'
    motor = read(tmp_path, classes, SHEET + printed)
    assert motor.torque_constant.value == 1.1
    assert motor.rated_current.unknown
    assert motor.phase_resistance.unknown
    assert read(tmp_path, classes).rated_current.evidence == "CLASS"


def test_a_filled_motor_is_sampled_within_its_class(tmp_path, classes):
    motor = read(tmp_path, classes)
    for seed in range(20):
        values = sample_entry(motor, seed).values
        assert 0.01 <= values["coulomb_friction"] <= 0.04
        assert values["rated_torque"] == 1.27


def test_an_unknown_class_is_refused_with_the_close_ones(tmp_path, classes):
    said = refused(tmp_path, classes, SHEET.replace("servo-60mm-400W", "servo-60mm-450W"))
    assert "mine.yaml:4: like: there is no class 'servo-60mm-450W'; did you mean" in said
    assert "'servo-60mm-400W'" in said


def test_a_class_of_other_parts_is_refused(tmp_path, classes):
    said = refused(tmp_path, classes, SHEET.replace("servo-60mm-400W", "planetary-60mm"))
    assert "mine.yaml:4: like: 'planetary-60mm' is a class of gearboxes of kind planetary, and this is a motor" in said
    said = refused(tmp_path, classes, SHEET.replace("servo-60mm-400W", "induction-71M"))
    assert "and this is a motor of kind pmsm; the classes for it are servo-130mm-1.5kW" in said


def test_a_class_that_does_not_fit_the_rating_is_named_with_its_line(tmp_path, classes):
    with pytest.raises(InputError) as caught:
        read(tmp_path, classes, SHEET.replace("1.27 N*m", "7 N*m"))
    said = str(caught.value)
    assert "mine.yaml:4: peak_torque: ? (3.8..4.46 N*m) is below rated_torque 7 N*m" in said


def test_every_shipped_class_of_motors_is_a_whole_motor(tmp_path, classes):
    for part in (one for one in classes.values() if one.of == "motor"):
        text = f"name: mine\ntitle: mine\nkind: {part.kinds[0]}\nlike: {part.name}\n"
        motor = read(tmp_path, classes, text)
        assert nominal(motor).values["coulomb_friction"] > 0
        assert all(value.evidence != "DOC" or value.choices for value in part.known().values()), part.name


def test_shipped_classes_of_all_parts_have_sources_and_are_named_as_their_file(classes):
    files = {path.stem for path in (shipped_folder() / "classes").glob("*.yaml")}
    assert files == set(classes)
    assert {part.of for part in classes.values()} == set(KINDS)
    assert all(value.source for part in classes.values() for value in part.known().values())


def test_a_class_of_one_folder_is_found_by_an_entry_of_another(tmp_path):
    (tmp_path / "motors").mkdir()
    (tmp_path / "motors" / "mine.yaml").write_text(SHEET, encoding="utf-8")
    assert load_catalog(shipped_folder(), tmp_path).motor("mine").coulomb_friction.evidence == "CLASS"
    with pytest.raises(InputError, match="there is no class 'servo-60mm-400W'"):
        load_catalog(tmp_path)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("values: {coulomb_frction: {low: 1 N*m, high: 2 N*m, evidence: RT, source: x}}",
         "mine.yaml:4: values.coulomb_frction: unknown key; did you mean 'coulomb_friction'"),
        ("values: {coulomb_friction: {value: 1 N*m, evidence: DOC, source: x}}",
         "values.coulomb_friction: a class knows intervals only; write low and high, or one_of"),
        ("values: {coulomb_friction: {low: 1 N, high: 2 N, evidence: RT, source: x}}", "a torque is wanted"),
        ("kinds: [pmms]\nvalues: {}", "there is no kind 'pmms' of motor; did you mean 'pmsm'?"),
    ],
)  # fmt: skip
def test_a_bad_class_is_refused_with_file_line_and_key(tmp_path: Path, text, sentence):
    (tmp_path / "classes").mkdir()
    (tmp_path / "classes" / "mine.yaml").write_text(f"name: mine\ntitle: mine\nof: motor\n{text}\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_classes(tmp_path)
    assert sentence in str(caught.value)
