"""What is asked of a model that fits and lacks nothing: kinds of misfit to which each single place is blind."""

from __future__ import annotations

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.load_over_time import load_over_time
from torquerig.diagnosis.judging.numbers_far_off import number_far_off
from torquerig.diagnosis.judging.one_gain import one_gain
from torquerig.diagnosis.judging.slow_rhythm import slow_rhythm
from torquerig.diagnosis.judging.spread_lines import spread_line
from torquerig.inference.answer.mismatch import Mismatch


def last_question(case: Case) -> tuple[str, Mismatch] | None:
    """Return what the first of them finds, with a sentence where the place alone does not say it; None if nothing."""
    told = spread_line(case) or slow_rhythm(case)
    if told is not None:
        return "", told
    return one_gain(case) or load_over_time(case) or number_far_off(case)
