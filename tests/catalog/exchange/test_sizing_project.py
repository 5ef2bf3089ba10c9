"""Sizing projects of IDTA 02021 from JSON, XML and AASX: the motion with its signs and units, and what is left."""

import json
import zipfile
from math import pi

import pytest
from click.testing import CliRunner

from torquerig.catalog.exchange.motion_file import Motion, joined, motion_file, read_motion
from torquerig.catalog.exchange.shell_file import write_shell
from torquerig.catalog.exchange.shell_tree import read_shell
from torquerig.catalog.exchange.sizing_project import read_sizing_project
from torquerig.catalog.exchange.sizing_submodel import (
    FIGURES,
    MOTION_FILE,
    SizedDriveRecord,
    SizedFigure,
    environment_of,
)
from torquerig.cli import group
from torquerig.errors import InputError
from torquerig.recordings.profiles.from_file import read_profile

NAN = float("nan")
BASE = "https://admin-shell.io/idta/PowerDriveTrainSizing"
CSV = "Time [s];AngularPosition [rad];AngularVelocity [rad/s];LoadTorque [Nm]\n0;0;0;-1\n5;50;20;-1\n60;1150;20;-3.8\n"


def prop(name, value):
    return {"idShort": name, "modelType": "Property", "valueType": "xs:double", "value": value}


def collection(name, *elements):
    return {"idShort": name, "modelType": "SubmodelElementCollection", "value": list(elements)}


def environment(*section):
    motion = collection("MotionPattern", collection("MotionPatternSections", collection("RotativeSection", *section)))
    ambient = {"idShort": "AmbientTemperatureMotor", "modelType": "Range", "min": "5", "max": "35"}
    belt = {"idShort": "BeltDrive", "modelType": "Entity", "statements": [prop("FeedConstant", "0.1")]}
    motor = {
        "idShort": "MainComponent01", "modelType": "Entity",
        "statements": [
            prop("MainComponentType", "Motor"), prop("ManufacturerName", "Maker"), prop("RmsOfMotorTorque", "0.4"),
        ],
    }  # fmt: skip
    submodel = {
        "idShort": "Whatever", "modelType": "Submodel", "id": "urn:x",
        "semanticId": {"type": "ModelReference", "keys": [{"type": "Submodel", "value": f"{BASE}/1/0"}]},
        "submodelElements": [
            collection(
                "SizingProjectInformation", prop("SizingProjectName", "Axis 7"), prop("SizingToolName", "Sizer")
            ),
            collection("ApplicationRequirements", motion, collection("Environmental", ambient)),
            collection("TransformationMechanism", belt),
            collection("SizingResult", motor),
        ],
    }  # fmt: skip
    return {"submodels": [submodel]}


FILE = {"idShort": "MotionSectionFile", "modelType": "File", "contentType": "text/csv", "value": "/aasx/files/m.csv"}


def package(tmp_path, text=CSV, *further):
    path = tmp_path / "drive.aasx"
    inertia = prop("MomentOfInertiaOfLoad", "0.02")
    write_shell(path, environment(inertia, FILE, *further), {"/aasx/files/m.csv": text.encode()})
    return path


def read(path):
    return read_sizing_project(read_shell(path), str(path))


def test_a_package_gives_motion_inertia_surroundings_and_what_is_left(tmp_path):
    project = read(package(tmp_path))
    assert (project.name, project.tool) == ("Axis 7", "Sizer")
    assert project.motion == Motion((0, 5, 60), (0, 20, 20), (1, 1, 3.8))
    assert project.inertias == (0.02,)
    assert project.ambient == (5, 35)
    assert project.mechanism == {"BeltDrive": {"FeedConstant": "0.1"}}
    assert project.components == ({"MainComponentType": "Motor", "ManufacturerName": "Maker"},)
    assert project.unused == ("SizingResult/MainComponent01/RmsOfMotorTorque = 0.4",)


def test_friction_and_load_of_a_whole_section_are_added(tmp_path):
    text = CSV.replace(";LoadTorque [Nm]", "").replace(";-1\n", "\n").replace(";-3.8\n", "\n")
    project = read(package(tmp_path, text, prop("LoadTorque", "-2"), prop("FrictionTorque", "0.5")))
    assert project.motion.torque == (2.5, 2.5, 2.5)


def test_units_of_the_columns_are_converted_and_the_mirrored_motion_has_the_same_torque():
    text = "Time [ms];AngularVelocity [1/min];LoadTorque [mNm]\n0;600;-1000\n500;600;-1000\n"
    motion = read_motion(text.encode(), "m.csv", {})
    assert motion.time == pytest.approx((0, 0.5))
    assert motion.speed == pytest.approx((20 * pi, 20 * pi))
    mirrored = read_motion(text.replace(";600;-", ";-600;").encode(), "m.csv", {})
    assert mirrored.torque == motion.torque == pytest.approx((1, 1))
    assert mirrored.speed == pytest.approx(tuple(-one for one in motion.speed))


