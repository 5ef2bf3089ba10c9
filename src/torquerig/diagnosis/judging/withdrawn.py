"""Is what was found to be believed? Not where what no fit has seen is predicted no better with it, or a rest stays."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.judging.leftover import at_whole_order
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.diagnosis.outcome import HeldOut
from torquerig.inference.answer.mismatch import Mismatch

_WORSE = 1.01  # of the held-out misfit before: nothing is named with which it grows
_NO_BETTER = 0.98  # of it: less than so much of a fall is none, for what is there foretells at least twice as much
_CLEAR, _NEARLY_ALL = 0.3, 0.8  # of that misfit beyond chance: clearly there, and hardly less with what was found
_ITS_PLACES = 0.9  # of what is missed where it acts: what else the rig lacks is not its to explain
_LARGE_REST = 1 / 3  # of all that was missing: what takes away more is there, whatever stays beside it
_QUARTER = 0.25  # of it, where the model misses far more than chance all over
_FAR_OFF = 5.0  # beyond chance, per feature: where so much stays, no place stands out only as each is forgiven much
_BEYOND_ALL = 100.0  # beyond chance, per feature: a model so wrong says nothing of what it explains but half
_MOST_OF_IT = 2 / 3  # of all that was missing: a line that takes less, of several that stay, may be one of theirs
_PREDICTS_WORSE = "fitted, then rejected: it predicts the held-out data worse"
_PREDICTS_NO_BETTER = "fitted, then rejected: it hardly improves the prediction of the held-out data"
LEAVES_A_REST = (
    f"fitted, then rejected: it explains less than {LEAST_SHARE:.0%} of the held-out residual where it acts, "
    "and a residual remains"
)
COMES_AND_GOES = (
    "fitted, then rejected: several recordings contain intermittent noise, whose mean spectrum resembles this mechanism"
)
TOO_MANY = (
    "fitted, then rejected: with all findings a residual remains, and each of them may be part of one unknown effect"
)
_SLIPS = (
    "fitted, then rejected: the spectrum of a recording changes at times, and stick-slip reduces the torque as contact "
    "loss does"
)
_NO_ZERO = (
    "fitted, then rejected: the spectrum also changes along the steady recordings, which a zero drift does not cause"
)
STILL_WRONG = (
    "fitted, then rejected: the held-out residual is that of a true model without it, and significant differences "
    "remain with it"
)
ONE_OF_MANY = (
    "fitted, then rejected: other lines at whole shaft orders keep most of the residual, and this line may belong to "
    "them"
)
_ITS_OWN_LINE = "fitted, then rejected: the line that it causes keeps a significant residual in a recording"
_COMBINED = (
    "fitted, then rejected: its order is the sum or difference of two larger orders of the rig (nonlinearity), and "
    "residuals remain elsewhere"
)
_COMBINED_AT_MOST = (
    "fitted, then rejected: its order is the sum or difference of two larger orders of the rig, and it may not "
    "improve the prediction"
)
_ITS_OWN_BAND = (
    "fitted, then rejected: its resonance band is too strong in one recording and too weak in another, as with noise "
    "from outside the rig"
)
_SEVERAL = 2  # runs, or lines
_MANY = 3  # effects at once: few rigs have two, and one that nothing explains falls to pieces that look like some


def why_withdrawn(
    fit: HeldOut, left: Sequence[Mismatch], *, effects: int = 1, resembled: bool = False,
    passing: Sequence[Mismatch] = (), drifts_in_all: bool = False, samples_too: bool = False, again: bool = False,
    flights_told: bool = False, turning_lines: bool = False, own_line: bool = False, combined: bool = False,
    everywhere: bool = False, gap: bool = False, both_ways: bool = False,
) -> str:  # fmt: skip
    """Return why what was found is not to be believed; nothing where it is.

    Parameters
    ----------
    fit : HeldOut
        Before and with it.
    left : sequence of Mismatch
        Where the completed model is still significantly wrong.
    effects : int
        How many were found.
    resembled : bool
        Whether something was found that noise resembles.
    passing : sequence of Mismatch
        Times at which the spectrum of a steady run stands elsewhere.
    drifts_in_all : bool
        Whether a zero that drifts was found, and the spectrum changes along the steady runs as well.
    samples_too : bool
        Whether samples were found untrue, of which a rest may stay, at a line too: where the time base jumps, its
        phase does. Where moments alone are left, none of it is that of a gap that tells the flights.
    again : bool
        Whether it left a rest before, beside numbers that moved.
    flights_told : bool
        Whether flanks flew in several runs that no longer do beside it: a few moments, which weigh little among all
        that is foretold.
    turning_lines : bool
        Whether all that was found makes lines at orders, and nothing else.
    own_line : bool
        Whether all that was found makes lines whose size its cause tells, and one of them is among what is left: it
        goes with something that its cause knows nothing of.
    combined : bool
        Whether all that was found makes lines that may be made of two of the rig's own.
    everywhere : bool
        Whether the completed model misses far more than chance, though no place of it stands out.
    gap : bool
        Whether a gap was found: not all that ends in blows is one, and most of what slips stays beside it, or comes
        at times.
    both_ways : bool
        Whether a mode was found that leaves its own band too loud in one run and too quiet in another.
    """
    missing, rest = fit.before - 1, fit.after - 1
    told_apart = flights_told and samples_too and all(each.domain == "time" for each in left)
    elsewhere = bool(left) and (told_apart or (not (resembled or gap) and _clearly_there(fit)))
    unexplained = fit.explained < LEAST_SHARE and not elsewhere
    against = (
        (drifts_in_all, _NO_ZERO),
        (resembled and len(passing) >= _SEVERAL, COMES_AND_GOES),
        (gap and passing and not samples_too, _SLIPS),
        (fit.after > _WORSE * fit.before, _PREDICTS_WORSE),
        (fit.after > (1.0 if flights_told else _NO_BETTER) * fit.before, _PREDICTS_NO_BETTER),
        (own_line and not samples_too, _ITS_OWN_LINE),
        (both_ways, _ITS_OWN_BAND),
        (left and combined, _COMBINED),
        (combined and fit.improvement[1] < 0, _COMBINED_AT_MOST),
        (left and effects >= _MANY, TOO_MANY),
        (left and missing < 0 and not samples_too, STILL_WRONG),
        (turning_lines and rest > _MOST_OF_IT * missing and sum(map(at_whole_order, left)) >= _SEVERAL, ONE_OF_MANY),
        (missing > _CLEAR and rest > _NEARLY_ALL * missing and not elsewhere, _PREDICTS_NO_BETTER),
        (
            left and rest > min(_LARGE_REST * missing, _BEYOND_ALL) and (again or unexplained),
            LEAVES_A_REST,
        ),
        (everywhere and not (left or samples_too) and rest > _QUARTER * missing, LEAVES_A_REST),
        (not (left or samples_too) and rest > max(_LARGE_REST * missing, _FAR_OFF), LEAVES_A_REST),
    )
    return next((reason for speaks, reason in against if speaks), "")


def _clearly_there(fit: HeldOut) -> bool:
    """Whether its places are explained where no fit has seen them, by more than chance, though they are but few."""
    _, least, _ = fit.improvement
    return fit.explained > _ITS_PLACES and least > 0
