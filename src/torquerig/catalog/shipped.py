"""Folders of the catalogs and scenarios that come with torquerig: inside a wheel, or at the top of a checkout."""

from __future__ import annotations

from pathlib import Path

from torquerig.errors import InputError


def shipped_folder() -> Path:
    """Return the folder of the shipped catalogs; InputError where the installation has none."""
    return _shipped("catalogs")


def shipped_scenarios() -> Path:
    """Return the folder of the shipped scenarios; InputError where the installation has none."""
    return _shipped("scenarios")


def _shipped(name: str) -> Path:
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "shipped" / name, package.parents[1] / name):
        if folder.is_dir():
            return folder
    raise InputError(f"{package}: this installation has no {name}; install torquerig again from its wheel or checkout")
