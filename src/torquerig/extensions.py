"""What other installed packages add to torquerig, by entry points.

========================== =============================================================================
group                      what an entry point names
========================== =============================================================================
``torquerig.mechanisms``   a mechanism: a frozen dataclass derived from ``torquerig.rig.assembly.Part``
``torquerig.filters``      the YAML form of a filter: a class derived from ``StageForm``
``torquerig.readers``      a reader of a file format, ``read(path) -> Table``; the entry's name is the ending
``torquerig.catalogs``     a folder with ``motors/``, ``gearboxes/``, ``sensors/``, ``couplings/`` (a ``Path``)
========================== =============================================================================
"""

from __future__ import annotations

from functools import cache
from importlib.metadata import entry_points
from typing import Any

from torquerig.errors import InputError


@cache
def extensions(group: str) -> dict[str, Any]:
    """Return what installed packages add under ``group``, by the name of the entry point, in the order of names.

    Raises
    ------
    InputError
        Where an entry point cannot be loaded, with the package that has it.
    """
    found: dict[str, Any] = {}
    for entry in sorted(entry_points(group=group), key=lambda one: one.name):
        package = entry.dist.name if entry.dist else "an unnamed package"
        if entry.name in found:
            raise InputError(
                f"{package}: the entry point {entry.name!r} of {group} exists twice; uninstall one package"
            )
        try:
            found[entry.name] = entry.load()
        except Exception as error:
            raise InputError(
                f"{package}: the entry point {entry.name!r} of {group} cannot be loaded ({error}); "
                "correct or uninstall that package"
            ) from error
    return found


def extensions_of(group: str, kind: type) -> dict[str, Any]:
    """Return the classes under ``group``; InputError where an entry point does not derive from ``kind``."""
    found = extensions(group)
    for name, thing in found.items():
        if not (isinstance(thing, type) and issubclass(thing, kind)):
            raise InputError(f"the entry point {name!r} of {group} is {thing!r}; it must be a class of {kind.__name__}")
    return found
