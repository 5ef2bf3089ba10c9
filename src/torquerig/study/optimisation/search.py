"""The best ratio, speed loop and filter of one motor, by differential evolution; a generation is one batch."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, RecordingError
from torquerig.filters.chains.all_chains import filtered_by
from torquerig.filters.chains.filter_chain import Chain
from torquerig.metrics.truth_error import truth_error
from torquerig.recordings.recording import Recording
from torquerig.simulation.batch import simulate_part
from torquerig.simulation.batch_parts import BatchRun, alike
from torquerig.simulation.inputs import Draws
from torquerig.study.candidates import candidate_of, loop_tuned
from torquerig.study.definition import Study
from torquerig.study.loop_margin import loop_margin
from torquerig.study.optimisation.bounds import Bounds
from torquerig.study.optimisation.choices import Choice, choice_at, limits_of, settings_at
from torquerig.study.optimisation.tried import Tried
from torquerig.study.optimisation.tried_drives import CatalogDrive, ScaledDrive, TriedDrive
from torquerig.study.optimisation.varied_number import varied_texts
from torquerig.study.planned_drive import sample_span, settling_of
from torquerig.study.settings import SpeedLoopRule

POPULATION = 8  # choices of a generation for each number that varies: one filling of the vector registers
BAD = 1e6  # [1] error that a loop without margin counts with, times what is missing
SWEPT = 32  # settings of the varied numbers of a filter, tried on the reading of the best loop


@dataclass(frozen=True)
class Optimum:
    """What was tried for a motor.

    Parameters
    ----------
    tried : tuple of Tried
        Within the bounds.
    by_rule : tuple of Tried
        With the speed loop that the study's rule gives, behind each filter as stated, under the same load; none for a
        continuous ratio.
    left_out : mapping of str to str
        Drives that cannot run, with the reason.
    """

    tried: tuple[Tried, ...]
    by_rule: tuple[Tried, ...]
    left_out: Mapping[str, str]


def optimised(
    study: Study, motor: str, bounds: Bounds, *, progress: Callable[[int, int, str], None] | None = None
) -> Optimum:
    """Return everything that was tried for a motor on each gearbox, or at a continuous ratio.

    Each gearbox has a search over crossover, integral corner and numbers of the filters, on logarithmic scales, for
    the least reading error behind any filter; a continuous ratio is one more number of one search. The reading of the
    best loop of each filter is then filtered with settings spread over their bounds, for delay against error. All runs
    have one load and one settling, that of the slowest loop within the bounds. The drive has the values of the study's
    seed; so the optimum is that of one draw.

    Source: Storn and Price 1997, J. Global Optimization 11, 341-359, as in SciPy.

    Raises
    ------
    InputError
        Where no gearbox can be used.
    """
    tried: list[Tried] = []
    by_rule: list[Tried] = []
    left_out: dict[str, str] = {}
    listed = _drives(study, motor, bounds)
    for done, drive in enumerate(listed, start=1):
        fault = drive.at(None).fault if isinstance(drive, CatalogDrive) else ""
        if fault:
            left_out[drive.name] = fault
        else:
            loops = _Loops(drive, study, bounds)
            by_rule += loops.by_rule()
            found = loops.searched()
            tried += found
            if not found and loops.fault:
                left_out[drive.name] = loops.fault
        if progress is not None:
            progress(done, len(listed), drive.name)
    if not tried:
        reasons = "; ".join(f"{name}: {why}" for name, why in left_out.items())
        raise InputError(f"no speed loop within the bounds has the margin, or no drive can run ({reasons})")
    return Optimum(tuple(tried), tuple(by_rule), left_out)


def _drives(study: Study, motor: str, bounds: Bounds) -> list[CatalogDrive | ScaledDrive]:
    if bounds.ratio is not None:
        return [ScaledDrive(study, motor, bounds.ratio)]
    made = [candidate_of(study, motor=motor, gearbox=box) for box in bounds.gearboxes or ("",)]
    names = [one.name for one in made]
    stages = [one.gearbox if names.count(one.name) > 1 else "" for one in made]
    return [
        CatalogDrive.of(study, replace(one, told_apart=name)) for one, name in zip(made, stages, strict=True)
    ]  # fmt: skip


class _Loops:
    """The choices of one drive."""

    def __init__(self, drive: CatalogDrive | ScaledDrive, study: Study, bounds: Bounds) -> None:
        self.drive, self.study, self.bounds, self.draws = drive, study, bounds, Draws()
        slowest = _rule(bounds.crossover[0], bounds.integral_corner[0])
        self.settling = settling_of(slowest)
        self.fault = ""  # of the last drive that cannot run

    def by_rule(self) -> list[Tried]:
        """Return the loop of the study's rule behind each filter as stated; none for a continuous ratio."""
        if isinstance(self.drive, ScaledDrive):
            return []
        rule = self.study.settings.speed_loop
        stated = Choice(rule.crossover, rule.integral_corner)
        return self.tried([stated], least=-np.inf)[0]

    def searched(self) -> list[Tried]:
        """Return all choices with the margin that the search came by, and the settings that were swept."""
        from scipy.optimize import differential_evolution

        found: list[Tried] = []
        least: dict[str, tuple[float, Choice]] = {}

        def errors(points: NDArray[np.float64]) -> NDArray[np.float64]:
            choices = [choice_at(point, self.bounds) for point in points.T]
            values = []
            for choice, listed in zip(choices, self.tried(choices, least=self.bounds.margin), strict=True):
                missing = self.bounds.margin - listed[0].margin
                for one in listed if missing <= 0 else ():
                    found.append(one)
                    least[one.filtering] = min(
                        least.get(one.filtering, (np.inf, choice)), (one.error, choice), key=lambda pair: pair[0]
                    )
                values.append(min(one.error for one in listed) if missing <= 0 else BAD * (1 + missing))
            return np.array(values)

        limits = limits_of(self.bounds)
        generations = max(1, self.bounds.evaluations // (POPULATION * len(limits)) - 1)
        differential_evolution(
            errors, limits, popsize=POPULATION, maxiter=generations, tol=1e-4, vectorized=True,
            updating="deferred", polish=False, init="sobol", rng=self.study.settings.seed,
        )  # fmt: skip
        for filtering, (_, choice) in least.items():
            found += self._swept(filtering, choice)
        return found

    def tried(self, choices: Sequence[Choice], *, least: float) -> list[list[Tried]]:
        """Return each choice behind each filter; one whose margin is below ``least`` [1] has an infinite error."""
        drives = [self.drive.at(choice.ratio) for choice in choices]
        rigs = [
            loop_tuned(drive.scenario.rig, _rule(choice.crossover, choice.corner), motor=self.study.exchanged.motor)
            for drive, choice in zip(drives, choices, strict=True)
        ]
        runs = [
            BatchRun.of(rig, sample_span(drive.scenario, self.study, settling=self.settling))
            for rig, drive in zip(rigs, drives, strict=True)
        ]
        margins = [
            -1.0 if drive.fault else self._margin(run, choice)
            for run, drive, choice in zip(runs, drives, choices, strict=True)
        ]
        self.fault = next((drive.fault for drive in drives if drive.fault), self.fault)
        good = [row for row, margin in enumerate(margins) if margin >= least]
        readings = dict(zip(good, self._readings([runs[row] for row in good]), strict=True))
        return [
            [
                self._figures(drive, choice, filtering=name, error=error, delay=delay, margin=margin)
                for name, error, delay in self._behind_filters(drive, choice, readings.get(row))
            ]
            for row, (drive, choice, margin) in enumerate(zip(drives, choices, margins, strict=True))
        ]

    def _figures(
        self, drive: TriedDrive, choice: Choice, *, filtering: str, error: float, delay: float | None, margin: float
    ) -> Tried:
        numbers = self.bounds.numbers
        settings = tuple(
            number.shown(value)
            for number, value in zip(numbers, choice.numbers or (), strict=False) if number.chain == filtering
        )  # fmt: skip
        return Tried(
            drive=drive.candidate.name, filtering=filtering, crossover=choice.crossover, integral_corner=choice.corner,
            error=error, delay=delay, price=drive.price, margin=margin, settings=settings,
        )  # fmt: skip

    def _swept(self, filtering: str, choice: Choice) -> list[Tried]:
        """Return one loop behind one filter with settings of its varied numbers spread over their bounds."""
        rows = [row for row, number in enumerate(self.bounds.numbers) if number.chain == filtering]
        if not rows:
            return []
        drive = self.drive.at(choice.ratio)
        rig = loop_tuned(drive.scenario.rig, _rule(choice.crossover, choice.corner), motor=self.study.exchanged.motor)
        run = BatchRun.of(rig, sample_span(drive.scenario, self.study, settling=self.settling))
        margin, (reading,) = self._margin(run, choice), self._readings([run])
        made = []
        for settings in settings_at(self.bounds, choice, rows, count=SWEPT, seed=self.study.settings.seed):
            ((_, after, delay),) = self._filtered(drive, settings, reading, only=filtering)
            made.append(self._figures(drive, settings, filtering=filtering, error=after, delay=delay, margin=margin))
        return made

    def _readings(self, runs: Sequence[BatchRun]) -> list[Recording]:
        made: dict[int, Recording] = {}
        for part in alike(runs):
            made |= dict(zip(part, simulate_part([runs[row] for row in part], draws=self.draws), strict=True))
        return [made[row] for row in range(len(runs))]

    def _behind_filters(
        self, drive: TriedDrive, choice: Choice, reading: Recording | None
    ) -> Iterator[tuple[str, float, float | None]]:
        if reading is None:
            yield "", np.inf, None
            return
        yield from self._filtered(drive, choice, reading)

    def _filtered(
        self, drive: TriedDrive, choice: Choice, reading: Recording, *, only: str | None = None
    ) -> Iterator[tuple[str, float, float | None]]:
        texts = {} if choice.numbers is None else varied_texts(self.study, self.bounds.numbers, choice.numbers)
        chains = self.study.chains(drive.scenario, texts)
        wanted = {name: chain for name, chain in chains.items() if only in (None, name)}
        try:
            for name, after in filtered_by(wanted, reading):
                yield name, truth_error(after, reading), delay_of(wanted[name], reading)
        except RecordingError as error:  # a cutoff above half the rate, a window longer than the recording
            raise InputError(f"{'--vary: ' if choice.numbers else ''}{error}") from None

    def _margin(self, run: BatchRun, choice: Choice) -> float:
        """Return the modulus margin of a loop [1]: 0 where it is unstable, infinite where it cannot be computed."""
        made = loop_margin(
            run.rig, motor=self.study.exchanged.motor, crossover=choice.crossover, rate=run.span.rate
        )  # fmt: skip
        if made is None:
            return np.inf
        return made.modulus if made.stable else 0.0


def _rule(crossover: float, integral_corner: float) -> SpeedLoopRule:
    return SpeedLoopRule.model_construct(crossover=float(crossover), integral_corner=float(integral_corner))


def delay_of(chain: Chain, recording: Recording) -> float | None:
    """Return the delay of a slow load behind a chain [s]; None where a stage needs the whole recording."""
    delays = [getattr(stage, "delay", None) for stage in chain.stages]
    if any(delay is None for delay in delays):
        return None
    return float(sum(delay(recording) for delay in delays if delay is not None))
