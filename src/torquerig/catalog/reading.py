"""Catalog folders read into one catalog, in which motors are found by name or alias."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

from pydantic import TypeAdapter

from torquerig.catalog.coupling import Coupling
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.part_class import KINDS, PartClass, completed, values_adapter
from torquerig.catalog.printed.conversion import converted
from torquerig.catalog.printed.sheet import MotorSheet
from torquerig.catalog.sensor import Sensor
from torquerig.catalog.shelves import Catalog
from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError, did_you_mean
from torquerig.section_schema import schema_of

__all__ = ["SHELVES", "Catalog", "load_catalog", "read_classes", "read_entry"]

AnyEntry = TypeVar("AnyEntry", bound=Entry)
BLANK = "____"
SHELVES: dict[str, type[Entry]] = {"motors": Motor, "gearboxes": Gearbox, "sensors": Sensor, "couplings": Coupling}


def load_catalog(*folders: Path) -> Catalog:
    """Read catalog folders, each with any of motors/, gearboxes/, sensors/, couplings/, classes/: one file an entry.

    A later folder adds to the earlier ones, and its entries replace theirs of the same name. A class of any folder may
    be named in any other.

    Raises
    ------
    InputError
        When a folder is missing or has none of the five, when a file cannot be read, and when a name or alias occurs
        twice within one folder; with file, line and key.
    """
    shelves: dict[str, Any] = {shelf: {} for shelf in SHELVES}
    for folder in folders:
        _check_folder(folder)
    classes = read_classes(*folders)
    for folder in folders:
        for shelf, kind in SHELVES.items():
            for name, entry in _read_shelf(folder / shelf, kind, classes).items():
                shelves[shelf].pop(name, None)
                shelves[shelf][name] = entry
    return Catalog(**shelves, classes=classes)


def read_classes(*folders: Path) -> dict[str, PartClass]:
    """Return the classes of the folders ``classes`` in catalog folders; InputError with file, line and key."""
    found: dict[str, PartClass] = {}
    for folder in folders:
        seen: dict[str, Path] = {}
        for path in _files(folder / "classes"):
            part = _read_class(path)
            if part.name in seen:
                place = read_document(path).place(("name",))
                raise InputError(f"{place}: the name {part.name!r} is already in {seen[part.name]}; rename one of them")
            seen[part.name] = path
            found[part.name] = part
    return found


def _read_class(path: Path) -> PartClass:
    document = read_document(path)
    part = validated(document, schema_of(PartClass))
    values = validated(document, values_adapter(KINDS[part.of]), within=("values",))
    for name, value in estimates(values):
        if value.documented:
            place = document.place(("values", *name.split(".")))
            raise InputError(f"{place}: a class knows intervals only; write low and high, or one_of")
    return part


def read_entry(path: Path, kind: type[AnyEntry], classes: Mapping[str, PartClass] = MappingProxyType({})) -> AnyEntry:
    """Read one catalog file as an entry of ``kind``; InputError with file, line and key.

    Figures of a data sheet are converted, and what is not stated is filled from the class that ``like`` names.
    """
    adapter: TypeAdapter[AnyEntry] = schema_of(kind)
    document = read_document(path)
    _refuse_blanks(document, document.data, ())
    return validated(completed(_converted(document, kind), kind, classes), adapter)


def _refuse_blanks(document: Document, data: Any, keys: tuple[str | int, ...]) -> None:
    """Raise InputError at the first blank that ``torquerig catalog new`` left."""
    if isinstance(data, str) and BLANK in data:
        raise InputError(f"{document.place(keys)}: a blank is left; fill it, or delete the line")
    inner = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in inner:
        _refuse_blanks(document, value, (*keys, key))


def _converted(document: Document, kind: type[Entry]) -> Document:
    """Return a file with what is printed on a data sheet converted to the fields of the entry."""
    data = document.data
    if kind is not Motor or not isinstance(data, dict):
        return document
    for key in data:
        if key in MotorSheet.model_fields and key not in Motor.model_fields:
            raise InputError(f"{document.place((key,))}: is a figure of a data sheet; write it under as_printed:")
    if "as_printed" not in data:
        return document
    return converted(document, validated(document, schema_of(MotorSheet), within=("as_printed",)))


def _check_folder(folder: Path) -> None:
    if not folder.is_dir():
        raise InputError(f"{folder}: there is no such catalog folder; check the path")
    below = sorted(child.name for child in folder.iterdir() if child.is_dir() and any(child.glob("*.y*ml")))
    unknown = next((name for name in below if name not in SHELVES and name != "classes"), None)
    if unknown:
        raise InputError(f"{folder / unknown}: not a catalog folder; {did_you_mean(unknown, [*SHELVES, 'classes'])}")
    loose = next(iter(sorted(folder.glob("*.y*ml"))), None)
    if loose or not below:
        where = loose or folder
        raise InputError(f"{where}: a catalog file belongs into one of the folders {', '.join(SHELVES)}; put it there")


def _files(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.y*ml"), key=lambda file: file.name.lower())


def _read_shelf(folder: Path, kind: type[AnyEntry], classes: Mapping[str, PartClass]) -> dict[str, AnyEntry]:
    entries: dict[str, AnyEntry] = {}
    seen: dict[str, Path] = {}
    for path in _files(folder):
        entry = read_entry(path, kind, classes)
        for name, keys in _names(entry):
            if name in seen:
                place = read_document(path).place(keys)
                raise InputError(f"{place}: the name {name!r} is already in {seen[name]}; rename one of them")
            seen[name] = path
        entries[entry.name] = entry
    return entries


def _names(entry: Entry) -> Iterable[tuple[str, tuple[str | int, ...]]]:
    yield entry.name, ("name",)
    if isinstance(entry, Motor):
        for at, alias in enumerate(entry.aliases):
            yield alias.name, ("aliases", at, "name")
