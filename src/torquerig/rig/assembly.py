"""A rig as an immutable tuple of parts and effects, and the interface of a part."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, ClassVar, TypeVar

from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.recordings.run import Run
from torquerig.recordings.stage import Stage
from torquerig.rig.host_changes import HostChange
from torquerig.rig.housing import against_housing
from torquerig.rig.locked import refuse_locked
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.speed_ratios import speed_ratios
from torquerig.rig.terms import GROUND, Inertia, Spring, Term

HOST_FIELDS = ("at", "gear", "coupling", "sensor")  # by which an effect names its host


@dataclass(frozen=True, kw_only=True)
class Part:
    """One part of the machine, or one effect that disturbs it.

    Parameters
    ----------
    name : str
        Unique in the rig; the nodes are known by it.
    after : str or None
        The part whose output shaft this one is fixed to; None starts a shaft of its own (or, for an effect, none).
    kind : str
        The word by which a scenario calls this class.
    group : str
        Which share of the reading it is counted to: mechanical, cogging, electrical or load; sensor for what changes
        the reading and not the shafts; empty for parts.
    """

    name: str
    after: str | None = None
    kind: str = ""
    group: str = ""

    __pydantic_config__: ClassVar[dict[str, str]] = {"extra": "forbid"}

    on_shaft: ClassVar[bool] = False
    """True for what sits on a shaft: in a scenario it follows the shaft part before it, unless ``after`` is stated."""
    ends_shaft: ClassVar[bool] = False
    """True for a branch: the parts after it in a scenario continue from the start of the branch."""
    opens_node: ClassVar[bool] = False
    """True for what has a spring inside (gear, sensor, coupling): its output shaft is a separate node."""

    locks_shaft: ClassVar[bool] = False
    """True for what fixes its shaft to the frame: the node is then the ground, and nothing on it moves."""

    is_sensor: ClassVar[bool] = False
    """True for what has a measuring chain: its stages, and those of the effects in it, are of its reading alone."""

    acts_from_outside: ClassVar[bool] = False
    """True for an effect whose torque does not react on the housing of its motor: gravity, air, a load."""

    in_a_line: ClassVar[bool] = False
    """True for what moves in a line: kg, N and m in place of kg m^2, N m and rad."""

    takes: ClassVar[tuple[type[HostChange], ...]] = ()
    """Changes that effects may make inside this part; it collects them by ``rig.changes_in(self.name)``."""

    @cached_property
    def host(self) -> str | None:
        """The part that an effect belongs to (its host), by one of ``HOST_FIELDS``; of a branch ``after``."""
        at = next((getattr(self, name) for name in HOST_FIELDS if hasattr(self, name)), None)
        return self.after if at is None and self.ends_shaft else at

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the physics that this part adds to the shafts."""
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return what this effect changes inside its ``host``: ripple, errors, a gap, a cutoff; nothing for parts."""
        return ()

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the stages that this part adds to the measuring chain."""
        return ()


AnyPart = TypeVar("AnyPart", bound=Part)


