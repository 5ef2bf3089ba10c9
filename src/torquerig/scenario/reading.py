"""From a scenario file to a Rig: parts in their order, catalog values filled in, uncertainties kept beside."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, get_args, get_type_hints

from pydantic import TypeAdapter

from torquerig import mechanisms
from torquerig.catalog.reading import Catalog
from torquerig.document import Document, validated
from torquerig.errors import InputError, did_you_mean
from torquerig.parameter import Estimate
from torquerig.rig import parts
from torquerig.rig.part import Part
from torquerig.rig.rig import Rig
from torquerig.scenario.from_catalog import Filled, filled_from_catalog
from torquerig.scenario.operating_point import OperatingPoint, run_at

KINDS: dict[str, type[Part]] = {
    get_args(get_type_hints(cls)["kind"])[0]: cls
    for room in (parts, mechanisms)
    for cls in (getattr(room, name) for name in room.__all__)
}
"""Every kind of part and effect that a scenario may name, by the word it uses."""


@dataclass(frozen=True)
class Scenario:
    """A scenario file that has been read.

    Parameters
    ----------
    rig : Rig
        At the operating point, with nominal values, and drawn ones where the catalog has only an interval.
    uncertainties : mapping of str to Estimate
        By ``part.field``: what a calibration may move.
    assumed : mapping of str to str
        By ``part.field``: what was drawn, and from which interval.
    """

    document: Document
    title: str
    operating_point: OperatingPoint
    rig: Rig
    uncertainties: Mapping[str, Estimate] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)


def read_scenario(document: Document, catalog: Catalog, *, seed: int) -> Scenario:
    """Return the scenario of a document; ``seed`` fixes what is drawn where the catalog has only an interval.

    Raises
    ------
    InputError
        With file, line, key and remedy, for everything that cannot be used.
    """
    data = document.data
    if not isinstance(data, dict) or not isinstance(data.get("rig"), dict):
        raise InputError(f"{document.path}: a scenario needs a mapping named rig: with one entry per part")
    point = validated(document, TypeAdapter(OperatingPoint), within=("operating_point",)) if (
        "operating_point" in data) else OperatingPoint()  # fmt: skip
    found: list[Part] = []
    uncertainties: dict[str, Estimate] = {}
    assumed: dict[str, str] = {}
    shaft: str | None = None
    for name, written in data["rig"].items():
        filled = _filled(document, name, written, catalog, seed)
        for item in (filled, *filled.effects):
            part = _part(document, name, item, shaft)
            found.append(part)
            for key, spread in item.uncertainties.items():
                uncertainties[f"{part.name}.{key}"] = Estimate(getattr(part, key), rel_sd=spread, evidence="REF")
            assumed.update({f"{part.name}.{key}": text for key, text in item.assumed.items()})
            shaft = part.name if part.on_shaft else shaft
    measured = str(data.get("measured", "torque_sensor"))
    rig = Rig(tuple(found), measured=measured)
    if not rig.part(measured).opens_node:
        raise InputError(f"{document.place(('measured',))}: {measured!r} has no spring whose torque could be read")
    return Scenario(document, str(data.get("scenario", document.path.stem)), point, rig.at(run_at(point, rig)),
                    uncertainties, assumed)  # fmt: skip


def _filled(document: Document, name: str, written: Any, catalog: Catalog, seed: int) -> Filled:
    place = document.place(("rig", name))
    if not isinstance(written, dict) or "kind" not in written:
        raise InputError(f"{place}: a part needs its kind; add kind: with one of {', '.join(sorted(KINDS))}")
    if written["kind"] not in KINDS:
        raise InputError(
            f"{document.place(('rig', name, 'kind'))}: {written['kind']!r} is no kind of part; "
            f"{did_you_mean(str(written['kind']), KINDS)}"
        )
    own, uncertainties = _uncertain(written)
    entry = own.pop("catalog", None)
    if entry is None:
        return Filled(name=name, values=own, uncertainties=uncertainties)
    filled = filled_from_catalog(catalog, str(entry), kind=own["kind"], name=name, seed=seed, place=place)
    kept = {key: text for key, text in filled.assumed.items() if key not in own}
    spread = {key: value for key, value in filled.uncertainties.items() if key not in own}
    return Filled(name=name, values={**filled.values, **own}, uncertainties={**spread, **uncertainties}, assumed=kept,
                  effects=filled.effects)  # fmt: skip


def _uncertain(written: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, float]]:
    """Take ``{value: ..., rel_sd: ...}`` apart: the value goes to the part, the spread to the calibration."""
    stated = {key: value for key, value in written.items() if isinstance(value, dict) and "value" in value}
    values = {key: value["value"] if key in stated else value for key, value in written.items()}
    return values, {key: float(value["rel_sd"]) for key, value in stated.items() if "rel_sd" in value}


def _part(document: Document, name: str, item: Filled, shaft: str | None) -> Part:
    cls = KINDS[item.values["kind"]]
    data = {"name": item.name, **item.values}
    if cls.on_shaft:
        data.setdefault("after", shaft)
    adapter: TypeAdapter[Part] = TypeAdapter(cls)
    return validated(document, adapter, within=("rig", name), data=data)
