"""A fitted model with what was added to the nominal rig, and the lines that it lacks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit
from torquerig.inference.likelihood import floor_density
from torquerig.inference.places import Place
from torquerig.inference.prediction.rig_lines import rig_lines
from torquerig.inference.undecided_lines import column_of
from torquerig.linear_twin.twin import Twin

_LACKING = 4.0  # [1] of the power that a model expects: 6 dB more is no error of a line's size


@dataclass(frozen=True, eq=False)
class Model:
    """A fitted model with what was added to the nominal rig.

    Parameters
    ----------
    fit : Fit
    additions : tuple of Addition
    lines : tuple of FoundLine
        That no part explains.
    alternatives : tuple of (Addition, Addition, float)
        What was added, what was fitted in its place, and by how many nats of posterior odds that fell short.
    tried : tuple of (Addition, float)
        Proposals of the last round, and the gain of posterior odds [nats] that the local model promises for each.
    refuted : tuple of Addition
        Mechanisms that leave much of the features that they should explain.
    """

    fit: Fit
    additions: tuple[Addition, ...]
    lines: tuple[FoundLine, ...]
    alternatives: tuple[tuple[Addition, Addition, float], ...] = ()
    tried: tuple[tuple[Addition, float], ...] = ()
    refuted: tuple[Addition, ...] = ()

    @property
    def log_odds(self) -> float:
        """Log-evidence plus the prior odds of the additions [nats]."""
        return self.fit.log_evidence + sum(each.log_odds for each in self.additions)


def lacks(fit: Fit, data: Data, place: Place) -> bool:
    """Return whether a model lacks a line: some segment shows more of it than a line of wrong size.

    A part that was added for other lines may have made it too, as a side line. A line that no block shows is lacking
    where the model has none of its frequency.
    """
    if not any(each.lines.count[:, column_of(each, place)].any() for each in data.seen if place in each.places):
        return not any(_has_line(fit, each, place) for each in data.seen if place in each.places)
    for seen, model in zip(data.seen, fit.expected, strict=True):
        if place in seen.places:
            at = column_of(seen, place)
            noise = seen.lines.noise_bandwidth[:, at] * floor_density(seen, model)[:, at]
            shown = seen.lines.count[:, at] > 0
            measured, expected = seen.lines.power[shown, at], model.line_power[shown, at] + noise[shown]
            if (measured > _LACKING * expected).any():
                return True
    return False


def _has_line(fit: Fit, seen: RunFeatures, place: Place) -> bool:
    """Return whether a model has a line of the frequency of a place in a run, as well as the run shows that."""
    own, step = seen.line_frequency[:, seen.places.index(place)], 1 / seen.run.recording.duration
    twin = Twin(fit.fitted_rig.at(seen.run.run))
    return any(bool((np.abs(each.frequency - own) < step).any()) for each in rig_lines(twin, seen))
