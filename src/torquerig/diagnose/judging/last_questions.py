"""What is asked of a model that fits and lacks nothing: kinds of misfit to which each single place is blind."""

from __future__ import annotations

from torquerig.diagnose.case import Case
from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.judging.load_over_time import load_over_time
from torquerig.diagnose.judging.numbers_far_off import number_far_off
from torquerig.diagnose.judging.one_gain import one_gain
from torquerig.diagnose.judging.slow_rhythm import slow_rhythm
from torquerig.diagnose.judging.spread_lines import spread_line


def last_question(case: Case) -> tuple[str, Mismatch] | None:
    """Return what the first of them finds, with a sentence where the place alone does not say it; None if nothing."""
    told = spread_line(case) or slow_rhythm(case)
    if told is not None:
        return "", told
    return one_gain(case) or load_over_time(case) or number_far_off(case)
