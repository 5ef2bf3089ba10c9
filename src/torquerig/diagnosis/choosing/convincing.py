"""When is an effect called missing? It gains enough, explains its places, and foretells what no fit has seen."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.beside_gaps import gained_by_closed_lines
from torquerig.diagnosis.choosing.beside_ringing import details_of_ringing
from torquerig.diagnosis.choosing.explained import LEAST_SHARE_WHERE_ALL_FITS, changes_places, explained_share
from torquerig.diagnosis.choosing.opened_gap import GAP, flanks_fly_for_sure
from torquerig.diagnosis.choosing.search import WELL, excess, feature_count
from torquerig.diagnosis.choosing.secondary import hump_of_a_tone
from torquerig.diagnosis.choosing.told_by_lines import told_by_lines
from torquerig.diagnosis.choosing.trial import LEAST_GAIN, Trial
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import misfit_sum, missed_alone, robust_squares
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.diagnosis.looking.features import Features

_WHOLLY, _ALL = 6, 0.97  # power of the share by which gains are compared, and the share that counts as all
_LARGE = 60.0  # gain above which a smaller share is enough, if the model then fits as a whole
_VERY_LARGE, _HALF = 180.0, 0.45  # gain that no chance brings: of what else moved with it, that much may stray
_AMPLY = 0.6  # per feature, without prices: as rigs are fitted whose model lacks nothing (0.2 to 0.6 of blind ones)
_OF_EARLIER = 0.25  # an effect beyond the twin leaves small lines of its own, which are no effects
_OF_EARLIER_TOLD_AGAIN = 0.05  # less where its own number was told again beside the other effect
_WHERE_CLOSED = 80.0  # gained by lines where flanks stay closed: twice what an effect must gain in all
_DETAIL = 0.01  # of what an effect of the shafts gained, its own details may gain where nothing stands out any more
_OF_ALL = 0.05  # of what is wrong: less may be the detail of something that nothing tried explains
_MOST_MISSED = 3.0  # per feature: a model that misses by more lacks something large, and its spreads are not in doubt
# a first effect that explains so much of its places, and gains at least half of it on what no fit has seen, needs less;
# what noise resembles gains there nearly all that it would need (of 150 clean rigs none has a mode that gains over 16)
_WHOLE, _AGAIN, _LESS, _NEARLY = 0.9, 0.5, 0.5, 0.7
# one that gains so much, and as much on what no fit has seen, may leave more at its places: clean rigs reach 55
_MUCH, _AS_WELL, _MORE_THAN_HALF = 100.0, 0.9, 0.55
# where nothing stands out before it: half of its places, if what no fit has seen gains more than on a clean rig (53 at
# most of 86); where no single feature falls clearly, for what was called chance or bent comes back all over: twice what
# it must gain, and half of that on what no fit has seen
_AGAIN_BY_ITSELF, _TWICE = 75.0, 2.0
_OF_WRONG = 0.1  # of what is wrong: beside a load that steps in one run, a drift takes up a little in the others
_OF_RECORDINGS = 0.5  # of a gain: where recordings bear less of it, it is numbers that come back ...
_NO_WORSE = -0.25  # ... and what no fit has seen may lose so much of it
_ANY_WIDTH = 25.0  # between the bounds of an interval that covers all gaps that are tried, 1.5 to 45 arcmin
_MEAN_SQUARE = 3.0  # of the levels of a run: what moves the slow torque alone must leave it right in every run
_PROMISING_GAIN, _PROMISING_SHARE = 0.3, 0.5  # of the misfit, of its places


def convincing(case: Case, trial: Trial, *, earlier: Sequence[Trial], held: Sequence[Features]) -> bool:
    """Whether the trial may be named.

    What it must gain is counted in units of what a feature is still missed by, which is above 1 where the model is
    wrong otherwise (the variance inflation of Burnham & Anderson 2002, Model Selection and Multimodel Inference, 2.5).

    Parameters
    ----------
    case : Case
        Before it.
    trial : Trial
    earlier : sequence of Trial
        What was taken into the model before.
    held : sequence of Features
        Of the stretches that no fit has seen.
    """
    if _out_of_question(case, trial, earlier):
        return False
    details = [*_gains_of_details(case, trial, earlier), _OF_ALL * excess(case)]
    missed = min(max(trial.model.cost / feature_count(trial.model), 1.0), _MOST_MISSED)
    least = _least_gain(case, trial) * missed
    by_lines = told_by_lines(case, trial, held)
    if trial.gain <= max(0.0 if by_lines else _LESS * least, *details):
        return False
    again = _gained_again(case, trial, held)
    if again is not None and again < 0:
        if again < _NO_WORSE or not _by_numbers_alone(case, trial):
            return False
        again = None
    if by_lines:
        return True
    alone = not (trial.candidate.description or any(_may_leave(each, trial) for each in earlier))
    trusted, share = (again or 0.0) if alone else 0.0, share_of(case, trial)
    if trusted and not _falls_clearly(case, trial):
        return trial.gain > _TWICE * least and trusted * trial.gain > _AGAIN * least
    again_enough = trusted * trial.gain > _NEARLY * least if trial.candidate.resembled else trusted > _AGAIN
    borne_out = share > _WHOLE and again_enough and not trial.candidate.as_loads
    beside_more = _mode(trial) and excess(case) > 2 * trial.gain  # what else is wrong with the shafts moves their modes
    enough = max(_enough(case, trial, trusted), _WHOLE if beside_more else 0.0)
    return share > enough and (trial.gain > least or borne_out)


def _out_of_question(case: Case, trial: Trial, earlier: Sequence[Trial]) -> bool:
    """Whether it is not to be named, however much it gains."""
    if trial.candidate.description and not mismatches(case):
        return True  # what does not stand out needs no description
    if _levels_still_wrong(trial) or hump_of_a_tone(trial, earlier):
        return True
    # such an effect beside noise that was described takes up what its description leaves
    return (_mode(trial) or _of_any_width(trial)) and any(each.candidate.description for each in earlier)


def _by_numbers_alone(case: Case, trial: Trial) -> bool:
    """Whether most of the gain is that numbers of the model come back which were bent: no recording can tell that."""
    return misfit_sum(case.model.misfits) - misfit_sum(trial.model.misfits) < _OF_RECORDINGS * trial.gain


def _falls_clearly(case: Case, trial: Trial) -> bool:
    """Whether the trial changes a feature for the better so that it can be told which share of its places it takes."""
    return trial.alone > 0 or changes_places(case.model.misfits, trial.model.misfits)


def _mode(trial: Trial) -> bool:
    """Whether it is one of the shafts' own modes, which noise resembles and whose place their other numbers move."""
    return trial.candidate.resembled and bool(trial.candidate.bends)