@pytest.mark.parametrize("speeds", [(0.0, 20.0, 20.0, 0.0), (0.0, -20.0, -20.0, 0.0)])
def test_a_motion_that_is_written_is_read_back(speeds):
    motion = Motion((0.0, 1.0, 3.0, 4.0), speeds, (1.0, 2.0, 2.0, 0.5))
    again = read_motion(motion_file(motion).encode(), "m.csv", {})
    assert again == motion
    last = [float(one) for one in motion_file(motion).splitlines()[-1].split(";")]
    assert last[1] == pytest.approx(sum((0.5 * 1, 2, 0.5 * 1)) * speeds[1])


def test_sections_follow_one_another_with_a_short_step():
    one = Motion((0, 2), (10, 10), (1, 1))
    whole = joined([one, Motion((0, 4), (10, 10), (1, 1)), Motion((0, 1), (5, 5), (2, 2))])
    assert whole.time == pytest.approx((0, 2, 6, 6.001, 7))
    assert whole.speed == (10, 10, 10, 5, 5)
    assert joined([]) is None


def test_the_command_writes_a_profile_that_is_read(tmp_path):
    path = package(tmp_path)
    result = CliRunner().invoke(group, ["catalog", "import", str(path), str(tmp_path / "out")])
    assert result.exit_code == 0, result.exception
    rows, of_output = read_profile(tmp_path / "out" / "profile.csv")
    assert of_output
    assert rows.time == (0, 5, 60)
    assert rows.speed == pytest.approx((0, 20, 20))
    assert rows.load == (1, 1, 3.8)
    text = (tmp_path / "out" / "requirements.yaml").read_text(encoding="utf-8")
    assert "load_inertia: [0.02 kg*m^2]" in text
    assert "RmsOfMotorTorque = 0.4" in text
    again = CliRunner().invoke(group, ["catalog", "import", str(path), str(tmp_path / "out")])
    assert "is there already" in str(again.exception)


XML = f"""<environment xmlns="https://admin-shell.io/aas/3/0"><submodels><submodel><idShort>PowerDriveTrainSizing</idShort>
<semanticId><type>ModelReference</type><keys><key><type>Submodel</type><value>{BASE}/1/0</value></key></keys></semanticId>
<submodelElements><submodelElementCollection><idShort>SizingProjectInformation</idShort><value>
<property><idShort>SizingProjectName</idShort><valueType>xs:string</valueType><value>Axis 7</value></property>
<multiLanguageProperty><idShort>SizingProjectDescription</idShort><value><langStringTextType><language>en</language>
<text>lifts</text></langStringTextType></value></multiLanguageProperty></value></submodelElementCollection>
<submodelElementCollection><idShort>SizingResult</idShort><value><entity><idShort>MainComponent</idShort><statements>
<property><idShort>MainComponentType</idShort><value>Motor</value></property></statements></entity></value>
</submodelElementCollection></submodelElements></submodel></submodels></environment>"""


def test_xml_is_read_as_json_is(tmp_path):
    (tmp_path / "drive.xml").write_text(XML, encoding="utf-8")
    project = read(tmp_path / "drive.xml")
    assert project.name == "Axis 7"
    assert project.components == ({"MainComponentType": "Motor"},)
    assert project.unused == ("SizingProjectInformation/SizingProjectDescription = lifts",)


def test_a_sizing_that_is_written_is_read_back(tmp_path):
    figures = {"rms_torque": SizedFigure(NAN, 0.4, 0.5), "peak_torque_use": SizedFigure(0.2, NAN, NAN)}
    record = SizedDriveRecord(
        title="wear rig", tool="torquerig", date="2026-01-31T12:00:00Z", components=[("Motor", "M"), ("Gearbox", "G")],
        figures=figures, verdict="holds", has_motion=True,
    )  # fmt: skip
    made = environment_of(record, identifier="urn:uuid:1")
    motion = Motion((0.0, 1.0), (5.0, 5.0), (1.0, 1.0))
    path = tmp_path / "drive.aasx"
    write_shell(path, made, {MOTION_FILE: motion_file(motion).encode()})
    project = read(path)
    assert project.motion == motion
    assert [part["ManufacturerOrderCode"] for part in project.components] == ["M", "G"]
    assert "SizingResult/MainComponent01/RmsOfMotorTorque = 0.5" in project.unused
    assert "SizingResult/MainComponent01/MaxTorqueUtilizationPercentage = 20" in project.unused
    assert any("0.4 to 0.5 over open values" in one for one in project.unused)
    assert any("Gearbox, MaxTorqueUtilizationPercentage: not known" in one for one in project.unused)
    first = path.read_bytes()
    write_shell(path, made, {MOTION_FILE: motion_file(motion).encode()})
    assert path.read_bytes() == first


def test_the_use_of_several_gearboxes_is_not_written_as_that_of_one(tmp_path):
    record = SizedDriveRecord(
        title="t", tool="t", date="2026-01-31T12:00:00Z",
        components=[("Motor", "M"), ("Gearbox", "G"), ("Gearbox", "H")],
        figures={"gearbox_peak_use": SizedFigure(0.5, NAN, NAN)}, verdict="holds",
    )  # fmt: skip
    path = tmp_path / "drive.json"
    write_shell(path, environment_of(record, identifier="urn:uuid:1"), {})
    unused = read(path).unused
    assert not [one for one in unused if "MainComponent02/Max" in one or "MainComponent03/Max" in one]
    assert any("the worst of them" in one for one in unused)


