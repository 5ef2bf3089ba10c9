"""Catalog folders are read into one catalog, and what is wrong in a file is said with file, line, key and remedy."""

from pathlib import Path

import pytest

from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import load_catalog, read_entry
from torquerig.catalog.shipped import shipped_folder
from torquerig.errors import InputError, UnknownNameError

# reference report, Table II, first column; INNOMOTICS is the maker of the last
TABLE_II = [
    "HDS60-0102A",
    "HDS6A-0102A",
    "HDS60-0104A",
    "HDS6A-0104A",
    "ESM04X-101-302",
    "ESM06X-201-302",
    "ESM06X-401-302",
    "ESM013B-152-304",
    "INNOMOTICS GP-71M",
]
# reference report, Tables III-V and VI, in the order of their columns
NAMES_OF_LATER_TABLES = {
    "REF": "bldc-12n14p",
    "HDS5C-102A": "HDS6A-0102A",
    "HDS6A-104A": "HDS6A-0104A",
    "ESI MAX-401-302": "ESM06X-401-302",
    "ESI MAX-101-302": "ESM04X-101-302",
    "ESI HD1230-S3A": "ESM013B-152-304",
    "ESM0x-401-302": "ESM06X-401-302",
    "ESM01-38-153-20": "ESM013B-152-304",
}


@pytest.fixture(scope="module")
def shipped():
    return load_catalog(shipped_folder())


@pytest.fixture
def own(tmp_path):
    """A catalog folder with a copy of the shipped HDS6A-0104A under another name."""
    text = (shipped_folder() / "motors" / "HDS6A-0104A.yaml").read_text(encoding="utf-8")
    start, end = text.index("aliases:"), text.index("warnings:")
    text = text.replace(text[start:end], "").replace("name: HDS6A-0104A", "name: my-motor")
    (tmp_path / "motors").mkdir()
    (tmp_path / "motors" / "mine.yaml").write_text(text, encoding="utf-8")
    return tmp_path


def rewrite(folder, old, new):
    path = folder / "motors" / "mine.yaml"
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1
    path.write_text(text.replace(old, new), encoding="utf-8")
    return text[: text.index(old)].count("\n") + 1


def test_every_shipped_file_is_read_and_is_named_as_its_file(shipped):
    for shelf in ("motors", "gearboxes", "sensors", "couplings"):
        files = {path.stem for path in (shipped_folder() / shelf).glob("*.yaml")}
        assert files == set(getattr(shipped, shelf))


def test_the_nine_motors_of_table_ii_and_the_motor_of_the_rig_are_there(shipped):
    real = {shipped.motor(name).stands_for or name for name in TABLE_II}
    assert real | {"bldc-12n14p"} == set(shipped.motors)
    assert len(real) == 9


@pytest.mark.parametrize(("alias", "real"), NAMES_OF_LATER_TABLES.items())
def test_an_alias_keeps_its_name_and_tells_what_it_stands_for_and_why(shipped, alias, real):
    motor = shipped.motor(alias)
    assert (motor.name, motor.stands_for) == (alias, real)
    assert motor.rated_torque == shipped.motor(real).rated_torque
    why = shipped.resolved(alias)
    assert "Table" in why.table
    assert why.reason
    assert shipped.resolved(real) is None


def test_the_chosen_motor_has_the_numbers_of_table_vii(shipped):
    motor = shipped.motor("HDS6A-0104A")
    table = {"rated_torque": 1.27, "stall_torque": 1.4, "peak_torque": 4.46, "supply_voltage": 230.0}
    assert {field: getattr(motor, field).value for field in table} == table
    assert (motor.rated_speed.shown(), motor.max_speed.shown()) == ("3000 rpm", "6000 rpm")
    stated = [*table, "rated_speed", "max_speed"]
    assert all(getattr(motor, field).documented and getattr(motor, field).evidence == "DOC" for field in stated)


def test_an_unknown_motor_is_refused_with_the_close_names(shipped):
    with pytest.raises(UnknownNameError, match=r"no motor 'HDS6A-0104' .*did you mean .*'HDS6A-0104A'"):
        shipped.motor("HDS6A-0104")
    with pytest.raises(UnknownNameError, match=r"no gearbox 'economy-5'.*'economy-5-1'"):
        shipped.gearbox("economy-5")


def test_a_motor_added_by_one_file_in_a_second_folder_is_found_beside_the_shipped(own):
    catalog = load_catalog(shipped_folder(), own)
    assert catalog.motor("my-motor").rated_torque.value == 1.27
    assert len(catalog.motors) == 11


def test_a_later_folder_overrides_an_earlier_one_by_name(own):
    rewrite(own, "name: my-motor", "name: HDS6A-0104A")
    rewrite(own, "value: 1.27 N*m", "value: 1.30 N*m")
    catalog = load_catalog(shipped_folder(), own)
    assert catalog.motor("HDS6A-0104A").rated_torque.value == 1.30
    assert len(catalog.motors) == 10


