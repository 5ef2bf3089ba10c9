"""Which of what was found is believed: each outcome foretells what no fit has seen; the first that holds is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.diagnosis.beginning import Beginning
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.opened_gap import GAP, flanks_may_part
from torquerig.diagnosis.findings import Searched
from torquerig.diagnosis.judging.both_ways import rings_both_ways
from torquerig.diagnosis.judging.by_simulation import left_by_simulation
from torquerig.diagnosis.judging.changing import changing
from torquerig.diagnosis.judging.combined_lines import may_be_combined
from torquerig.diagnosis.judging.fixed_after_all import looked_at_as_found
from torquerig.diagnosis.judging.growing_lines import growing_lines
from torquerig.diagnosis.judging.held_out import held_out
from torquerig.diagnosis.judging.leftover import detail_of, mismatches, of_flights, stands_at
from torquerig.diagnosis.judging.passing import passing
from torquerig.diagnosis.judging.untold_runs import flat_in_the_model_alone, of_untold_loads
from torquerig.diagnosis.judging.whole_fit import FAR, missed_everywhere
from torquerig.diagnosis.judging.withdrawn import (
    COMES_AND_GOES,
    LEAVES_A_REST,
    ONE_OF_MANY,
    STILL_WRONG,
    TOO_MANY,
    why_withdrawn,
)
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.outcome import HeldOut
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.rig.assembly import Rig

# reasons that hold beside numbers that stand still, which explain no more of a rest
_WHATEVER_MOVES = (COMES_AND_GOES, TOO_MANY, STILL_WRONG, ONE_OF_MANY)


@dataclass(frozen=True, kw_only=True)
class Believed:
    """What is told of a search, and how it foretells what no fit has seen.

    Parameters
    ----------
    sought : Searched
    why : str
        Why what was found before it was withdrawn; nothing where nothing was.
    after : Case
        With what is told in its model.
    held : tuple of Features
        Of the stretches that no fit has seen, looked at as what was found asks for.
    completed : Rig
        The fitted rig with all that was found.
    fit : HeldOut
    missed : tuple of Mismatch
        Where the nominal model was significantly wrong.
    left : tuple of Mismatch
        Where the completed model still is.
    changes : tuple of (str, Mismatch)
        What changes within runs that should be steady, in words and located.
    came_and_went : tuple of Mismatch
        Times at which a steady run's spectrum stands elsewhere than the completed model's.
    detail : float or None
        The share of what was missing that stays, where that is but the detail of what was found.
    """

    sought: Searched
    why: str
    after: Case
    held: tuple[Features, ...]
    completed: Rig
    fit: HeldOut
    missed: tuple[Mismatch, ...]
    left: tuple[Mismatch, ...]
    changes: tuple[tuple[str, Mismatch], ...]
    came_and_went: tuple[Mismatch, ...]
    detail: float | None

    @property
    def changing_spectra(self) -> tuple[Mismatch, ...]:
        """What comes, goes or moves within runs."""
        return (*self.came_and_went, *(mismatch for _, mismatch in self.changes))


@dataclass(frozen=True, kw_only=True)
class _Known:
    """What is the same for each outcome."""

    start: Beginning
    missed: tuple[Mismatch, ...]
    changes: tuple[tuple[str, Mismatch], ...]
    seed: int


def believed(start: Beginning, found: Searched, *, seed: int) -> Believed:
    """Return the first outcome of a search that is not refused; at last that nothing was found.

    Parameters
    ----------
    start : Beginning
    found : Searched
    seed : int
        Of the bootstrap of what the held-out misfit falls by.
    """
    before, fitted = start.before, start.of_fitted_runs()
    whole = [run for run in before.runs if run.name not in start.faults.clipped]
    own = [place for place in before.seen[0].places if place not in before.seen[0].unknown]
    changes = (*changing(whole), *growing_lines(whole, own))
    known, why = _Known(start=start, missed=mismatches(before), changes=changes, seed=seed), ""
    for sought in found.in_turn(before, fitted):
        if _asked_in_vain(sought, why):
            continue
        told = _foretold(known, sought, why=why)
        refused = _refused(start, told)
        if not (sought.accepted and refused):
            break
        why = refused
    return told


def _asked_in_vain(sought: Searched, why: str) -> bool:
    """Whether it is what was refused, beside numbers that stand still, where that cannot help.

    They explain no more of a rest; but with a line in the model others may have moved.
    """
    return sought.numbers_held and (why in _WHATEVER_MOVES or (why == LEAVES_A_REST and not sought.all_lines))


def _foretold(known: _Known, sought: Searched, *, why: str) -> Believed:
    """Return the outcome with its simulations beside what no fit has seen."""
    start, before = known.start, known.start.before
    after, held = looked_at_as_found(sought.case, start.held)
    fitted, completed = start.faults.removed_from(before.model.rig), start.faults.added_to(after.model.rig)
    if start.own_gap is not None:
        width = start.own_gap.told(completed)
        completed, fitted = start.own_gap.reopened(completed), start.own_gap.reopened(fitted, width=width)
    untold = of_untold_loads(start.held, fitted={run.name for run in before.runs})
    untold |= flat_in_the_model_alone(fitted, completed, held)
    fit = held_out(start.whole, fitted, completed, held, seed=known.seed, untold=untold)
    came_and_went = passing(after, completed)
    moved = (mismatch for _, mismatch in known.changes)
    left = (*left_by_simulation(after, mismatches(after)), *came_and_went, *moved)
    detail = detail_of(before, after, left)
    return Believed(
        sought=sought, why=why, after=after, held=held, completed=completed, fit=fit, missed=known.missed,
        left=left if detail is None else (), changes=known.changes, came_and_went=came_and_went, detail=detail,
    )  # fmt: skip


def _refused(start: Beginning, told: Believed) -> str:
    """Return why it is not to be believed; nothing where it is."""
    accepted = told.sought.accepted
    ratio = abs(start.before.nominal.run.gear_ratio or 1.0)
    places = [each.trial.candidate.place for each in accepted if each.trial.candidate.place is not None]
    return why_withdrawn(
        told.fit, told.left, effects=len(accepted), passing=told.came_and_went,
        resembled=any(each.trial.candidate.resembled for each in accepted),
        drifts_in_all=bool(told.changes) and told.after.has("sensor_drift"),
        samples_too=bool(start.untrue or start.faults.untrue), again=told.why == LEAVES_A_REST,
        turning_lines=told.sought.turning_lines,
        combined=told.sought.turning_lines and may_be_combined(
            told.after, told.left or told.missed, [each.trial.candidate for each in accepted]
        ),
        own_line=told.sought.lines_of_one_size
        and any(stands_at(mismatch, place, ratio) for mismatch in told.left for place in places),
        both_ways=rings_both_ways(told.left, told.after.model.rig),
        everywhere=missed_everywhere(told.after, told.held, by=FAR), gap=told.after.has(GAP),
        flights_told=_flown(start.before, told.missed)
        and told.after.has(GAP)
        and not any(of_flights(each) for each in told.left),
    )  # fmt: skip


def _flown(before: Case, missed: Sequence[Mismatch]) -> bool:
    """Whether flanks flew in several runs, or in the only one in which they may: what slips does so in one of them."""
    several = min(2, sum(map(flanks_may_part, before.from_zero)))
    return several > 0 and any(of_flights(each) and len(each.recordings) >= several for each in missed)
