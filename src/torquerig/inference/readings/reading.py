"""Runs as they are read with facts of the set-up corrected, the nominal fit to them, and the faults."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from torquerig.inference.fit import Data, Fit, finished, sketched
from torquerig.inference.knobs import Knob
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import Place
from torquerig.inference.refitted import slopes_at_medians
from torquerig.rig.assembly import Rig

CLEARLY = 15.0  # [nats] by which another reading must explain the features better: 3e6 to 1
SLIP_LOG_ODDS = -5.0  # 0.7 % of the facts of a set-up are slips of pen, unit or data sheet


@dataclass(frozen=True, kw_only=True)
class SetupFault:
    """A fact of the set-up as it is stated and as the recordings show it.

    Parameters
    ----------
    kind : str
        As the contract names it.
    of : str
        The sensor, the encoder, the stage or the recordings.
    stated, estimated : float
    unit : str
    equivalent_to : tuple of str
        Other kinds that explain the features as well.
    explanation : str
    interval : (float, float) or None
        95 % interval of the estimate; None where it follows from the fit or from the set-points.
    """

    kind: str
    of: str
    stated: float
    estimated: float
    unit: str
    equivalent_to: tuple[str, ...]
    explanation: str
    interval: tuple[float, float] | None = None


@dataclass(frozen=True, eq=False)
class Reading:
    """The runs as they are read, the nominal fit to them, and the faults that were corrected."""

    runs: tuple[MeasuredRun, ...]
    data: Data
    fit: Fit
    faults: tuple[SetupFault, ...] = ()

    def finished(self) -> Reading:
        """Return the reading with the fit at the maximum of its posterior."""
        return replace(self, fit=finished(self.fit, self.data))


class Read(Protocol):
    """Returns runs as a rig reads them, by default measured anew, with features at its lines and at other places."""

    def __call__(
        self, rig: Rig, /, runs: Sequence[MeasuredRun] | None = None, *, also: Sequence[Place] = ()
    ) -> Reading:
        """Return the reading with a sketch of the nominal fit: most readings lose by far."""


def sketched_like(
    fit: Fit, data: Data, *, rig: Rig | None = None, knob: tuple[int, Knob, float] | None = None
) -> Fit:  # fmt: skip
    """Return a sketch from the medians of the priors on, with the derivatives of a fit to other numbers.

    Those of logarithms hardly depend on a scale. A step that falls short has those made anew that it follows from.

    Parameters
    ----------
    rig : Rig, optional
        With another number in a part.
    knob : (int, Knob, float), optional
        A parameter with another spread, in place of that of so many, and where it begins.
    """
    knobs, start, slopes = list(fit.knobs), np.zeros(len(fit.knobs)), slopes_at_medians(fit, data)
    if knob is not None:
        at = knob[0]
        knobs[at], start[at] = knob[1:]
        slopes[:, at] *= knobs[at].spread / fit.knobs[at].spread
    return sketched(rig or fit.rig, knobs, data, start=start, jacobian=slopes, nominal=fit.nominal if rig else None)


def per_feature(fit: Fit) -> float:
    """Return the log-evidence per feature [nats]."""
    return fit.log_evidence / max(fit.value.size, 1)


def gain_of(better: Fit, worse: Fit) -> float:
    """Return by how much one fit explains features better [nats]; two readings may differ in the number of features."""
    return min(better.value.size, worse.value.size) * (per_feature(better) - per_feature(worse))
