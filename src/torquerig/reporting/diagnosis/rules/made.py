"""A diagnosis by the first engine: its answer in words and its page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import Any

from torquerig.diagnosis.any_rig import diagnosed
from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.outcome import as_json
from torquerig.diagnosis.showing.effect_at_sensor import EffectAtSensor, effect_at_sensor
from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.answer_text import answer_lines
from torquerig.reporting.diagnosis.diagnosed import Diagnosed
from torquerig.reporting.diagnosis.page_answer import diagnosis_answer
from torquerig.reporting.diagnosis.rules.sentences import verdict_sentence
from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL, MOTION_RESIDUAL
from torquerig.scenario.model import Scenario

EffectOf = Callable[[], EffectAtSensor | None]


def diagnosed_by_rules(
    scenario: Scenario, recordings: Sequence[Recording], *, seed: int, progress: Callable[[str], None]
) -> Diagnosed:
    """Return the diagnosis by the first engine."""
    outcome = diagnosed(scenario, recordings, seed=seed, progress=progress)
    effect = cache(lambda: effect_at_sensor(outcome, nominal=scenario.rig, seed=seed))  # for answer and page
    data = outcome.as_json() if isinstance(outcome, MotionOutcome) else as_json(outcome.diagnosis)
    measure = MOTION_RESIDUAL if isinstance(outcome, MotionOutcome) else FEATURE_RESIDUAL
    sentence = verdict_sentence(outcome.diagnosis, outcome.left, measure=measure)
    return Diagnosed(
        data=data,
        completed=outcome.completed if outcome.completes else None,
        sentence=sentence,
        answer=lambda: diagnosis_answer(data, effect(), percent=measure.percent),
        lines=partial(_lines, sentence=sentence, remarks=outcome.diagnosis.remarks, effect=effect),
        page=partial(_page, outcome=outcome, title=scenario.title, seed=seed, effect=effect),
    )


def _lines(data: Mapping[str, Any], *, sentence: str, remarks: Sequence[str], effect: EffectOf) -> list[str]:
    """Return what is missing, how large, how sure, and what to do next."""
    change = effect()
    return answer_lines(data, verdict=sentence, effect="" if change is None else change.sentence, remarks=remarks)


def _page(
    _: Mapping[str, Any], *, outcome: Outcome | MotionOutcome, title: str, command: str, model: str | None, seed: int,
    effect: EffectOf,
) -> str:  # fmt: skip
    from torquerig.reporting.diagnosis.rules.motion_page import motion_page
    from torquerig.reporting.diagnosis.rules.page import diagnosis_page

    if isinstance(outcome, MotionOutcome):
        return motion_page(outcome, title=title, command=command, model=model, seed=seed, effect=effect())
    return diagnosis_page(outcome, title=title, command=command, model=model, seed=seed, effect=effect())
