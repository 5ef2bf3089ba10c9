"""Hypotheses by which a model may be completed: the folder is the list.

Nameless: line_family, tone, resonance.  Numbers of the rig: far_parameter.  Mechanisms: one module each.

Each module has ``propose(context)``, which yields additions with their priors.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from pkgutil import iter_modules

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context


def proposals(context: Context) -> Iterator[Addition]:
    """Yield what every module of this folder proposes."""
    for name in sorted(each.name for each in iter_modules(__path__)):
        yield from import_module(f"{__name__}.{name}").propose(context)
