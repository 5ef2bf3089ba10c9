"""What of a scenario a what-if offers to change: motor, gearbox, ratio, speed, load and filter chain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.filters.chains.chain_file import chain_texts
from torquerig.studio.what_if.engine import chain_file
from torquerig.study.definition import open_study

SPEEDS = ("output_speed", "motor_speed")


@dataclass(frozen=True, kw_only=True)
class ChangeableNumber:
    """A number that can be changed: its keys in the scenario, its name, and how it is written there."""

    keys: tuple[str, ...]
    label: str
    written: str


@dataclass(frozen=True, kw_only=True)
class Changeable:
    """What can be changed.

    Parameters
    ----------
    motor, gearbox : str
        As the scenario states them; empty where its study exchanges none.
    motors, gearboxes : tuple of str
        Entries that can replace them.
    numbers : tuple of ChangeableNumber
    chain : str
        The present filter chain.
    chains : tuple of str
    """

    motor: str
    gearbox: str
    motors: tuple[str, ...]
    gearboxes: tuple[str, ...]
    numbers: tuple[ChangeableNumber, ...]
    chain: str
    chains: tuple[str, ...]


def changeable(text: str, path: Path, catalog: Catalog) -> Changeable:
    """Return what of a scenario can be changed; InputError where its text or its study cannot be used."""
    document = parse_document(text, path)
    data = document.data
    if not isinstance(data, dict):
        raise InputError(f"{path}: is no scenario; a scenario has the sections operating_point and rig")
    chains = tuple(chain_texts(read_document(chain_file(path, data))))
    if "study" not in data:
        return Changeable(motor="", gearbox="", motors=(), gearboxes=(), numbers=_operating_point(data),
                          chain=chains[0], chains=chains)  # fmt: skip
    study = open_study(document, catalog)
    parts, present = study.exchanged, study.settings.present
    written = data["rig"][parts.motor]
    return Changeable(
        motor=str(written.get("catalog", "")), motors=tuple(catalog.motors), gearbox=study.present_gearbox,
        gearboxes=tuple(dict.fromkeys((*study.gearboxes, *catalog.gearboxes))) if parts.stage else (),
        numbers=(*_ratio(data, parts.stage), *_operating_point(data)), chain=present.filter, chains=chains,
    )  # fmt: skip


def _ratio(data: Mapping[str, Any], stage: str) -> tuple[ChangeableNumber, ...]:
    if not stage:
        return ()
    keys = ("rig", stage, "ratio")
    return (ChangeableNumber(keys=keys, label=f"ratio of {stage}", written=_text(data["rig"][stage].get("ratio"))),)


def _operating_point(data: Mapping[str, Any]) -> tuple[ChangeableNumber, ...]:
    point = data.get("operating_point")
    if not isinstance(point, dict):
        return ()
    stated: dict[tuple[str, ...], Any] = {("operating_point", name): point[name] for name in SPEEDS if name in point}
    load = point.get("load")
    if isinstance(load, dict):
        stated |= {("operating_point", "load", str(name)): value for name, value in load.items()}
    return tuple(
        ChangeableNumber(keys=keys, label=keys[-1].replace("_", " "), written=_text(value))
        for keys, value in stated.items()
        if not isinstance(value, dict | list)
    )


def _text(value: Any) -> str:
    return "" if value is None else str(value)
