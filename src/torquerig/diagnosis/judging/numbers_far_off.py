"""Whether a number of the finished model stands further off than wrong numbers do: it stands in for something.

A wrong number is no missing physics, and the fits allow each to be wrong by seven of its stated spreads. Where one is
driven there, or one of the load beyond six, and nothing that was tried explains why, the model fits by a number that
nobody would believe: a level that a bent characteristic makes, hits that are pulses of another kind. Of 156 rigs with
nothing hidden, some of them with numbers wrong by twice their stated spreads, none had one beyond 5.2; of 90 more one
had (119-039, whose numbers are far off), of 43 more one had a line at 5.8 and none a number of the load beyond 4: what
stands there is to be looked at, and nothing is named. Two clean rigs of 180 had one at the lower limit, a line and a
drag stated to a quarter or worse: such numbers may be as small as they like.
"""

from __future__ import annotations

from math import log10, pi

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import LIMIT
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.knobs import HARDLY_ANY, Knob
from torquerig.mechanisms import ParticleLoad

_AT_LIMIT, _OF_LOAD = 0.97 * LIMIT, 6.0  # spreads
_NOTHING_WITHIN = 1 / 4  # [1] of such a relative spread nothing is four


def number_far_off(case: Case) -> tuple[str, Mismatch] | None:
    """Return a sentence and a mismatch for the number that stands furthest off; None where none stands in for more."""
    positions = zip(case.model.knobs, case.model.positions.tolist(), strict=True)
    asked = (pair for pair in positions if not _may_be_anything(case, *pair))
    off = [(knob, at) for knob, at in asked if abs(at) >= (_OF_LOAD if _of_load(case, knob) else _AT_LIMIT)]
    if not off:
        return None
    knob, position = max(off, key=lambda pair: abs(pair[1]))
    stated, needed = knob.value(case.nominal_with_accepted()), knob.value(case.model.rig)
    level = _of_load(case, knob) and knob.key is not None
    further = " or beyond" if abs(position) > _AT_LIMIT else ""
    runs = [run for run in case.runs if not level or run.run.occupancy_percent == knob.key] or list(case.runs)
    sentence = (
        f"{knob.name}: the fit requires {needed:.3g}{further}; the scenario states {stated:.3g}. The deviation is "
        f"{abs(position):.1f} stated standard deviations. Correct the stated value if it is wrong. Otherwise, an "
        "unknown effect acts like this deviation."
    )
    mismatch = Mismatch(
        domain="level", axis="rpm", at=abs(runs[0].mean_speed) * 30 / pi, width=0.0,
        recordings=tuple(run.name for run in runs), excess_dB=20 * log10(abs(position)), share_of_misfit=0.0,
        p_value=by_chance(abs(position), len(case.model.knobs)),
    )  # fmt: skip
    return sentence, mismatch


def _of_load(case: Case, knob: Knob) -> bool:
    return isinstance(case.nominal.part(knob.part), ParticleLoad)


def _may_be_anything(case: Case, knob: Knob, position: float) -> bool:
    """Whether it is how slowly a load varies whose hits nobody knows: these may take the place of all else.

    Or a number of the rig so uncertain that nothing at all lies within four of its spreads, and that is smaller than
    stated: a factor's logarithm has no end there, and what is not there stands in for nothing.
    """
    load = case.nominal.part(knob.part)
    if not isinstance(load, ParticleLoad):
        return knob.factor and position < 0 and knob.spread >= _NOTHING_WITHIN
    return load.hit_rms <= HARDLY_ANY and knob.field.startswith("slow")
