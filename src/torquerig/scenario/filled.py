"""The data of a part on its way from YAML and catalog to a validated part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from torquerig.parameter import Estimate


@dataclass(frozen=True, kw_only=True)
class FromCatalog:
    """One value that a part took from its catalog entry.

    Parameters
    ----------
    entry, field : str
        The entry, under the name by which its maker knows it, and the field in its file: ``ripple.cogging_native``.
    known : Estimate
        What the file states.
    used : float
        What this sample of the part has [SI].
    """

    entry: str
    field: str
    known: Estimate
    used: float

    @property
    def name(self) -> str:
        """What to ask the maker for: ``rotor inertia of HDS6A-0104A``."""
        return f"{self.field.replace('_', ' ').replace('.', ': ')} of {self.entry}"


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
    taken : mapping of str to FromCatalog
        Everything that the catalog gave, by field of the part; what its effects rest on by the entry's field.
    """

    name: str
    values: Mapping[str, Any]
    uncertainties: Mapping[str, float] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)
    taken: Mapping[str, FromCatalog] = field(default_factory=dict)
    effects: tuple[Filled, ...] = ()
