"""The best speed loop of one motor on each gearbox, behind every filter, by differential evolution."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.filters.chains.all_chains import filtered_by
from torquerig.filters.chains.filter_chain import Chain
from torquerig.metrics.truth_error import truth_error
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.simulation.batch import simulate_part
from torquerig.simulation.batch_parts import BatchRun, alike
from torquerig.simulation.inputs import Draws
from torquerig.study.candidates import Candidate, candidate_of, loop_tuned, scenario_of
from torquerig.study.definition import Study
from torquerig.study.loop_margin import loop_margin
from torquerig.study.optimisation.bounds import Bounds
from torquerig.study.optimisation.tried import Tried
from torquerig.study.planned_drive import planned_drive, sample_span, settling_of
from torquerig.study.preflight import beyond_the_drive
from torquerig.study.settings import SpeedLoopRule

POPULATION = 16  # loops of a generation: two fillings of the vector registers
BAD = 1e6  # [1] error that a loop without margin counts with, times what is missing


@dataclass(frozen=True)
class Optimum:
    """What was tried for a motor.

    Parameters
    ----------
    tried : tuple of Tried
        Within the bounds.
    by_rule : tuple of Tried
        With the speed loop that the study's rule gives, behind each filter, under the same load.
    left_out : mapping of str to str
        Drives that cannot run, with the reason.
    """

    tried: tuple[Tried, ...]
    by_rule: tuple[Tried, ...]
    left_out: Mapping[str, str]


def optimised(
    study: Study, motor: str, bounds: Bounds, *, progress: Callable[[int, int, str], None] | None = None
) -> Optimum:
    """Return everything that was tried for a motor on each gearbox.

    Each gearbox has a search over crossover and integral corner, on a logarithmic scale, for the least reading
    error behind any filter. All runs have one load and one settling, that of the slowest loop within the bounds. The
    drive has the values of the study's seed; so the optimum is that of one draw.

    Source: Storn and Price 1997, J. Global Optimization 11, 341-359, as in SciPy.

    Raises
    ------
    InputError
        Where no gearbox can be used.
    """
    tried: list[Tried] = []
    by_rule: list[Tried] = []
    left_out: dict[str, str] = {}
    made = [candidate_of(study, motor=motor, gearbox=box) for box in bounds.gearboxes or ("",)]
    names = [one.name for one in made]
    stages = [one.gearbox if names.count(one.name) > 1 else "" for one in made]
    listed = [replace(one, told_apart=name) for one, name in zip(made, stages, strict=True)]
    for done, candidate in enumerate(listed, start=1):
        scenario = scenario_of(candidate, study, seed=study.settings.seed)
        reason = beyond_the_drive(candidate, scenario, study)
        if reason:
            left_out[candidate.name] = reason
        else:
            loops = _Loops(candidate, scenario, study, bounds)
            by_rule += loops.tried([study.settings.speed_loop])[0]
            tried += loops.searched()
        if progress is not None:
            progress(done, len(listed), candidate.name)
    if not tried:
        reasons = "; ".join(f"{name}: {why}" for name, why in left_out.items())
        raise InputError(f"no speed loop within the bounds has the margin, or no drive can run ({reasons})")
    return Optimum(tuple(tried), tuple(by_rule), left_out)


class _Loops:
    """The speed loops of one drive."""

    def __init__(self, candidate: Candidate, scenario: Scenario, study: Study, bounds: Bounds) -> None:
        self.candidate, self.scenario, self.study, self.bounds = candidate, scenario, study, bounds
        self.chains, self.draws = study.chains(scenario), Draws()
        alone = replace(study, settings=study.settings.model_copy(update={"draws": 0}))
        self.price = planned_drive(candidate, scenario, alone).result.margins["price"].value
        slowest = _rule(bounds.crossover[0], bounds.integral_corner[0])
        self.span = sample_span(scenario, study, settling=settling_of(slowest))

    def searched(self) -> list[Tried]:
        """Return all loops with the margin that the search came by."""
        from scipy.optimize import differential_evolution

        found: list[Tried] = []

        def errors(points: NDArray[np.float64]) -> NDArray[np.float64]:
            values = []
            for listed in self.tried([_rule(*np.exp(point)) for point in points.T]):
                missing = self.bounds.margin - listed[0].margin
                found.extend(listed if missing <= 0 else ())
                values.append(min(one.error for one in listed) if missing <= 0 else BAD * (1 + missing))
            return np.array(values)

        limits = [tuple(np.log(pair)) for pair in (self.bounds.crossover, self.bounds.integral_corner)]
        generations = max(1, self.bounds.evaluations // POPULATION - 1)
        differential_evolution(
            errors, limits, popsize=POPULATION // 2, maxiter=generations, tol=1e-4, vectorized=True,
            updating="deferred", polish=False, init="sobol", rng=self.study.settings.seed,
        )  # fmt: skip
        return found

    def tried(self, rules: Sequence[SpeedLoopRule]) -> list[list[Tried]]:
        """Return each loop behind each filter; one without the margin is not simulated, its error is infinite."""
        rigs = [loop_tuned(self.scenario.rig, rule, motor=self.study.exchanged.motor) for rule in rules]
        margins = [self._margin(rig, rule) for rig, rule in zip(rigs, rules, strict=True)]
        good = [row for row, margin in enumerate(margins) if margin >= self.bounds.margin or len(rules) == 1]
        readings = dict(zip(good, self._readings([rigs[row] for row in good]), strict=True))
        return [
            [
                Tried(drive=self.candidate.name, filtering=name, crossover=rule.crossover,
                      integral_corner=rule.integral_corner, error=error, delay=delay, price=self.price, margin=margin)
                for name, error, delay in self._behind_filters(readings.get(row))
            ]
            for row, (rule, margin) in enumerate(zip(rules, margins, strict=True))
        ]  # fmt: skip

    def _readings(self, rigs: Sequence[Rig]) -> list[Recording]:
        runs = [BatchRun.of(rig, self.span) for rig in rigs]
        made: dict[int, Recording] = {}
        for part in alike(runs):
            made |= dict(zip(part, simulate_part([runs[row] for row in part], draws=self.draws), strict=True))
        return [made[row] for row in range(len(runs))]

    def _behind_filters(self, reading: Recording | None) -> Iterator[tuple[str, float, float | None]]:
        if reading is None:
            yield "", np.inf, None
            return
        for name, after in filtered_by(self.chains, reading):
            yield name, truth_error(after, reading), delay_of(self.chains[name], reading)

    def _margin(self, rig: Rig, rule: SpeedLoopRule) -> float:
        """Return the modulus margin of a loop [1]: 0 where it is unstable, infinite where it cannot be computed."""
        made = loop_margin(rig, motor=self.study.exchanged.motor, crossover=rule.crossover, rate=self.span.rate)
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
