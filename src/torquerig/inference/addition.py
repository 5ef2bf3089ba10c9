"""One hypothesis: parts that may complete a model, or numbers of it that may be far off, with what is known before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.rig.assembly import Part, Rig

DECADE = float(np.log(10.0))  # standard deviation of the logarithm of an amplitude that nobody knows


@dataclass(frozen=True)
class Reported:
    """A parameter as the contract names it: which field of the part it is, in which unit."""

    name: str
    field: str
    unit: str
    key: int | float | None = None


@dataclass(frozen=True, kw_only=True)
class Addition:
    """One hypothesis.

    Parameters
    ----------
    mechanism : str
        Class name of the contract; empty for a nameless effect and for a number of the rig.
    variant : str
        Which finer mechanism of the library makes it, or which form of the class; empty for the class itself.
    kind : str
        Of a nameless effect ``line_family``, ``tone``, ``resonance``, ``level_course`` (over time or speed) or
        ``gain_course``; of a number of the rig ``parameter``.
    parts : tuple of Part
        At the medians of their priors.
    knobs : tuple of Knob
        Parameters of the parts, or of the rig, whose own parameters they then replace.
    starts : tuple of tuple of float
        Where a fit of the parameters may begin, in standard deviations of their priors.
    stated : frozenset of str
        Parameters of the model, by name, that are back at their stated values there: they moved in place of the effect.
    log_odds : float
        Logarithm of the prior probability of this effect at this place [nats].
    places : tuple of Place
        Lines that it explains.
    label : str
        What it is, in words.
    reported : tuple of Reported
        Fitted parameters for the report.
    fixed : mapping of str to (float, float, str)
        Parameters that the hypothesis holds, with half the width of their 95 % interval and their unit: an order, a
        frequency.
    estimated : mapping of str to (float, float, float, str)
        Parameters that were estimated before the hypothesis, with the ends of their 95 % interval and their unit.
    """

    mechanism: str = ""
    variant: str = ""
    kind: str = ""
    parts: tuple[Part, ...] = ()
    knobs: tuple[Knob, ...] = ()
    starts: tuple[tuple[float, ...], ...] = ()
    stated: frozenset[str] = frozenset()
    log_odds: float = 0.0
    places: tuple[Place, ...] = ()
    label: str = ""
    reported: tuple[Reported, ...] = ()
    fixed: Mapping[str, tuple[float, float, str]] = field(default_factory=dict)
    estimated: Mapping[str, tuple[float, float, float, str]] = field(default_factory=dict)

    def added_to(self, rig: Rig) -> Rig:
        """Return the rig with the parts."""
        for part in self.parts:
            rig = rig + part
        return rig

    @property
    def names(self) -> frozenset[str]:
        """The parts or parameters that it adds; two additions that share one exclude each other."""
        return frozenset(part.name for part in self.parts) or frozenset(knob.name for knob in self.knobs)

    @property
    def is_named(self) -> bool:
        """Whether it is a mechanism of the library."""
        return bool(self.mechanism)


def start_of(value: float, median: float, spread: float = DECADE) -> float:
    """Return the position of a value on a log-normal prior, within three standard deviations."""
    if value <= 0 or median <= 0:
        return -1.0
    return float(np.clip(np.log(value / median) / spread, -3.0, 3.0))


def free_name(rig: Rig, wanted: str) -> str:
    """Return ``wanted``, with a number where a part of the rig has that name."""
    names, name, number = {part.name for part in rig.parts}, wanted, 2
    while name in names:
        name, number = f"{wanted}_{number}", number + 1
    return name
