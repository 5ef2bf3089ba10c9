"""What each kind of term declares: its arrays, its share of the linear matrices, and what the twin lacks of it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import cos, pi, sin
from typing import Any, ClassVar, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import random_for
from torquerig.rig.terms import Term, Wave
from torquerig.simulation.arrays import Floats, Rows, Starts
from torquerig.simulation.waves import WaveTable

AnyTerm = TypeVar("AnyTerm")
AnyRows = TypeVar("AnyRows")
UNFILLED = np.zeros((0, 0))  # the run fills it
GROUND_ROW = -1  # the ground is the last of the nodes


@dataclass(frozen=True, kw_only=True)
class Lowering:
    """What the lowering of one rig shares: ``number`` of each node, ``inertia`` [kg m^2] on it, slots, seed."""

    number: Mapping[str, int]
    inertia: Floats
    table: WaveTable
    seed: int


class Link(NamedTuple):
    """A spring and a damper between two nodes: ``stiffness x + damping x'``, ``x = lever theta_on - theta_against``.

    ``on`` gets ``-lever`` times that torque and ``against`` all of it: the pair that keeps the momentum.
    """

    on: int
    against: int
    stiffness: float
    damping: float
    lever: float = 1.0


class Reversal(NamedTuple):
    """A torque that turns round with the direction of motion of ``on`` against ``against``, at most ``torque`` [N m].

    ``inverse_smoothing`` [s/rad] says over which speed it does; ``what`` is said of it where it fixes the step.
    """

    on: int
    against: int
    torque: float
    inverse_smoothing: float
    what: str


class TermKind(ABC, Generic[AnyTerm, AnyRows]):
    """One kind of term as the simulation knows it; all but ``rows`` has an answer for terms that need none."""

    field: ClassVar[str]
    """The name of its arrays in ``Terms``."""
    made_from: ClassVar[tuple[type, ...]]
    """The classes of ``rig/terms`` that it lowers."""
    deciding: ClassVar[tuple[str, ...]] = ()
    """Its arrays of which a zero stands for another law, so that rigs side by side must share their zeros."""

    def chosen(self, terms: Sequence[Term]) -> tuple[AnyTerm, ...]:
        """Return the terms of this kind, one for each row; those of no size may be left out."""
        found: list[Any] = [term for term in terms if isinstance(term, self.made_from)]
        return tuple(found)

    def orders(self, terms: Sequence[AnyTerm]) -> Iterator[tuple[str, float]]:
        """Yield node and order of each wave whose cosine and sine an evaluation needs."""
        yield from ()

    @abstractmethod
    def rows(self, terms: Sequence[AnyTerm], to: Lowering) -> AnyRows:
        """Return the arrays of the chosen terms."""

    def links(self, rows: AnyRows, *, stiffest: bool) -> Iterator[Link]:
        """Yield its share of the linear matrices C and K; ``stiffest`` where it is hardest for the integrator."""
        yield from ()

    def reversals(self, terms: Sequence[AnyTerm], rows: AnyRows) -> Iterator[Reversal]:
        """Yield the torques that turn round with the direction of motion; they may ask for a short step."""
        yield from ()

    def refused(self, terms: Sequence[AnyTerm]) -> Iterator[tuple[str, str]]:
        """Yield (name, what it is) of what the exact linear path cannot have."""
        yield from ()

    def steady(self, terms: Sequence[AnyTerm], rows: AnyRows, speeds: Floats) -> Iterator[tuple[int, float]]:
        """Yield (node, torque [N m]) that opposes it, on average, while all nodes turn at ``speeds`` [rad/s]."""
        yield from ()

    def left_out(self, terms: Sequence[AnyTerm], rows: AnyRows) -> Iterator[str]:
        """Yield what a linear twin about a steady state does not have of it, one clause each."""
        yield from ()


class Phased(NamedTuple):
    """Waves of several owners one after the other: where each owner's start, slots, orders, cosine and sine parts."""

    first: Starts
    slot: Rows
    order: Floats
    c: Floats
    s: Floats


def phased(owners: Sequence[tuple[str, int, Sequence[Wave]]], table: WaveTable, seed: int) -> Phased:
    """Return the waves of (name, node of the angle, waves) with their phases drawn."""
    flat = [(node, wave, phase_of(name, wave, seed)) for name, node, waves in owners for wave in waves]
    return Phased(
        first=starts(len(waves) for _, _, waves in owners),
        slot=whole(table.slots[(node, wave.order)] for node, wave, _ in flat),
        order=floats(wave.order for _, wave, _ in flat),
        c=floats(wave.amplitude * cos(phase) for _, wave, phase in flat),
        s=floats(wave.amplitude * sin(phase) for _, wave, phase in flat),
    )


def phase_of(owner: str, wave: Wave, seed: int) -> float:
    """Return the phase of a wave [rad]: as stated, else drawn uniformly by seed, owner and key (or order)."""
    if wave.phase is not None:
        return wave.phase
    key = wave.phase_key or f"{owner}.{wave.order:g}"
    return float(random_for(seed, f"phase {key}").uniform(0, 2 * pi))


def sounding(term: AnyTerm, *fields: str) -> AnyTerm:
    """Return a term without the waves of no size: they must not change how the others are multiplied together."""
    kept = {name: tuple(wave for wave in getattr(term, name) if wave.amplitude) for name in fields}
    silent = any(len(waves) < len(getattr(term, name)) for name, waves in kept.items())
    return replace(term, **kept) if silent else term  # type: ignore[type-var]


def starts(lengths: Iterable[int]) -> Starts:
    """Return where each of several stretches starts, and where the last one ends."""
    return np.concatenate([[0], np.cumsum(list(lengths))]).astype(np.int64)


def whole(values: Iterable[Any]) -> NDArray[np.uint64]:
    """Return whole numbers as an array."""
    return np.array(list(values), dtype=np.uint64)


def floats(values: Iterable[Any]) -> NDArray[np.float64]:
    """Return numbers as an array."""
    return np.array(list(values), dtype=np.float64)


def by_direction(values: Iterable[tuple[float, float]]) -> Floats:
    """Return pairs (backward, forward) as an array of two columns."""
    return np.array(list(values), dtype=np.float64).reshape(-1, 2)
