"""The runs of a drive's samples, and its results from their recordings as they arrive in any order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from threading import Lock
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from torquerig.filters.chains.all_chains import filtered_by
from torquerig.filters.filter_effect import FilterEffect, chain_effects
from torquerig.metrics.figure import Figure
from torquerig.metrics.load_path import load_path
from torquerig.metrics.random_error import rms_standard_error
from torquerig.metrics.shares import DISTURBANCES, SENSED, Shares, sensed, shares_of
from torquerig.metrics.truth_error import TRUE_LOADS, difference, truth_error
from torquerig.scenario.kinematics import kinematics_of
from torquerig.simulation.batch_parts import BatchRun
from torquerig.simulation.united_runs import simulate_united
from torquerig.study.planned_drive import PlannedDrive, sample_span
from torquerig.study.preflight import margin_of
from torquerig.study.results import ChainResult, DriveResult
from torquerig.study.settings import metrics_of

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording
    from torquerig.rig.assembly import Rig
    from torquerig.scenario.model import Scenario
    from torquerig.study.definition import Study

WHOLE, QUIET = (), DISTURBANCES


@dataclass(frozen=True, kw_only=True)
class SampleRun:
    """One run: a sample of a drive, without the parts of some groups."""

    drive: int
    number: int
    left_out: tuple[str, ...]
    run: BatchRun


@dataclass(kw_only=True)
class _Sample:
    """Figures of one sample; recordings only until they are measured."""

    recordings: dict[tuple[str, ...], Recording]
    disturbance: float = 0.0
    errors: Mapping[str, float] | None = None
    remaining: Mapping[str, float] | None = None


class DriveSamples:
    """One drive while its samples are simulated.

    Parameters
    ----------
    row : int
        Of the drive in the study.
    planned : PlannedDrive
    study : Study
    """

    def __init__(self, row: int, planned: PlannedDrive, study: Study) -> None:
        self.row, self.planned, self.study = row, planned, study
        self._samples = [_Sample(recordings={}) for _ in planned.samples]
        self._lock, self._missing = Lock(), len(self._wanted())
        self._effects: dict[str, tuple[FilterEffect, float | None]] = {}
        self._shares: Shares | None = None

    def runs(self) -> Iterator[SampleRun]:
        """Yield every run: each sample with and without its lines, the first also without one group at a time."""
        for number, left_out in self._wanted():
            scenario = self.planned.samples[number]
            run = BatchRun.of(
                _without(scenario.rig, left_out), sample_span(scenario, self.study, number=number),
                staged=left_out == WHOLE or self._filters_both(),
            )  # fmt: skip
            yield SampleRun(drive=self.row, number=number, left_out=left_out, run=run)

    def add(self, run: SampleRun, recording: Recording) -> bool:
        """Take the recording of a run, measure what is complete, and return whether it was the last one."""
        sample = self._samples[run.number]
        with self._lock:
            sample.recordings[run.left_out] = _held(recording, run)
            complete = len(sample.recordings) == sum(number == run.number for number, _ in self._wanted())
        if complete:
            self._measure(run.number)
        with self._lock:
            self._missing -= 1
            return self._missing == 0

    def result(self) -> DriveResult:
        """Return the results of the drive, when all of its runs are there."""
        if not self.planned.samples:
            return self.planned.result
        first, study, samples = self.planned.samples[0], self.study, self._samples
        assumed, unit = first.assumed, study.effort_unit
        chains = {}
        for name, chain in study.chains(first).items():
            effect, random = self._effects[name]
            errors = [sample.errors[name] for sample in samples if sample.errors is not None]
            left = [sample.remaining[name] for sample in samples if sample.remaining is not None]
            remainder: _Remainder = {"residual_disturbance": _figure(left, assumed, unit=unit)} if left else {}
            chains[name] = ChainResult(
                chain=name, effect=effect, truth_error=_figure(errors, assumed, unit=unit), left_out=chain.left_out,
                random_error=random / errors[0] * float(np.median(errors)) if random and errors[0] else None,
                **remainder,
            )  # fmt: skip
        return replace(
            self.planned.result, shares=self._shares, load_path=load_path(first.rig), loop=margin_of(first, study),
            chains=chains,
            duration=study.settings.duration,
            simulated=partial(first_recording, first, study),
            disturbance=_figure([sample.disturbance for sample in samples], assumed, unit=unit),
        )  # fmt: skip

    def _wanted(self) -> list[tuple[int, tuple[str, ...]]]:
        pairs = [(number, left) for number in range(len(self.planned.samples)) for left in (WHOLE, QUIET)]
        return pairs + ([(0, (group,)) for group in DISTURBANCES] if pairs else [])

    def _filters_both(self) -> bool:
        return "residual_disturbance" in metrics_of(self.study.settings)

    def _measure(self, number: int) -> None:
        sample, scenario = self._samples[number], self.planned.samples[number]
        whole, quiet = sample.recordings[WHOLE], sample.recordings[QUIET]
        sample.disturbance = float(np.std(sensed(whole) - sensed(quiet)))
        chains = self.study.chains(scenario)
        made = dict(filtered_by(chains, whole))
        sample.errors = {name: truth_error(after, whole) for name, after in made.items()}
        if self._filters_both():
            calm = dict(filtered_by(chains, quiet))
            sample.remaining = {
                name: float(np.std(after.torque() - calm[name].torque())) for name, after in made.items()
            }
        if number == 0:
            alone = {group: sample.recordings[(group,)] for group in DISTURBANCES}
            self._shares = shares_of(whole, quiet, without=alone)
            effects = chain_effects(
                whole, tuple(made.values()), ratio=kinematics_of(scenario.rig).ratio,
                lines=tuple(chains[name].lines for name in made),
            )  # fmt: skip
            for (name, after), effect in zip(made.items(), effects, strict=True):
                random = rms_standard_error(difference(after, whole), rate=whole.sample_rate)
                self._effects[name] = effect, random
        sample.recordings = {}


class _Remainder(TypedDict, total=False):
    """The disturbance behind a chain, where a criterion uses it."""

    residual_disturbance: Figure


def first_recording(scenario: Scenario, study: Study) -> Recording:
    """Return the recording of a drive's first sample, simulated again."""
    return simulate_united([BatchRun.of(scenario.rig, sample_span(scenario, study))], scenario=scenario.title)[0]


def _held(recording: Recording, run: SampleRun) -> Recording:
    """Return what is needed of a recording, copied: the memory of the batch can be freed."""
    truths = (*SENSED, *TRUE_LOADS) if run.run.staged or (run.number == 0 and run.left_out == QUIET) else SENSED
    return replace(
        recording,
        channels={
            name: replace(one, values=one.values.copy())
            for name, one in recording.channels.items()
            if not one.truth or name in truths
        },
    )


def _without(rig: Rig, groups: tuple[str, ...]) -> Rig:
    return replace(rig, parts=tuple(part for part in rig.parts if part.group not in groups)) if groups else rig


def _figure(values: list[float], assumed: Mapping[str, str], *, unit: str) -> Figure:
    """Return the median of the samples, with their extremes."""
    missing = ", ".join(assumed) if assumed else ""
    return Figure(value=float(np.median(values)), low=min(values), high=max(values), unit=unit,
                  source=f"simulated, median of {len(values)} samples", missing=missing)  # fmt: skip
