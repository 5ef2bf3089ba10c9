"""The gear fields of OPC UA Powertrain (OPC 40400-1, PtGearAttributesType) as a gearbox entry, and back.

Read and written is a node set (``UANodeSet``) with one object of that type. Names, data types and type ids are those of
the published node set 1.0.0 (2024-11-01). The public description does not say to which shaft a value refers: here
torque, rigidity and backlash are taken at the output and the inertia at the input, as gearbox makers print them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import isfinite
from xml.etree import ElementTree as ET

from torquerig.errors import InputError, UnitError
from torquerig.units import parse_quantity

POWERTRAIN = "http://opcfoundation.org/UA/Powertrain/"
NODES = "http://opcfoundation.org/UA/2011/03/UANodeSet.xsd"
TYPES = "http://opcfoundation.org/UA/2008/02/Types.xsd"
CEFACT = "http://www.opcfoundation.org/UA/units/un/cefact"
GEAR_TYPE = 16503  # PtGearAttributesType
ANALOG, PROPERTY, EU_INFORMATION = 17497, 68, 888

# browse name -> field of the entry, its unit here, and the meaning that the public description leaves open
FIELDS: Mapping[str, tuple[str, str, str]] = {
    "GearRatio": ("ratio", "1", ""),
    "Backlash": ("backlash", "arcmin", "taken as the full gap at the output"),
    "TorsionalRigidity": ("stiffness", "N*m/rad", "taken at the output"),
    "GearInertia": ("input_inertia", "kg*m^2", "taken at the input"),
    "TorqueRated": ("nominal_torque", "N*m", "taken at the output"),
    "Efficiency": ("efficiency", "1", ""),
}
NOT_TAKEN = ("SpeedRated", "AxialForceMax", "GearType", "LubricantType", "LubricantInterval")
UNIT_CODES: Mapping[str, str] = {"NU": "N*m", "B32": "kg*m^2", "D61": "arcmin", "DD": "deg", "C81": "rad", "P1": "%",
                                 "C62": "1", "M93": "N*m/rad"}  # fmt: skip
"""Common codes of UN/CEFACT Recommendation 20 to units here."""


@dataclass(frozen=True)
class GearAttributes:
    """What a node set says of a gear.

    Parameters
    ----------
    values : mapping of str to float
        By field of the entry [SI].
    notes : mapping of str to str
        What was assumed, by field.
    unused : tuple of str
        Fields that are stated and have no place in an entry, with their values.
    """

    values: Mapping[str, float]
    notes: Mapping[str, str]
    unused: tuple[str, ...]


def is_node_set(root: ET.Element) -> bool:
    """Return whether an XML document is a node set of OPC UA."""
    return str(root.tag).rpartition("}")[2] == "UANodeSet"


def read_gear(root: ET.Element, where: str) -> GearAttributes:
    """Return the one gear of a node set.

    Raises
    ------
    InputError
        Where there is no gear or several, a number or unit is missing or of another kind, or the ratio is below 1.
    """
    nodes = {str(one.get("NodeId")): one for one in root if one.get("NodeId")}
    gears = [key for key, one in nodes.items() if _is_gear(one, _index(root))]
    if len(gears) != 1:
        raise InputError(f"{where}: holds {len(gears)} objects of PtGearAttributesType; export one gear alone")
    values: dict[str, float] = {}
    notes: dict[str, str] = {}
    unused: list[str] = []
    for name, node in _variables(nodes, gears[0]):
        written = _value(node)
        if written is None:
            continue
        known = next((key for key in FIELDS if name.startswith(key)), None)
        if known is None:
            unused.append(f"{name} = {written}")
            continue
        field, unit, note = FIELDS[known]
        if field in values:
            raise InputError(f"{where}: {known} is stated twice; export the gear for one speed and one ratio")
        values[field] = _number(
            written, _unit(nodes, str(node.get("NodeId")), f"{where}: {name}"), unit, f"{where}: {name}"
        )
        notes[field] = note
    if values.get("ratio", 2.0) <= 1:
        raise InputError(f"{where}: GearRatio is {values['ratio']:g}; a reduction above 1 is wanted, input over output")
    return GearAttributes(values, notes, tuple(unused))


def _index(root: ET.Element) -> int:
    """Return the namespace index of the Powertrain model in this document; 0 where it is not named."""
    uris = [str(one.text).strip() for one in root.iter(f"{{{NODES}}}Uri")]
    return uris.index(POWERTRAIN) + 1 if POWERTRAIN in uris else 0


def _is_gear(node: ET.Element, index: int) -> bool:
    wanted = {f"ns={index};i={GEAR_TYPE}"} if index else set()
    kinds = {str(one.text).strip() for one in node.iter(f"{{{NODES}}}Reference")
             if one.get("ReferenceType") in ("HasTypeDefinition", "i=40")}  # fmt: skip
    return str(node.tag).endswith("}UAObject") and bool(wanted & kinds)


def _variables(nodes: Mapping[str, ET.Element], parent: str) -> Iterator[tuple[str, ET.Element]]:
    kinds = ("HasTypeDefinition", "i=40")
    forward = (one for one in nodes[parent].iter(f"{{{NODES}}}Reference") if one.get("IsForward") != "false")
    listed = {str(one.text).strip() for one in forward if one.get("ReferenceType") not in kinds}
    for key, node in nodes.items():
        if key in listed or node.get("ParentNodeId") == parent:
            yield str(node.get("BrowseName", "")).rpartition(":")[2], node


def _value(node: ET.Element) -> str | None:
    holder = node.find(f"{{{NODES}}}Value")
    inner = next(iter(holder), None) if holder is not None else None
    return None if inner is None or inner.text is None or not inner.text.strip() else inner.text.strip()


def _unit(nodes: Mapping[str, ET.Element], variable: str, where: str) -> str:
    """Return the unit of a variable as its display name, else by its code; they must agree where both are known."""
    for name, node in _variables(nodes, variable):
        if name != "EngineeringUnits":
            continue
        text = next((one.text.strip() for one in node.iter(f"{{{TYPES}}}Text") if one.text and one.text.strip()), "")
        number = next((one.text for one in node.iter(f"{{{TYPES}}}UnitId") if one.text), "")
        coded = UNIT_CODES.get(_code(number or ""), "")
        if text and coded and _disagree(text, coded):
            code = _code(number or "")
            raise InputError(f"{where}: the unit is {text!r}, but its code {code} is {coded}; correct one of them")
        if text or coded:
            return text or coded
    raise InputError(f"{where}: has no EngineeringUnits; a number without unit is not taken over, add them")


def _disagree(text: str, coded: str) -> bool:
    """Return whether two units are of one kind and not the same; a text that is not known does not disagree."""
    try:
        return abs(parse_quantity(f"1 {text}", coded) / parse_quantity(f"1 {coded}", coded) - 1) > 1e-9
    except UnitError:
        return text.strip() not in ("", "1", "-", "one")


def _code(number: str) -> str:
    """Return the common code of a unit id: its letters are the bytes of the number."""
    try:
        size = int(number)
        return size.to_bytes((size.bit_length() + 7) // 8, "big").decode("ascii") if 0 < size < 2**32 else ""
    except (ValueError, UnicodeDecodeError):
        return ""


def _number(text: str, unit: str, wanted: str, where: str) -> float:
    try:
        if not isfinite(float(text)):
            raise ValueError
        plain = "" if unit.strip() in ("1", "-", "one", ":1") and wanted == "1" else f" {unit}"
        return parse_quantity(f"{float(text)!r}{plain}", wanted)
    except ValueError:
        raise InputError(f"{where}: {text!r} is no finite number; correct it") from None
    except UnitError as error:
        raise InputError(f"{where}: {error}") from None


def node_set(name: str, values: Mapping[str, float]) -> bytes:
    """Return a node set with one PtGearAttributes object; ``values`` by field of the entry [SI]."""
    ET.register_namespace("", NODES)
    ET.register_namespace("uax", TYPES)
    root = ET.Element(f"{{{NODES}}}UANodeSet")
    uris = ET.SubElement(root, f"{{{NODES}}}NamespaceUris")
    for uri in (f"urn:torquerig:{name}", POWERTRAIN):
        ET.SubElement(uris, f"{{{NODES}}}Uri").text = uri
    parts = [key for key, (field, _, _) in FIELDS.items() if field in values]
    numbers = {key: 1001 + 2 * at for at, key in enumerate(parts)}
    gear = _node(root, "UAObject", 1000, "1:PtGearAttributes", {"HasTypeDefinition": f"ns=2;i={GEAR_TYPE}"})
    for number in numbers.values():
        _reference(gear, "HasComponent", f"ns=1;i={number}")
    codes = {unit: code for code, unit in UNIT_CODES.items()}
    for key, number in numbers.items():
        field, unit, _ = FIELDS[key]
        node = _node(
            root, "UAVariable", number, f"2:{key}", {"HasTypeDefinition": f"i={ANALOG}"}, parent=1000, data="i=10"
        )
        _reference(node, "HasProperty", f"ns=1;i={number + 1}")
        value = ET.SubElement(ET.SubElement(node, f"{{{NODES}}}Value"), f"{{{TYPES}}}Float")
        value.text = f"{values[field] / parse_quantity(f'1 {unit}' if unit != '1' else '1', unit):.9g}"
        _units(root, number, unit, codes[unit])
    ET.indent(root)
    text: bytes = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _node(root: ET.Element, kind: str, number: int, browse_name: str, references: Mapping[str, str], *,
          parent: int = 0, data: str = "") -> ET.Element:  # fmt: skip
    node = ET.SubElement(root, f"{{{NODES}}}{kind}", NodeId=f"ns=1;i={number}", BrowseName=browse_name)
    if parent:
        node.set("ParentNodeId", f"ns=1;i={parent}")
    if data:
        node.set("DataType", data)
    ET.SubElement(node, f"{{{NODES}}}DisplayName").text = browse_name.rpartition(":")[2]
    ET.SubElement(node, f"{{{NODES}}}References")
    for name, target in references.items():
        _reference(node, name, target)
    return node


def _reference(node: ET.Element, name: str, target: str) -> None:
    kinds = {"HasTypeDefinition": "i=40", "HasComponent": "i=47", "HasProperty": "i=46"}
    holder = node.find(f"{{{NODES}}}References")
    assert holder is not None
    ET.SubElement(holder, f"{{{NODES}}}Reference", ReferenceType=kinds[name]).text = target


def _units(root: ET.Element, variable: int, unit: str, code: str) -> None:
    node = _node(root, "UAVariable", variable + 1, "EngineeringUnits", {"HasTypeDefinition": f"i={PROPERTY}"},
                 parent=variable, data="i=887")  # fmt: skip
    body = ET.SubElement(ET.SubElement(node, f"{{{NODES}}}Value"), f"{{{TYPES}}}ExtensionObject")
    ET.SubElement(ET.SubElement(body, f"{{{TYPES}}}TypeId"), f"{{{TYPES}}}Identifier").text = f"i={EU_INFORMATION}"
    held = ET.SubElement(ET.SubElement(body, f"{{{TYPES}}}Body"), f"{{{TYPES}}}EUInformation")
    ET.SubElement(held, f"{{{TYPES}}}NamespaceUri").text = CEFACT
    ET.SubElement(held, f"{{{TYPES}}}UnitId").text = str(int.from_bytes(code.encode(), "big"))
    shown = ET.SubElement(held, f"{{{TYPES}}}DisplayName")
    ET.SubElement(shown, f"{{{TYPES}}}Text").text = unit