@dataclass(frozen=True)
class Rig:
    """``rig + GearMesh(...)`` is the rig with one more effect; a rig is never changed in place.

    Parameters
    ----------
    parts : tuple of Part
        In the order of the scenario; names are unique.
    run : Run
        Set-points that the parts may depend on (speed, occupancy, particle size, profile).
    measured : str
        Name of the part whose spring torque is the reading; of several measured places the first torque or force.
    also_measured : tuple of str
        The further measured places, each with a channel of its own.
    """

    parts: tuple[Part, ...]
    run: Run = field(default_factory=Run)
    measured: str = "torque_sensor"
    also_measured: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        seen: set[str] = set()
        for part in self.parts:
            if part.name in seen:
                raise InputError(f"the rig has two parts named {part.name!r}; rename one")
            if part.after is not None and part.after not in seen:
                raise UnknownNameError(
                    f"{part.name}: after: {part.after!r} is no part before it; {did_you_mean(part.after, seen)}"
                )
            if part.name == GROUND and not part.locks_shaft:
                raise InputError(f"{GROUND!r} is the name of the frame; rename the part, or make it of kind: ground")
            seen.add(part.name)

    def __add__(self, part: Part) -> Rig:
        """Return the rig with one more part or effect."""
        return replace(self, parts=(*self.parts, part))

    def without(self, name: str) -> Rig:
        """Return the rig without the part ``name``."""
        gone = self.part(name)
        return replace(self, parts=tuple(part for part in self.parts if part is not gone))

    def changed(self, part: Part) -> Rig:
        """Return the rig with the part of the same name replaced by ``part``."""
        old = self.part(part.name)
        return replace(self, parts=tuple(part if other is old else other for other in self.parts))

    def at(self, run: Run) -> Rig:
        """Return the rig under other set-points."""
        return replace(self, run=run)

    def part(self, name: str) -> Part:
        """Return the part ``name``; UnknownNameError with the close matches where there is none."""
        for part in self.parts:
            if part.name == name:
                return part
        raise UnknownNameError(f"the rig has no part {name!r}; {did_you_mean(name, [p.name for p in self.parts])}")

    def parts_of(self, kind: type[AnyPart]) -> tuple[AnyPart, ...]:
        """Return the parts of one class, in their order."""
        return tuple(part for part in self.parts if isinstance(part, kind))

    def of_kind(self, kind: str) -> tuple[Any, ...]:
        """Return the parts of this kind in a scenario, in order, also in a library without the class."""
        return tuple(part for part in self.parts if part.kind == kind)

    def node(self, name: str) -> str:
        """Return the node that the part ``name`` turns with (of a gear, sensor or coupling: its output side)."""
        shaft = self._shaft(name)
        return GROUND if shaft in self._locked else shaft

    def _shaft(self, name: str) -> str:
        part = self.part(name)
        return part.name if part.opens_node or part.after is None else self._shaft(part.after)

    @cached_property
    def _locked(self) -> dict[str, str]:
        """The shafts that are fixed to the frame, each with the part that locks it."""
        return {self._shaft(part.name): part.name for part in self.parts if part.locks_shaft}

    def upstream(self, name: str) -> str:
        """Return the node on the input side of the gear, sensor or coupling ``name``."""
        part = self.part(name)
        if part.after is None:
            raise InputError(f"{name}: nothing drives it; name the part before it with after:")
        return self.node(part.after)

    def in_a_line(self, part: Part) -> bool:
        """Return whether a part moves in a line, or is on one that does; its numbers are then in kg, N and m."""
        return part.in_a_line or any(one.in_a_line for one in self.parts if one.name == part.host)

    def changes_of(self, part: Part) -> tuple[HostChange, ...]:
        """Return what one of the rig's effects changes inside its host."""
        if part.name not in self._changes_by_part:
            self._changes_by_part[part.name] = part.changes_in_host(self)
        return self._changes_by_part[part.name]

    @cached_property
    def _changes_by_part(self) -> dict[str, tuple[HostChange, ...]]:
        return {}

    def changes_in(self, host: str) -> tuple[HostChange, ...]:
        """Return what all effects change inside the part ``host``, in the order of the effects."""
        return tuple(change for part in self.parts if part.host == host for change in self.changes_of(part))

    @property
    def places(self) -> tuple[str, ...]:
        """The names of all measured places, first the one that is compared."""
        return (self.measured, *self.also_measured)

    def terms(self) -> tuple[Term, ...]:
        """Return the physics of all parts.

        Raises
        ------
        InputError
            Where a node has no inertia, or an effect changes what its host does not have.
        """
        return self._terms

    @cached_property
    def _terms(self) -> tuple[Term, ...]:
        terms = tuple(term for part in self.parts for term in self.terms_of(part))
        refuse_misplaced(self)
        refuse_locked(terms, speed=self.run.speed or 0.0)
        carried = {GROUND} | {term.node for term in terms if isinstance(term, Inertia) and term.inertia > 0}
        for term in terms:
            if isinstance(term, Spring):
                for node in (term.a, term.b):
                    if node not in carried:
                        raise InputError(
                            f"{node}: the spring of {term.name!r} ends on a shaft without inertia; give "
                            "that part an inertia or put an inertia after it"
                        )
        return terms

    def terms_of(self, part: Part) -> tuple[Term, ...]:
        """Return the physics of one of the parts."""
        if part.name not in self._terms_by_part:
            self._terms_by_part[part.name] = self._with_housing(part, tuple(part.terms(self)))
        return self._terms_by_part[part.name]

    def _with_housing(self, part: Part, terms: tuple[Term, ...]) -> tuple[Term, ...]:
        if not self._housings:
            return terms
        names = (part.name, getattr(part, "motor", None), part.host)
        motor = next((name for name in names if name in self._housings), None)
        if motor is None or part.acts_from_outside:
            return terms
        return against_housing(terms, rotor=self.node(motor), housing=self._housings[motor])

    @cached_property
    def _housings(self) -> dict[str, str]:
        """The node of the housing of each motor that stands on a reaction torque sensor."""
        return {part.motor: part.name for part in self.of_kind("reaction_torque_sensor")}

    @cached_property
    def _terms_by_part(self) -> dict[str, tuple[Term, ...]]:
        return {}

    def stages(self, place: str | None = None) -> tuple[Stage, ...]:
        """Return the measuring chain of a measured place from the shaft to the file, by default of ``measured``.

        Parts at one position keep their order. What no sensor has (an encoder, mains hum) is in the chain of
        ``measured``.
        """
        return self._stages.get(self.measured if place is None else place, ())

    @cached_property
    def _stages(self) -> dict[str, tuple[Stage, ...]]:
        sensors = {part.name for part in self.parts if part.is_sensor}
        placed: dict[str, list[PlacedStage]] = {}
        for part in self.parts:
            of = next((name for name in (part.name, getattr(part, "sensor", "")) if name in sensors), self.measured)
            placed.setdefault(of, []).extend(part.stages(self))
        return {
            of: tuple(item.stage for item in sorted(each, key=lambda item: item.position))
            for of, each in placed.items()
        }

    def speed_ratios(self, reference: str) -> dict[str, float]:
        """Return the turns of each node per turn of the node ``reference``, by the gears between them."""
        shafts = [part for part in self.parts if part.opens_node]
        springs = [term for part in shafts for term in self.terms_of(part) if isinstance(term, Spring)]
        return speed_ratios(springs, reference)


def refuse_misplaced(rig: Rig) -> None:
    """Raise InputError for the first effect whose host does not support its change."""
    for part in rig.parts:
        for change in rig.changes_of(part):
            host = None if part.host is None else rig.part(part.host)
            if host is None or not isinstance(change, host.takes):
                fit = sorted(one.name for one in rig.parts if isinstance(change, one.takes))
                where = "no part" if host is None else f"{host.name!r}, a {host.kind},"
                raise InputError(
                    f"{part.name}: {change.what} has no place in {where}; "
                    + (f"name one of {', '.join(fit)}" if fit else "add a part that has one")
                )
