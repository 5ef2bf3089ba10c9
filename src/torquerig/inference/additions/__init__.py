"""Hypotheses by which a model may be completed: the folder is the list.

Nameless: line_family, tone, gain_ripple, resonance, reading_course, speed_course.  Numbers of the rig: far_parameter.
Mechanisms: one each.

Each module has ``propose(context)``, which yields additions with their priors. One that names mechanisms lists their
files in ``NAMES``. ``KEEPS`` is true where what it computes is used again: it proposes in the first process.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules
from types import ModuleType

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context
from torquerig.parallel import parallel_map


def proposals(context: Context) -> Iterator[Addition]:
    """Yield what every module of this folder proposes whose mechanisms the library has."""
    known = [each for each in modules() if all(find_spec(f"torquerig.mechanisms.{name}") for name in names_of(each))]
    forgetting = [each for each in known if not getattr(each, "KEEPS", False)]
    found = parallel_map(lambda module: list(module.propose(context)), forgetting)
    proposed = {module.__name__: own for module, own in zip(forgetting, found, strict=True)}
    for module in known:
        yield from proposed[module.__name__] if module in forgetting else module.propose(context)


def modules() -> Iterator[ModuleType]:
    """Yield the modules of this folder by name."""
    for name in sorted(each.name for each in iter_modules(__path__)):
        yield import_module(f"{__name__}.{name}")


def names_of(module: ModuleType) -> tuple[str, ...]:
    """Return the mechanisms of the library that a module can name; none of a nameless effect or a number of the rig."""
    return tuple(getattr(module, "NAMES", ()))