def test_every_written_figure_is_one_of_a_sizing():
    from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS

    assert {figure for rows in FIGURES.values() for figure, _ in rows.values()} <= set(SIZING_UNITS)


BAD_TABLES = {
    "no unit": (CSV.replace("Time [s]", "Time"), "m.csv:1: the column Time has no unit; write 'Time [s]'"),
    "another unit": (CSV.replace("[Nm]", "[kg]"), "m.csv:1: the column LoadTorque: '1 kg' is a mass"),
    "no speed": (CSV.replace("AngularVelocity", "Speed"), "m.csv:1: the column AngularVelocity is missing"),
    "a decimal comma": (CSV.replace("-3.8", "-3,8"), "m.csv:4: LoadTorque is '-3,8', no number with a decimal point"),
    "a gap": (CSV.replace(";-3.8", ""), "m.csv:4: LoadTorque is '', no number"),
    "time back": (CSV.replace("60;", "4;"), "m.csv:4: the time does not rise"),
    "a driving load": (CSV.replace("-3.8", "3.8"), "m.csv:4: the load drives the motion with 3.8 N*m"),
    "one row": (CSV.splitlines()[0] + "\n0;0;0;0\n", "has 1 rows"),
}


@pytest.mark.parametrize(("text", "sentence"), BAD_TABLES.values(), ids=BAD_TABLES)
def test_a_bad_motion_table_is_refused_with_its_line(tmp_path, text, sentence):
    with pytest.raises(InputError) as caught:
        read(package(tmp_path, text))
    assert sentence in str(caught.value)


def test_a_missing_file_a_wrong_number_and_a_foreign_submodel_are_refused(tmp_path):
    path = tmp_path / "drive.json"
    path.write_text(json.dumps(environment(FILE)), encoding="utf-8")
    with pytest.raises(InputError, match=r"the motion file '/aasx/files/m\.csv' is not in the package"):
        read(path)
    path.write_text(json.dumps(environment(prop("MomentOfInertiaOfLoad", "much"))), encoding="utf-8")
    with pytest.raises(InputError, match="MomentOfInertiaOfLoad is 'much', no number"):
        read(path)
    path.write_text(json.dumps({"submodels": [{"idShort": "Nameplate"}]}), encoding="utf-8")
    with pytest.raises(InputError, match="holds 0 submodels PowerDriveTrainSizing"):
        read(path)
    path.write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match="holds no submodels"):
        read(path)


def hostile(name, tmp_path):
    path = tmp_path / "bad.aasx"
    if name == "deep JSON":
        path.write_text('{"submodels": ' + "[" * 100_000 + "]" * 100_000 + "}", encoding="utf-8")
    elif name == "entities":
        path.write_text('<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>', encoding="utf-8")
    elif name == "entities in UTF-16":
        path.write_bytes('<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>'.encode("utf-16"))
    elif name == "half an archive":
        path.write_bytes(b"PK\x03\x04 and no more")
    elif name == "NaN":
        path.write_text('{"submodels": [{"idShort": NaN}]}', encoding="utf-8")
    elif name == "no text":
        path.write_bytes(bytes(range(256)))
    elif name == "a bomb":
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("aasx/a.json", b" " * 30_000_000)
    elif name == "many elements":
        path.write_text(json.dumps({"submodels": [{"submodelElements": [{}] * 60_000}]}), encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "name",
    [
        "deep JSON",
        "entities",
        "entities in UTF-16",
        "half an archive",
        "NaN",
        "no text",
        "a bomb",
        "many elements",
        "none",
    ],
)
def test_a_hostile_file_is_refused_in_one_sentence(tmp_path, name):
    with pytest.raises(InputError) as caught:
        read(hostile(name, tmp_path))
    assert len(str(caught.value).splitlines()) == 1
    assert len(str(caught.value)) < 400


def test_a_path_out_of_the_package_reads_nothing_and_texts_stay_comments(tmp_path):
    outside = tmp_path / "secret.csv"
    outside.write_text(CSV, encoding="utf-8")
    path = tmp_path / "drive.aasx"
    write_shell(path, environment({**FILE, "value": f"../../..{outside}"}), {})
    with pytest.raises(InputError, match="is not in the package"):
        read(path)
    evil = prop("SizingProjectName", "a\nrig: {evil: true}\u2028b")
    made = environment(prop("LeverArmAxialForce", "1\nrig: {evil: true}"))
    made["submodels"][0]["submodelElements"][0]["value"] = [evil]
    write_shell(path, made, {})
    result = CliRunner().invoke(group, ["catalog", "import", str(path), str(tmp_path / "out")])
    assert result.exit_code == 0, result.exception
    text = (tmp_path / "out" / "requirements.yaml").read_text(encoding="utf-8")
    assert not [line for line in text.splitlines() if line.startswith("rig:")]
