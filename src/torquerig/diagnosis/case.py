"""Where a diagnosis stands: the runs, the model fitted so far, what it leaves, and what else might be tried."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.calibration import Calibrated, misfits_of
from torquerig.diagnosis.fitting.misfit import Misfit, misfit_sum
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.from_zero import from_zero
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.null_table import NullTable
from torquerig.inference.knobs import Knob
from torquerig.inference.places import SAME_ORDER, Place, order
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.assembly import Part, Rig

# fields of a model that make its slow torque, and stand in for an effect that changes it
SLOW_TORQUE = ("mean_by_occupancy_percent", "viscous", "coulomb", "slow_rms", "slow_cutoff")

BENT = 4.0  # spreads: a number that stands so far off has been bent by what is missing
_MISSED = 6.0  # spreads in one run


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """One way to complete the model: parts to add and what of them is to be fitted.

    Parameters
    ----------
    mechanism : str
        Class name of the contract.
    parts : tuple of Part
        With their starting values.
    knobs : tuple of Knob
        Of those parts.
    variant : str
        A finer name, or empty.
    place : Place or None
        The line that it sets out to explain.
    description : str
        Of one that names no cause, in words; empty for mechanisms of the library.
    price : float
        What it must gain beside, because few rigs have its like.
    spared : float
        As much of ``price`` as it need not gain where lines at known orders tell it (``choosing.told_by_lines``).
    loosens : tuple of str
        Fields of the model whose numbers have stood in for it, and must give way where it is looked at first.
    bends : tuple of str
        Names of the model's knobs that are fitted far off where it is missing, and come back where it is not.
    promised : float
        What it must gain, by the derivatives, once the model's numbers give way, prices aside, to be fitted as it was
        proposed; never where infinite.
    slow : bool
        Whether it moves the slow torque and nothing else, so that lines and bands tell nothing of it.
    resembled : bool
        Whether laws that differ, or noise, look like it, so that what no fit has seen does not bear a small gain out.
    as_loads : bool
        Whether laws of a load look like it in each recording alike, so that what no fit has seen never bears a small
        gain out: a clean rig gained 31 by a low-pass, and 33 where no fit had seen.
    within : mapping of str to (float, float)
        95 % intervals of fields of its first part that no knob fits, in the part's units.
    below : mapping of str to float
        What fitted fields of its parts must stay below to be told from these recordings, in the parts' units.
    above : mapping of str to float
        What they must stay above.
    """

    mechanism: str
    parts: tuple[Part, ...]
    knobs: tuple[Knob, ...]
    variant: str = ""
    place: Place | None = None
    description: str = ""
    price: float = 0.0
    spared: float = 0.0
    loosens: tuple[str, ...] = ()
    bends: tuple[str, ...] = ()
    promised: float = math.inf
    slow: bool = False
    resembled: bool = False
    as_loads: bool = False
    within: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    below: Mapping[str, float] = field(default_factory=dict)
    above: Mapping[str, float] = field(default_factory=dict)

    def added_to(self, rig: Rig) -> Rig:
        """Return the rig with the parts."""
        for part in self.parts:
            rig = rig + part
        return rig

    def removed_from(self, rig: Rig) -> Rig:
        """Return the rig without those of the parts that it has."""
        present = {part.name for part in rig.parts}
        for part in self.parts:
            rig = rig.without(part.name) if part.name in present else rig
        return rig


@dataclass(frozen=True, kw_only=True)
class Case:
    """The runs and the model as fitted so far.

    Parameters
    ----------
    nominal : Rig
        The scenario's.
    runs : tuple of Observed
    seen : tuple of Features
        Of the stretches that fits may see, at the places of known and of left lines.
    model : Calibrated
    left : tuple of Peak
        Lines that the model does not have.
    accepted : tuple of Candidate
        What was added to the nominal rig, in this order.
    thresholds : NullTable or None
        Least gains that were made for the scenario.
    apart : ndarray, shape (knobs,), or None
        Positions of the model's own knobs when the left lines are not looked at: what is missing bends the others.
    stated_gap : float
        Of a gear, which the scenario has and ``nominal`` has not [rad]; 0 where it has none.
    """

    nominal: Rig
    runs: tuple[Observed, ...]
    seen: tuple[Features, ...]
    model: Calibrated
    left: tuple[Peak, ...]
    accepted: tuple[Candidate, ...] = field(default=())
    thresholds: NullTable | None = None
    apart: NDArray[np.float64] | None = None
    stated_gap: float = 0.0

    def nominal_with_accepted(self) -> Rig:
        """Return the scenario's rig with what was added, none of its numbers fitted."""
        rig = self.nominal
        for earlier in self.accepted:
            rig = earlier.added_to(rig)
        return rig

    def beginnings(self) -> tuple[Calibrated, ...]:
        """Return the models beside which an effect may be begun: as fitted and, where that bent a number, none fitted.

        The ``jacobian`` of the latter is the fitted one's: slopes of residuals to the same knobs, elsewhere.
        """
        if np.abs(self.model.positions).max(initial=0.0) < BENT:
            return (self.model,)
        none = np.zeros_like(self.model.positions)
        return self.model, replace(self.model, rig=self.nominal_with_accepted(), positions=none)

    def misfit_of(self, rig: Rig) -> float:
        """Return the misfit sum of another rig, with what no twin can hold as it stands in the model."""
        corrections = self.model.corrections or None
        return misfit_sum(misfits_of(rig, self.seen, corrections))

    @cached_property
    def from_zero(self) -> tuple[Features, ...]:
        """The runs, what drifts in the model taken out of their torque."""
        return tuple(from_zero(features, self.model.rig) for features in self.seen)

    def has(self, mechanism: str) -> bool:
        """Whether a mechanism was added already."""
        return any(candidate.mechanism == mechanism for candidate in self.accepted)


