"""A sizing as a submodel of IDTA 02021-1-0: project, motion and load, components with their use, messages.

The template declares its numbers as ``xs:long`` and describes them as REAL_MEASURE; fractions do not fit into a long,
so they are written as ``xs:double``. Only values are written whose unit the public template states or whose name is a
percentage. A figure that is an interval is written with its worse end, and the interval as a message.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isnan
from typing import Any

BASE = "https://admin-shell.io/idta/PowerDriveTrainSizing"
ECLASS = {"ManufacturerName": "0173-1#02-AAO677#002", "ManufacturerArticleNumber": "0173-1#02-AAO676#003",
          "ManufacturerOrderCode": "0173-1#02-AAO227#002"}  # fmt: skip
NOT_KNOWN = "not known"
MOTION_FILE = "/aasx/files/motion.csv"

# component -> idShort -> (figure of ``torquerig size``, factor)
FIGURES: dict[str, dict[str, tuple[str, float]]] = {
    "Motor": {
        "RmsOfMotorTorque": ("rms_torque", 1.0),
        "MaxTorqueUtilizationPercentage": ("peak_torque_use", 100.0),
        "MaxRotationSpeedUtilizationPercentage": ("speed_limit_use", 100.0),
        "MaxThermalUtilizationPercentage": ("thermal_use", 100.0),
        "MaxCurrentUtilizationPercentage": ("peak_current_use", 100.0),
        "MassInertiaRatio": ("inertia_ratio", 1.0),
    },
    "Gearbox": {
        "MaxTorqueUtilizationPercentage": ("gearbox_peak_use", 100.0),
        "MaxRotationSpeedUtilizationPercentage": ("gearbox_speed_use", 100.0),
    },
}


@dataclass(frozen=True)
class SizedFigure:
    """One figure [SI]: value, and interval; NaN where there is none."""

    value: float
    low: float
    high: float

    @property
    def worst(self) -> float:
        """The larger end, else the value."""
        return self.value if isnan(self.high) else self.high


@dataclass(frozen=True)
class SizedDriveRecord:
    """What is written.

    Parameters
    ----------
    title, tool, date : str
        Name of the project, of this program with its version, and date and time in UTC (``2026-01-31T12:00:00Z``).
    components : sequence of (str, str)
        ``Motor`` or ``Gearbox``, and the name in the catalog. The figures of gearboxes are written where there is one
        of them: of several they are those of the gearbox that uses most of its limits.
    figures : mapping of str to SizedFigure
        By the names of ``torquerig size``.
    verdict : str
        One sentence.
    has_motion : bool
        Whether the package holds the motion of the load as ``MOTION_FILE``.
    """

    title: str
    tool: str
    date: str
    components: Sequence[tuple[str, str]]
    figures: Mapping[str, SizedFigure]
    verdict: str
    has_motion: bool = False


def environment_of(record: SizedDriveRecord, *, identifier: str) -> dict[str, Any]:
    """Return the environment with one shell and its submodel; ``identifier`` is the start of their ids (an IRI)."""
    submodel = {
        "idShort": "PowerDriveTrainSizing", "id": f"{identifier}/submodel", "kind": "Instance",
        "semanticId": _reference("", kind="Submodel"), "modelType": "Submodel",
        "submodelElements": [_project(record), _requirements(record), _result(record)],
    }  # fmt: skip
    key = {"type": "Submodel", "value": submodel["id"]}
    shell = {
        "idShort": "SizedDrive", "id": f"{identifier}/shell", "modelType": "AssetAdministrationShell",
        "assetInformation": {"assetKind": "Instance", "globalAssetId": f"{identifier}/asset"},
        "submodels": [{"type": "ModelReference", "keys": [key]}],
    }  # fmt: skip
    return {"assetAdministrationShells": [shell], "submodels": [submodel]}


def _project(record: SizedDriveRecord) -> dict[str, Any]:
    texts = {"ClientName": NOT_KNOWN, "SizingProjectName": record.title, "SizingToolName": record.tool}
    elements = [_property(key, text, "xs:string") for key, text in texts.items()]
    elements += [_property(key, record.date, "xs:dateTime") for key in ("DateCreated", "DateChanged")]
    return _collection("SizingProjectInformation", elements, meaning="SizingProjectInformation1/0")


def _requirements(record: SizedDriveRecord) -> dict[str, Any]:
    if not record.has_motion:
        return _collection("ApplicationRequirements", [])
    file = {
        "idShort": "MotionSectionFile", "modelType": "File", "contentType": "text/csv", "value": MOTION_FILE,
        "semanticId": _reference("MotionSectionFile/1/0"),
    }  # fmt: skip
    section = _collection("RotativeSection", [file], meaning="RotativeMotionPatternSection/1/0")
    sections = _collection("MotionPatternSections", [section])
    return _collection("ApplicationRequirements", [_collection("MotionPattern", [sections])])


def _result(record: SizedDriveRecord) -> dict[str, Any]:
    parts = [_component(kind, name, record, number) for number, (kind, name) in enumerate(record.components, 1)]
    messages = [
        _message(f"Message{number:02d}", word, text) for number, (word, text) in enumerate(_messages(record), 1)
    ]
    return _collection("SizingResult", [*parts, _collection("Messages", messages)])


def _component(kind: str, name: str, record: SizedDriveRecord, number: int) -> dict[str, Any]:
    texts = {"ManufacturerName": NOT_KNOWN, "ManufacturerArticleNumber": name, "ManufacturerOrderCode": name}
    elements = [_property("MainComponentType", kind, "xs:string")]
    elements += [_property(key, text, "xs:string", meaning=ECLASS[key]) for key, text in texts.items()]
    for id_short, (figure, factor) in _figures(record, kind).items():
        held = record.figures.get(figure)
        if held is not None and not isnan(held.worst):
            elements.append(_property(id_short, f"{held.worst * factor:.9g}", "xs:double"))
    return {
        "idShort": f"MainComponent{number:02d}", "modelType": "Entity", "entityType": "CoManagedEntity",
        "semanticId": _reference("MainComponent/1/0"), "statements": elements,
    }  # fmt: skip


def _figures(record: SizedDriveRecord, kind: str) -> Mapping[str, tuple[str, float]]:
    return {} if _of_several(record, kind) else FIGURES[kind]


def _of_several(record: SizedDriveRecord, kind: str) -> bool:
    return sum(one == kind for one, _ in record.components) > 1


def _messages(record: SizedDriveRecord) -> Sequence[tuple[str, str]]:
    found = [("Information", record.verdict)]
    if _of_several(record, "Gearbox"):
        found.append(("Warning", "The use of the gearboxes is not written: the sizing gives that of the worst of them"))
    for kind in dict.fromkeys(kind for kind, _ in record.components):
        for id_short, (figure, factor) in _figures(record, kind).items():
            held = record.figures.get(figure)
            if held is None or isnan(held.worst):
                found.append(("Warning", f"{kind}, {id_short}: not known, because the catalog leaves data open"))
            elif not isnan(held.low):
                ends = f"{held.low * factor:.4g} to {held.high * factor:.4g}"
                text = f"{kind}, {id_short}: {ends} over open values of the catalog; the larger is written"
                found.append(("Information", text))
    return found


def _message(id_short: str, word: str, text: str) -> dict[str, Any]:
    body = {
        "idShort": "MessageText", "modelType": "MultiLanguageProperty", "semanticId": _reference("MessageText/1/0"),
        "value": [{"language": "en", "text": text}],
    }  # fmt: skip
    return _collection(id_short, [_property("CriticalityOfMessage", word, "xs:string"), body], meaning="Message/1/0")


def _collection(id_short: str, elements: list[dict[str, Any]], *, meaning: str = "") -> dict[str, Any]:
    held = {
        "idShort": id_short, "modelType": "SubmodelElementCollection",
        "semanticId": _reference(meaning or f"{id_short}/1/0"),
    }  # fmt: skip
    return {**held, "value": elements} if elements else held  # the metamodel allows no empty list


def _property(id_short: str, value: str, kind: str, *, meaning: str = "") -> dict[str, Any]:
    return {
        "idShort": id_short, "modelType": "Property", "valueType": kind, "value": value,
        "semanticId": _reference(meaning or f"{id_short}/1/0"),
    }  # fmt: skip


def _reference(meaning: str, *, kind: str = "GlobalReference") -> dict[str, Any]:
    value = meaning if meaning.startswith("0173") else f"{BASE}/{meaning or '1/0'}"
    whole = "ModelReference" if kind == "Submodel" else "ExternalReference"
    return {"type": whole, "keys": [{"type": kind, "value": value}]}
