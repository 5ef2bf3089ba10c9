"""The data of a part on its way from YAML and catalog to a validated part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Filled:
    """The data of one part before it is validated, and of the effects that come with it.

    Parameters
    ----------
    values : mapping
        As YAML would state them: quantities are texts with units.
    uncertainties : mapping of str to float
        One-sigma relative spread by field, for a calibration.
    assumed : mapping of str to str
        What no document states: the value taken and the interval that it comes from, by field.
    """

    name: str
    values: Mapping[str, Any]
    uncertainties: Mapping[str, float] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)
    effects: tuple[Filled, ...] = ()
