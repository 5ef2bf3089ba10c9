"""Monte Carlo samples of catalog entries: values for a simulation, with a list of the assumed ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar

from torquerig.catalog.chosen_draws import draws_of
from torquerig.catalog.entry import Entry, counts_of, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.ripple import RENAMED
from torquerig.errors import InputError
from torquerig.machines.winding import winding_pairs
from torquerig.orders.kinematics.teeth import Teeth
from torquerig.parameter import Estimate

AnyEntry = TypeVar("AnyEntry", bound=Entry)


@dataclass(frozen=True)
class Assumed:
    """A value that no document states: the sampled value [SI], and its interval as a table shows it."""

    value: float
    known: str


@dataclass(frozen=True)
class Sample(Generic[AnyEntry]):
    """One Monte Carlo sample of a catalog entry.

    Parameters
    ----------
    entry : Motor, Gearbox, Sensor or Coupling
        The catalog entry.
    values : mapping of str to float
        Every value that is not unknown [SI], by dotted name: ``rotor_inertia``, ``ripple.cogging_native``.
    assumed : mapping of str to Assumed
        Those of the values that are not the documented number.
    """

    entry: AnyEntry
    values: Mapping[str, float]
    assumed: Mapping[str, Assumed]

    def value(self, field: str) -> float:
        """Return one value [SI]; InputError where it is unknown."""
        if field not in self.values:
            raise InputError(
                f"{self.entry.name}: {field} is unknown; state low and high with their evidence in its file"
            )
        return self.values[field]

    def count(self, field: str) -> int:
        """Return one whole value, such as ``pole_pairs``; InputError where it is unknown."""
        return round(self.value(field))


def sample_entry(entry: AnyEntry, seed: int) -> Sample[AnyEntry]:
    """Return one random sample of every value of ``entry``.

    Each value has a separate random generator, fixed by the seed, the entry and the name of the value: adding a value
    to a file changes no other sample. An alias gives the same values as the motor's name. Pole pairs and slots are
    sampled as a pair that has a winding.
    """
    origin = _origin(entry)
    values = {
        field: estimate.draw(draws_of(seed, f"{origin}.{_draw_name(field)}")) if estimate.open else estimate.nominal()
        for field, estimate in _known(entry)
    }
    values |= _divided_friction(entry, values)
    if pairs := _pairs(entry):
        at = int(draws_of(seed, f"{_origin(entry)}.winding").integers(len(pairs)))
        values |= _as_values(pairs[at])
    return Sample(entry, values, _assumed(entry, values))


def nominal(entry: AnyEntry) -> Sample[AnyEntry]:
    """Return the stated or middle value of every field, and the first pole pairs and slots that have a winding."""
    values = {field: estimate.nominal() for field, estimate in _known(entry)}
    values |= _divided_friction(entry, values)
    if pairs := _pairs(entry):
        values |= _as_values(pairs[0])
    return Sample(entry, values, _assumed(entry, values))


def sample_teeth(gearbox: Gearbox, seed: int) -> Teeth | None:
    """Return one random tooth set of the gearbox; None where its teeth are unknown."""
    sets = gearbox.tooth_sets()
    return sets[int(draws_of(seed, f"{gearbox.name}.teeth").integers(len(sets)))] if sets else None


def _known(entry: Entry) -> Iterator[tuple[str, Estimate]]:
    return ((field, estimate) for field, estimate in estimates(entry) if not estimate.unknown)


def _origin(entry: Entry) -> str:
    return (entry.stands_for if isinstance(entry, Motor) else "") or entry.name


def _draw_name(field: str) -> str:
    """Return the name that determines the draw of a field: its first one, so that a renamed field keeps its draw."""
    for first, present in RENAMED.items():
        field = field.replace(f".{present}.", f".{first}.")
    return field


def _pairs(entry: Entry) -> list[tuple[int, int]]:
    return winding_pairs(counts_of(entry.pole_pairs), counts_of(entry.slots)) if isinstance(entry, Motor) else []


def _divided_friction(entry: Entry, values: Mapping[str, float]) -> dict[str, float]:
    """Return dry and viscous friction whose sum at the no-load speed is the no-load torque; empty where it is unknown.

    The sampled dry friction, over the largest possible, is the share of the dry friction.
    """
    if not isinstance(entry, Motor) or not {"no_load_torque", "no_load_speed"} <= values.keys():
        return {}
    torque, largest = values["no_load_torque"], entry.coulomb_friction.bounds[1]
    dry = torque * values["coulomb_friction"] / largest if largest > 0 else 0.0
    return {"coulomb_friction": dry, "viscous_friction": (torque - dry) / values["no_load_speed"]}


def _as_values(pair: tuple[int, int]) -> dict[str, float]:
    return {"pole_pairs": float(pair[0]), "slots": float(pair[1])}


def _assumed(entry: Entry, values: Mapping[str, float]) -> dict[str, Assumed]:
    return {
        field: Assumed(values[field], _text(estimate))
        for field, estimate in _known(entry)
        if not estimate.documented or values[field] != estimate.value
    }


def _text(estimate: Estimate) -> str:
    return f"{estimate.shown()} ± {estimate.rel_sd:.0%}" if estimate.rel_sd else estimate.shown()