def left_line(case: Case, motor_order: float) -> Place | None:
    """Return the left line that stands at a motor order, within what a recording resolves, or None."""
    for peak in case.left:
        if peak.place.domain == "order" and abs(peak.place.at - motor_order) < SAME_ORDER:
            return peak.place
    return None


def line_residuals(seen: Sequence[Features], misfits: Sequence[Misfit]) -> dict[Place, float]:
    """Return by how many spreads each line is missed in the run that misses it most; runs that turn back show none."""
    worst: dict[Place, float] = {}
    for features, misfit in zip(seen, misfits, strict=True):
        if features.turning is None:
            sizes = np.abs(np.atleast_2d(misfit.lines)).max(axis=0, initial=0.0)
            for place, size in zip(features.places, sizes.tolist(), strict=True):
                worst[place] = max(worst.get(place, 0.0), size)
    return worst


def missed_lines(case: Case) -> list[Place]:
    """Return those of the model's own lines at an order that it misses by more than chance, the worst first."""
    worst = line_residuals(case.seen, case.model.misfits)
    own = {place for place in worst if place.domain == "order"}.difference(*(each.unknown for each in case.seen))
    return sorted((place for place in own if worst[place] > _MISSED), key=lambda place: -worst[place])


def bent_lines(case: Case) -> list[Place]:
    """Return those of the model's own lines whose amplitudes were fitted far above what is known of them."""
    ratios, answer = Twin(case.nominal).turns, list[Place]()
    for knob, position in zip(case.model.knobs, case.model.positions.tolist(), strict=True):
        part = case.model.rig.part(knob.part)
        if knob.field == "amplitudes" and position > BENT and isinstance(part, TorqueRipple):
            answer.append(order(float(knob.key) * ratios[case.nominal.node(part.at)]))
    return answer


def line_factor(case: Case, rig: Rig, place: Place) -> float:
    """Return by what the amplitude of the one source at ``place`` in ``rig`` must be multiplied to fit best.

    Least squares over runs and stretches of measured against expected amplitude, each in units of its chance.
    """
    top = bottom = 0.0
    for features in case.seen:
        if place not in features.places:
            continue
        column = features.places.index(place)
        model, before = expected(rig, features), expected(case.model.rig, features)
        size = np.sqrt(np.maximum(model.amplitude[:, column] ** 2 - before.amplitude[:, column] ** 2, 0.0))
        measured = np.abs(features.amplitude[:, column])
        seen = np.isfinite(measured) & (size > 0)
        weight = 1 / (model.variance[seen, column] + 1e-12)
        top += float((weight * measured[seen] * size[seen]).sum())
        bottom += float((weight * size[seen] ** 2).sum())
    return top / bottom if bottom > 0 else 1.0
