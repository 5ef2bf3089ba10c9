"""One hypothesis about a rig under measured motion: parts with parameters, or efforts linear in their sizes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.knobs import Knob
from torquerig.inference.motion.imposed_run import ImposedRun
from torquerig.rig.assembly import Part, Rig

Floats = NDArray[np.float64]
Columns = Callable[[ImposedRun], Floats]
Written = Callable[[Floats], tuple[Part, ...]]

MECHANISM, ANYWHERE = -1.0, -4.0  # [nats] prior log-odds: an effect of the library at its place; one that has no place


@dataclass(frozen=True, kw_only=True, eq=False)
class Hypothesis:
    """An effect that the model may lack.

    Parameters
    ----------
    name : str
        Two additions of one name exclude each other.
    mechanism, variant : str
        Class of the contract and finer form; empty without a name.
    kind : str
        Of a nameless effect: ``line_family``, ``tone``, ``slow_course``, ``over_position``, ``over_speed``, ...;
        ``position_zero`` for a fact of the set-up.
    label : str
        In words.
    parts, knobs, start
        Parts at the medians of their priors; their parameters; where a fit begins, in standard deviations.
    columns : callable or None
        Effort for unit sizes along a run, shape (samples, sizes).
    scale : float
        Standard deviation of the normal prior of each size [N m] or [N].
    local : bool
        Whether each run has sizes for itself alone; else all runs share them.
    zeros : float
        Standard deviation of a zero of the position of each run [rad] or [m]; 0 without.
    log_odds : float
        Logarithm of the prior odds [nats].
    axis, at : str, float
        Where it acts: ``motor_shaft`` [1/rev], ``1/m``, ``Hz``, ...
    written : callable or None
        Parts of the library that make the columns with fitted sizes; None where no part does.
    """

    name: str
    label: str
    mechanism: str = ""
    variant: str = ""
    kind: str = ""
    parts: tuple[Part, ...] = ()
    knobs: tuple[Knob, ...] = ()
    start: tuple[float, ...] = ()
    columns: Columns | None = None
    scale: float = 1.0
    local: bool = False
    zeros: float = 0.0
    log_odds: float = MECHANISM
    axis: str = ""
    at: float = 0.0
    orders: tuple[float, ...] = ()
    written: Written | None = field(default=None, repr=False)

    @property
    def is_named(self) -> bool:
        """Whether it is a mechanism of the library."""
        return bool(self.mechanism)


@dataclass(frozen=True, eq=False)
class Model:
    """The nominal rig with its uncertain parameters, and what is added to it."""

    nominal: Rig
    nuisances: tuple[Knob, ...]
    additions: tuple[Hypothesis, ...] = ()

    @property
    def rig(self) -> Rig:
        """The rig with the parts of all additions at the medians of their priors."""
        rig = self.nominal
        for each in self.additions:
            for part in each.parts:
                rig = rig + part
        return rig

    @property
    def knobs(self) -> tuple[Knob, ...]:
        """All parameters of parts."""
        return (*self.nuisances, *(knob for each in self.additions for knob in each.knobs))

    @property
    def zeros(self) -> float:
        """Standard deviation of the zeros of position; 0 without."""
        return max((each.zeros for each in self.additions), default=0.0)

    @property
    def linear(self) -> tuple[Hypothesis, ...]:
        """The additions that are linear in their sizes."""
        return tuple(each for each in self.additions if each.columns is not None)

    @property
    def log_odds(self) -> float:
        """Prior log-odds of all additions [nats]."""
        return sum(each.log_odds for each in self.additions)

    def plus(self, addition: Hypothesis) -> Model:
        """Return the model with an addition, in place of one of the same name."""
        return replace(self, additions=(*self.minus(addition.name).additions, addition))

    def minus(self, name: str) -> Model:
        """Return the model without the addition of a name."""
        return replace(self, additions=tuple(each for each in self.additions if each.name != name))


def parameter_names(model: Model, runs: Sequence[ImposedRun], sizes: dict[str, int]) -> list[str]:
    """Return a name for each parameter: those of parts, zeros of position, the zero of the effort, sizes."""
    names = [knob.name for knob in model.knobs]
    names += [f"zero@{run.name}" for run in runs] if model.zeros else []
    names += ["effort zero"]
    for each in model.linear:
        places = [f"@{run.name}" for run in runs] if each.local else [""]
        names += [f"{each.name}[{number}]{place}" for place in places for number in range(sizes[each.name])]
    return names
