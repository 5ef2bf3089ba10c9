"""The gear fields of OPC UA Powertrain: written, read back, and refused where a unit or number is not clear."""

from math import pi

import pytest
from click.testing import CliRunner

from torquerig.catalog.exchange.gear_attributes import UNIT_CODES, node_set, read_gear
from torquerig.catalog.exchange.untrusted import xml_of
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.reading import read_classes, read_entry
from torquerig.catalog.shipped import shipped_folder
from torquerig.cli import group
from torquerig.errors import InputError
from torquerig.units import kind_of

VALUES = {
    "ratio": 5.0, "backlash": 8 * pi / 10800, "stiffness": 11344.6, "input_inertia": 0.28e-4, "nominal_torque": 21.0,
    "efficiency": 0.97,
}  # fmt: skip
# as another program would write it: other indices, references instead of parents, N·m and percent
FOREIGN = """<?xml version="1.0" encoding="utf-8"?>
<UANodeSet xmlns="http://opcfoundation.org/UA/2011/03/UANodeSet.xsd"
 xmlns:x="http://opcfoundation.org/UA/2008/02/Types.xsd">
 <NamespaceUris><Uri>urn:maker</Uri><Uri>http://opcfoundation.org/UA/DI/</Uri>
  <Uri>http://opcfoundation.org/UA/Powertrain/</Uri></NamespaceUris>
 <UAObject NodeId="ns=1;s=gear" BrowseName="1:Gear7"><References>
  <Reference ReferenceType="HasTypeDefinition">ns=3;i=16503</Reference>
  <Reference ReferenceType="HasComponent">ns=1;s=r</Reference>
  <Reference ReferenceType="HasComponent">ns=1;s=t</Reference>
  <Reference ReferenceType="HasComponent">ns=1;s=e</Reference>
  <Reference ReferenceType="HasComponent">ns=1;s=n</Reference></References></UAObject>
 <UAVariable NodeId="ns=1;s=r" BrowseName="3:GearRatio_1"><Value><x:Float>10</x:Float></Value></UAVariable>
 <UAVariable NodeId="ns=1;s=ru" ParentNodeId="ns=1;s=r" BrowseName="EngineeringUnits">{one}</UAVariable>
 <UAVariable NodeId="ns=1;s=t" BrowseName="3:TorqueRated"><Value><x:Float>{torque}</x:Float></Value></UAVariable>
 <UAVariable NodeId="ns=1;s=tu" ParentNodeId="ns=1;s=t" BrowseName="EngineeringUnits">{newton}</UAVariable>
 <UAVariable NodeId="ns=1;s=e" BrowseName="3:EfficiencyRated"><Value><x:Float>96</x:Float></Value></UAVariable>
 <UAVariable NodeId="ns=1;s=eu" ParentNodeId="ns=1;s=e" BrowseName="EngineeringUnits">{percent}</UAVariable>
 <UAVariable NodeId="ns=1;s=n" BrowseName="3:SpeedRated"><Value><x:Float>3000</x:Float></Value></UAVariable>
</UANodeSet>"""


def unit(text="", code=""):
    number = f"<x:UnitId>{int.from_bytes(code.encode(), 'big')}</x:UnitId>" if code else ""
    shown = f"<x:DisplayName><x:Text>{text}</x:Text></x:DisplayName>" if text else ""
    body = f"<x:Body><x:EUInformation>{number}{shown}</x:EUInformation></x:Body>"
    return f"<Value><x:ExtensionObject>{body}</x:ExtensionObject></Value>"


def foreign(**changes):
    parts = {"one": unit(code="C62"), "newton": unit("N·m", "NU"), "percent": unit("%", "P1"), "torque": "12.5"}
    return FOREIGN.format(**{**parts, **changes})


def read(text):
    return read_gear(xml_of(text if isinstance(text, bytes) else text.encode(), "g.xml"), "g.xml")


def test_what_is_written_is_read_back():
    assert dict(read(node_set("mine", VALUES)).values) == pytest.approx(VALUES, rel=1e-8)


def test_a_node_set_of_another_program_is_read():
    gear = read(foreign())
    assert dict(gear.values) == pytest.approx({"ratio": 10, "nominal_torque": 12.5, "efficiency": 0.96})
    assert gear.unused == ("SpeedRated = 3000",)


def test_every_unit_code_has_a_unit():
    assert all(kind_of(text) for text in UNIT_CODES.values())


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (foreign(newton=unit()), "TorqueRated: has no EngineeringUnits; a number without unit is not taken over"),
        (foreign(newton=unit("kg")), "'12.5 kg' is a mass; a torque is wanted"),
        (foreign(newton=unit("N·m", "B32")), "the unit is 'N·m', but its code B32 is kg"),
        (foreign(torque="many"), "'many' is no finite number"),
        (foreign(torque="nan"), "'nan' is no finite number"),
        (foreign().replace("GearRatio_1", "TorqueRated_2"), "TorqueRated"),
        (foreign().replace("<x:Float>10<", "<x:Float>0.1<"), "a reduction above 1 is wanted"),
        (foreign().replace("16503", "16504"), "holds 0 objects of PtGearAttributesType"),
    ],
)
def test_what_is_not_clear_is_refused(text, sentence):
    with pytest.raises(InputError) as caught:
        read(text)
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


def run(*arguments):
    return CliRunner().invoke(group, ["catalog", *map(str, arguments)])


def test_the_commands_write_an_entry_that_is_read_once_its_blanks_are_deleted(tmp_path):
    file, entry = tmp_path / "g.xml", tmp_path / "mine.yaml"
    out = run("export", "NPT015-5", file).output
    assert "left out, not one number: backlash, input_inertia" in out
    assert "is there already" in str(run("export", "NPT015-5", file).exception)
    assert run("import", file, entry, "--like", "planetary-60mm-precision").exit_code == 0
    lines = [line for line in entry.read_text(encoding="utf-8").splitlines() if "____" not in line]
    entry.write_text("\n".join([*lines, 'title: "mine"']), encoding="utf-8")
    box = read_entry(entry, Gearbox, read_classes(shipped_folder()))
    assert box.ratio == 5
    assert box.nominal_torque.value == 21
    assert box.nominal_torque.note == "taken at the output"
    assert box.backlash.evidence == "CLASS"
    assert "is there already" in str(run("import", file, entry).exception)
