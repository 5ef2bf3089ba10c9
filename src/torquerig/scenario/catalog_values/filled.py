"""Data of a part from YAML and catalog, before it is validated."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from torquerig.parameter import Estimate


@dataclass(frozen=True, kw_only=True)
class FromCatalog:
    """One value that a part took from its catalog entry.

    Parameters
    ----------
    entry, field : str
        The entry, by its maker's name, and the field in its file: ``ripple.cogging_native``.
    known : Estimate
        The value in the file.
    used : float
        The value of this sample [SI].
    """

    entry: str
    field: str
    known: Estimate
    used: float

    @property
    def name(self) -> str:
        """Name of the value: ``rotor inertia of HDS6A-0104A``."""
        return f"{self.field.replace('_', ' ').replace('.', ': ')} of {self.entry}"


Value = TypeVar("Value")
ALTERNATIVES = {"damping": "loss_factor", "loss_factor": "damping"}
"""Fields that replace each other: what the scenario states goes before the catalog's, also of the other name."""


@dataclass(frozen=True, kw_only=True)
class Filled:
    """The data of one part before it is validated, and of the effects that come with it.

    Parameters
    ----------
    values : mapping
        As YAML would state them: quantities are texts with units.
    uncertainties : mapping of str to float
        Relative standard deviation by field, of values from the catalog, for a calibration.
    stated : mapping of str to Estimate
        Uncertain values of the file, by dotted path: ``mean_by_occupancy_percent.5``.
    kept : mapping of str to str
        Those of them that have their stated value, with the uncertainty as text.
    assumed : mapping of str to str
        Values that no document states, with their interval, by field.
    taken : mapping of str to FromCatalog
        Values from the catalog, by field of the part; values of its effects by the entry's field.
    """

    name: str
    values: Mapping[str, Any]
    uncertainties: Mapping[str, float] = field(default_factory=dict)
    stated: Mapping[str, Estimate] = field(default_factory=dict)
    kept: Mapping[str, str] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)
    taken: Mapping[str, FromCatalog] = field(default_factory=dict)
    effects: tuple[Filled, ...] = ()

    def without(self, stated: Collection[str]) -> Filled:
        """Return the data without what the catalog gives for fields that the scenario states, also by another name."""
        replaced = {*stated, *(ALTERNATIVES[key] for key in stated if key in ALTERNATIVES)}
        return replace(
            self,
            values=_without(replaced, self.values),
            uncertainties=_without(replaced, self.uncertainties),
            assumed=_without(replaced, self.assumed),
            taken=_without(replaced, self.taken),
        )


def _without(keys: Collection[str], values: Mapping[str, Value]) -> dict[str, Value]:
    return {key: one for key, one in values.items() if key not in keys}
