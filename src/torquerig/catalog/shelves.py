"""The catalog: its entries by name or alias."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeVar

from torquerig.errors import UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from torquerig.catalog.coupling import Coupling
    from torquerig.catalog.entry import Entry
    from torquerig.catalog.gearbox import Gearbox
    from torquerig.catalog.motor import Alias, Motor
    from torquerig.catalog.part_class import PartClass
    from torquerig.catalog.sensor import Sensor

AnyEntry = TypeVar("AnyEntry", bound="Entry")


@dataclass(frozen=True)
class Catalog:
    """All catalog entries, by name.

    ``digest`` is that of the files that they were, or are to be, read from; empty where it is not known.
    """

    motors: Mapping[str, Motor] = field(default_factory=dict)
    gearboxes: Mapping[str, Gearbox] = field(default_factory=dict)
    sensors: Mapping[str, Sensor] = field(default_factory=dict)
    couplings: Mapping[str, Coupling] = field(default_factory=dict)
    classes: Mapping[str, PartClass] = field(default_factory=dict)
    digest: str = field(default="", repr=False, compare=False)

    def motor(self, name: str) -> Motor:
        """Return the motor ``name``; under an alias it keeps that name, and ``stands_for`` is the real name."""
        if name in self.motors:
            return self.motors[name]
        real, _ = self._aliases().get(name, ("", None))
        if not real:
            raise _unknown("motor", name, [*self.motors, *self._aliases()])
        return self.motors[real].model_copy(update={"name": name, "stands_for": real})

    def resolved(self, name: str) -> Alias | None:
        """Return the alias entry of ``name``, with its reason and source; None where it is the name of a motor."""
        self.motor(name)
        return None if name in self.motors else self._aliases()[name][1]

    def gearbox(self, name: str) -> Gearbox:
        """Return the gearbox ``name``; UnknownNameError with the close matches where there is none."""
        return _found(self.gearboxes, name, "gearbox")

    def sensor(self, name: str) -> Sensor:
        """Return the torque sensor ``name``; UnknownNameError with the close matches where there is none."""
        return _found(self.sensors, name, "sensor")

    def coupling(self, name: str) -> Coupling:
        """Return the coupling ``name``; UnknownNameError with the close matches where there is none."""
        return _found(self.couplings, name, "coupling")

    def _aliases(self) -> dict[str, tuple[str, Alias]]:
        return {alias.name: (motor.name, alias) for motor in self.motors.values() for alias in motor.aliases}


def _found(entries: Mapping[str, AnyEntry], name: str, kind: str) -> AnyEntry:
    if name not in entries:
        raise _unknown(kind, name, entries)
    return entries[name]


def _unknown(kind: str, name: str, known: Iterable[str]) -> UnknownNameError:
    return UnknownNameError(f"there is no {kind} {name!r} in the catalog; {did_you_mean(name, known)}")
