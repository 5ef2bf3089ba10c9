"""Catalog folders that a scenario or a command reads."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from torquerig.catalog.shelves import Catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.catalog.unread import unread_catalog
from torquerig.errors import InputError
from torquerig.extensions import extensions


def catalog_for(scenario: Path | None, further: Sequence[Path] = ()) -> Catalog:
    """Return all catalogs of a scenario, merged; an entry of a later folder replaces one of an earlier."""
    from torquerig.catalog.reading import load_catalog

    return load_catalog(*catalog_folders(scenario, further))


def unread_catalog_for(scenario: Path | None, further: Sequence[Path] = ()) -> Catalog:
    """Return the catalog of :func:`catalog_for`, whose entries are read when the first one is looked up."""
    return unread_catalog(*catalog_folders(scenario, further))


def catalog_folders(scenario: Path | None, further: Sequence[Path] = ()) -> list[Path]:
    """Return the catalog folders of a scenario, those that take precedence last.

    In this order: the shipped catalog, those of installed packages (entry points ``torquerig.catalogs``), the folder
    ``catalogs`` next to the scenario's folder and in it (without a scenario: in the current folder), and ``further``.
    """
    folders = [shipped_folder(), *_of_packages()]
    if scenario is not None:
        near = scenario.resolve().parent
        folders += [folder for folder in (near.parent / "catalogs", near / "catalogs") if folder.is_dir()]
    else:
        here = Path("catalogs")
        folders += [here] if here.is_dir() else []
    folders += further
    distinct = {folder.resolve(): folder for folder in reversed(folders)}
    return list(reversed(distinct.values()))


def _of_packages() -> list[Path]:
    found = []
    for name, folder in extensions("torquerig.catalogs").items():
        if not isinstance(folder, str | Path) or not Path(folder).is_dir():
            raise InputError(f"the entry point {name!r} of torquerig.catalogs names {folder!r}, which is no folder")
        found.append(Path(folder))
    return found
