"""Diagnoses, baselines and oracle of a set of trials, compared with the opened answers."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from proof.prove.diagnosing import refusal_path
from proof.prove.trial_set import BASELINE_VERDICTS, COSTS, DIAGNOSES, ORACLE, RECORDINGS
from proof.scoring.claims import Claim, read_claim
from proof.scoring.trial import Trial, trial_of

OURS = "torquerig"


@dataclass(frozen=True, kw_only=True)
class Cost:
    """Wall time [s], processor time [s] and peak memory [MiB] of one diagnosis."""

    case: str
    seconds: float
    processor_seconds: float
    peak_MiB: float  # noqa: N815 (the unit)


@dataclass(frozen=True, kw_only=True)
class ScoredSet:
    """A set of trials with open answers.

    Parameters
    ----------
    name, seal : str
    trials : mapping of str to tuple of Trial
        By method: ``torquerig`` and the baselines; a trial's name begins with the set's.
    said : mapping of str to dict
        The written diagnosis of each case, by the trial's name.
    costs : tuple of Cost
    refusals : mapping of str to str
        Error of each case without a diagnosis.
    """

    name: str
    seal: str
    trials: Mapping[str, tuple[Trial, ...]]
    said: Mapping[str, dict[str, Any]] = field(default_factory=dict)
    costs: tuple[Cost, ...] = ()
    refusals: Mapping[str, str] = field(default_factory=dict)


def scored(
    name: str, folder: Path, answers: Mapping[str, dict[str, Any]], *, seal: str, baselines: Sequence[str] = ()
) -> ScoredSet:
    """Return the outcomes of every case of a folder, from its diagnoses, baselines and oracle."""
    verdicts = {OURS: folder / DIAGNOSES} | {one: folder / BASELINE_VERDICTS / one for one in baselines}
    # a baseline's residual is defined differently, so only the diagnosis is compared with the oracle
    trials = {
        method: _judged(name, answers, where, folder / ORACLE if method == OURS else None)
        for method, where in verdicts.items()
    }
    cases = sorted(answers)
    return ScoredSet(
        name=name,
        seal=seal,
        trials=trials,
        said={_full(name, one): data for one, data in _jsons(folder / DIAGNOSES, cases)},
        costs=tuple(Cost(case=_full(name, one), **data) for one, data in _jsons(folder / COSTS, cases)),
        refusals=_refusals(name, folder, cases),
    )


def recordings_of(folder: Path, case: str) -> Path:
    """Return the folder of a case's recordings."""
    return folder / RECORDINGS / case


def _judged(name: str, answers: Mapping[str, dict[str, Any]], said: Path, oracle: Path | None) -> tuple[Trial, ...]:
    trials = []
    for case, answer in sorted(answers.items()):
        best = None if oracle is None else _claim(oracle / f"{case}.json")
        trial = trial_of(case, answer, _claim(said / f"{case}.json"), oracle=best)
        trials.append(replace(trial, name=_full(name, case)))
    return tuple(trials)


def _claim(path: Path) -> Claim | None:
    return read_claim(path) if path.is_file() else None


def _jsons(folder: Path, cases: Sequence[str]) -> list[tuple[str, Any]]:
    paths = [(case, folder / f"{case}.json") for case in cases]
    return [(case, json.loads(path.read_text(encoding="utf-8"))) for case, path in paths if path.is_file()]


def _refusals(name: str, folder: Path, cases: Sequence[str]) -> dict[str, str]:
    paths = {case: refusal_path(folder, DIAGNOSES, case) for case in cases}
    return {
        _full(name, case): path.read_text(encoding="utf-8").strip() for case, path in paths.items() if path.is_file()
    }


def _full(name: str, case: str) -> str:
    return f"{name}, {case}"
