"""Null distribution of the gain: fits of the library to rigs without hidden effects."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from proof.library import library_of
from torquerig.diagnosis.choosing.convincing import share_of
from torquerig.diagnosis.choosing.search import trials
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.engine import diagnose
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario


@dataclass(frozen=True, kw_only=True)
class NullGain:
    """The best fit of one mechanism to one rig without hidden effects.

    Parameters
    ----------
    mechanism : str
    gain : float
        Fall of chi-square, less the penalty for parameters [1].
    share : float
        Share of the squared residual that it explains where it acts [1].
    """

    mechanism: str
    gain: float
    share: float


def null_gains(scenario: Scenario, recordings: Sequence[Recording], *, seed: int = 0) -> tuple[NullGain, ...]:
    """Return the best gain of each mechanism that was fitted with all parameters free, largest first.

    The nominal model is calibrated with an empty library, so that no mechanism is added first.
    """
    with library_of(()):
        case = diagnose(scenario, recordings, seed=seed).before
    best: dict[str, Trial] = {}
    for trial in sorted(trials(case).fitted, key=lambda one: -one.gain):
        best.setdefault(trial.candidate.mechanism, trial)
    return tuple(
        NullGain(
            mechanism=name, gain=trial.gain, share=share_of(case, trial)
        )
        for name, trial in best.items()
    )  # fmt: skip


def as_rows(gains: Sequence[NullGain]) -> list[dict[str, Any]]:
    """Return the gains as rows for JSON."""
    return [{"mechanism": one.mechanism, "gain": one.gain, "share": one.share} for one in gains]


def from_rows(rows: Sequence[dict[str, Any]]) -> tuple[NullGain, ...]:
    """Return the gains from rows of JSON."""
    return tuple(NullGain(mechanism=row["mechanism"], gain=row["gain"], share=row["share"]) for row in rows)