def _may_leave(earlier: Trial, trial: Trial) -> bool:
    """Whether what the trial explains may be a rest of an earlier effect: not the slow torque, of one that has none."""
    return not trial.candidate.loosens or bool(earlier.candidate.loosens) or bool(earlier.model.corrections)


def _levels_still_wrong(trial: Trial) -> bool:
    """Whether it moves the slow torque alone, and that of a run strays beside it: its course is another one.

    What goes to and fro from one level to the next is none: a slow shaft's line, of which they hold no whole turns.
    """
    levels = [each.level for each in trial.model.misfits if each.level.size and trial.candidate.slow]
    return any(float(np.mean(robust_squares(level))) > _MEAN_SQUARE and level[1:] @ level[:-1] > 0 for level in levels)


def _of_any_width(trial: Trial) -> bool:
    """Whether it is a gap whose width nothing tells: what comes near zero now and then asks for no width."""
    low, high = trial.candidate.within.get("gap", (1.0, 1.0))
    return high > _ANY_WIDTH * low


def _enough(case: Case, trial: Trial, again: float) -> float:
    """Return which share of its places an effect must explain: less where the model then fits as a whole.

    Less, too, where it gains much, for itself and of all that is wrong, and ``again`` on what no fit has seen, as a
    share of that gain; and of a gap whose flights are seen, since how its flanks meet is another law's.
    """
    if trial.candidate.mechanism == GAP and trial.gain > _VERY_LARGE and flanks_fly_for_sure(case):
        return _HALF
    count = feature_count(trial.model)
    well = count * (1.0 if trial.gap is None else WELL)
    fits = trial.model.cost < well or missed_alone(trial.model.misfits) < _AMPLY * count
    enough = LEAST_SHARE
    if fits and trial.gain > _LARGE:
        enough = _HALF if trial.gain > _VERY_LARGE else LEAST_SHARE_WHERE_ALL_FITS
    much = trial.gain > max(_MUCH, _OF_WRONG * excess(case))
    if much and again * trial.gain > _AGAIN_BY_ITSELF and not mismatches(case):
        return min(enough, _HALF)
    return min(enough, _MORE_THAN_HALF) if much and again > _AS_WELL else enough