def test_a_real_motor_of_an_aliased_name_wins_over_the_alias(own):
    rewrite(own, "name: my-motor", "name: HDS5C-102A")
    catalog = load_catalog(shipped_folder(), own)
    assert catalog.motor("HDS5C-102A").stands_for == ""
    assert catalog.resolved("HDS5C-102A") is None


BROKEN = {
    "a bare number": ("value: 1.27 N*m", "value: 1.27", "rated_torque: 1.27 has no unit; write '1.27 N*m'"),
    "no evidence": (
        'rated_torque: {value: 1.27 N*m, evidence: DOC, source: "reference report, Table VII"}',
        "rated_torque: 1.27 N*m",
        "rated_torque: '1.27 N*m' needs its evidence; write a mapping",
    ),
    "a misspelt key": ("rotor_inertia:", "rotor_inetria:", "unknown key; did you mean 'rotor_inertia'"),
    "a wrong unit": ("value: 1.27 N*m", "value: 1.27 N", "rated_torque: '1.27 N' is a force; a torque is wanted"),
    "a negative inertia": ("value: 0.48e-4 kg*m^2, low: 0.17e-4", "low: -0.17e-4", "rotor inertia must be more than 0"),
    "half a choice": ("pole_pairs: {one_of: [4, 5]", "pole_pairs: {one_of: [4.5]", "4.5 is not a whole number"),
    "an unwindable pair": ("slots: {one_of: [9, 12]", "slots: {one_of: [8]", "no three-phase winding exists"),
    "a peak below the rating": ("value: 4.46 N*m", "value: 1 N*m", "peak_torque: 1 N*m is below rated_torque"),
    "a constant per peak ampere": (
        "low: 0.5 N*m/Arms, high: 0.55 N*m/Arms",
        "low: 0.35 N*m/Arms, high: 0.38 N*m/Arms",
        "torque_constant: ? (0.35..0.38 N*m/Arms) does not agree within 10 % below",
    ),
    "a quoted yes": ("servo: {value: true", "servo: {value: 'yes'", "servo.value: input should be a valid boolean"),
}


@pytest.mark.parametrize(("old", "new", "sentence"), BROKEN.values(), ids=BROKEN)
def test_what_is_wrong_is_said_with_file_line_and_key(own, old, new, sentence):
    line = rewrite(own, old, new)
    with pytest.raises(InputError) as caught:
        load_catalog(own)
    said = [text for text in str(caught.value).splitlines() if f"mine.yaml:{line}: " in text]
    assert any(sentence in text for text in said), caught.value


def test_a_misspelt_key_is_told_in_one_sentence(own):
    line = rewrite(own, "rotor_inertia:", "rotor_inetria:")
    with pytest.raises(InputError) as caught:
        load_catalog(own)
    place = f"{own / 'motors' / 'mine.yaml'}:{line}"
    assert str(caught.value) == f"{place}: rotor_inetria: unknown key; did you mean 'rotor_inertia'?"


def test_a_missing_value_that_a_simulation_needs_is_named(own):
    path = own / "motors" / "mine.yaml"
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("coulomb_friction")]
    path.write_text("\n".join(lines), encoding="utf-8")
    with pytest.raises(InputError, match="the key 'coulomb_friction' is missing; add it"):
        load_catalog(own)


def test_stands_for_is_not_a_key_of_a_file(own):
    rewrite(own, "kind: pmsm", "kind: pmsm\nstands_for: HDS6A-0104A")
    with pytest.raises(InputError, match="stands_for: this is set when an alias is looked up"):
        load_catalog(own)


def test_a_name_or_alias_that_stands_twice_in_one_folder_is_refused(own):
    text = (own / "motors" / "mine.yaml").read_text(encoding="utf-8")
    second = text.replace(
        "name: my-motor", "name: other\naliases:\n  - {name: my-motor, table: my list, reason: the same}"
    )
    (own / "motors" / "other.yaml").write_text(second, encoding="utf-8")
    with pytest.raises(InputError, match=r"other\.yaml:\d+: aliases\.0\.name: the name 'my-motor' is already in"):
        load_catalog(own)


def test_a_missing_file_or_folder_is_named_with_the_close_match(own):
    with pytest.raises(InputError, match=r"mime\.yaml: there is no such file; did you mean 'mine\.yaml'"):
        read_entry(own / "motors" / "mime.yaml", Motor)
    with pytest.raises(InputError, match="there is no such catalog folder"):
        load_catalog(own / "nowhere")


def test_a_file_in_the_wrong_place_is_not_passed_over_in_silence(own):
    (own / "motors").rename(own / "motor")
    with pytest.raises(InputError, match="motor: not a catalog folder; did you mean 'motors'"):
        load_catalog(own)
    (own / "motor" / "mine.yaml").rename(own / "mine.yaml")
    with pytest.raises(InputError, match=r"mine\.yaml: a catalog file belongs into one of the folders motors,"):
        load_catalog(own)


def test_the_shipped_folders_lie_side_by_side():
    assert shipped_folder().name == "catalogs"
    assert isinstance(shipped_folder(), Path)