def _gains_of_details(case: Case, trial: Trial, earlier: Sequence[Trial]) -> list[float]:
    """Return what the details of effects that were found earlier may gain when another effect takes them up."""
    rings = details_of_ringing(case, trial, earlier)
    if case.model.corrections and gained_by_closed_lines(case, trial) > _WHERE_CLOSED:
        return rings
    if trial.gap is not None:
        return [*rings, *(_OF_EARLIER_TOLD_AGAIN * each.gain for each in earlier)]
    if case.model.corrections or rings:
        return [*rings, *(_OF_EARLIER * each.gain for each in earlier)]
    own = [each for each in earlier if _may_leave(each, trial)]
    turning = [each for each in own if each.candidate.place is None or each.candidate.place.domain == "order"]
    return [_DETAIL * each.gain for each in turning] if turning and not mismatches(case) else []


def _least_gain(case: Case, trial: Trial) -> float:
    if case.thresholds is None:
        return LEAST_GAIN
    return case.thresholds.least_gain(trial.candidate.mechanism, built_in=LEAST_GAIN)


def promising(case: Case, trial: Trial) -> bool:
    """Whether the trial takes away so much that it is worth asking what another beside it would do."""
    return not _levels_still_wrong(trial) and takes_much(case, trial)


def takes_much(case: Case, trial: Trial) -> bool:
    """Whether the trial takes away a third of what is wrong, and half at its own places."""
    much = trial.gain > max(_PROMISING_GAIN * excess(case), LEAST_GAIN)
    return much and not trial.candidate.description and share_of(case, trial) > _PROMISING_SHARE


def hopeful(case: Case, trial: Trial) -> bool:
    """Whether the trial explains its places, and would be named but for what the model misses elsewhere.

    A second effect beside it may take that away; alone it is worth nothing.
    """
    if trial.candidate.description or trial.gain <= _least_gain(case, trial):
        return False
    return share_of(case, trial) > LEAST_SHARE


def worth(case: Case, trial: Trial) -> float:
    """Return the gain, less for what leaves a rest at its places: a stand-in may gain more than what is there."""
    return trial.gain * min(max(share_of(case, trial), 0.0) / _ALL, 1.0) ** _WHOLLY


def worthiest(case: Case, found: Sequence[Trial]) -> Trial:
    """Return the trial that is worth most; of those that explain the same line, the one that gains most."""
    best = max(found, key=partial(worth, case))
    place = best.candidate.place
    alike = [each for each in found if place is not None and each.candidate.place == place]
    return max(alike, key=lambda trial: trial.gain, default=best)


def share_of(case: Case, trial: Trial) -> float:
    """Return the part of the misfit at its places that the trial explains [1]; what else moved with it is not its.

    Where another effect bends the model's numbers, much moves with a line; it is judged beside these as they stood. A
    model that lacks an effect of the slow torque calls that chance: what it missed is counted as the effect's own does.
    """
    after = trial.model.misfits
    before = tuple(old.as_sure_as(new) for old, new in zip(case.model.misfits, after, strict=True))
    if trial.candidate.slow:
        before, after = tuple(each.slow() for each in before), tuple(each.slow() for each in after)
    return max(explained_share(before, after, beside=trial.beside), trial.alone)


def _gained_again(case: Case, trial: Trial, held: Sequence[Features]) -> float | None:
    """Return what is gained on what no fit has seen, over the gain; None beyond the twin: only simulations can tell."""
    if trial.model.corrections or case.model.corrections:
        return None
    return (misfit_sum(misfits_of(case.model.rig, held)) - misfit_sum(misfits_of(trial.model.rig, held))) / trial.gain
