"""``torquerig diagnose`` by the first engine: its answer in words and its page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import Any

from torquerig.cli.diagnose_parts.diagnosed import Diagnosed
from torquerig.diagnosis.any_rig import diagnosed
from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.outcome import as_json
from torquerig.diagnosis.showing.effect_at_sensor import EffectAtSensor, effect_at_sensor
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

EffectOf = Callable[[], EffectAtSensor | None]


def diagnosed_by_rules(
    scenario: Scenario, recordings: Sequence[Recording], *, seed: int, progress: Callable[[str], None]
) -> Diagnosed:
    """Return the diagnosis by the first engine."""
    outcome = diagnosed(scenario, recordings, seed=seed, progress=progress)
    effect = cache(lambda: effect_at_sensor(outcome, nominal=scenario.rig, seed=seed))  # for answer and page
    return Diagnosed(
        data=outcome.as_json() if isinstance(outcome, MotionOutcome) else as_json(outcome.diagnosis),
        completed=outcome.completed if outcome.completes else None,
        lines=partial(_lines, outcome=outcome, effect=effect),
        page=partial(_page, outcome=outcome, title=scenario.title, seed=seed, effect=effect),
    )


def _lines(data: Mapping[str, Any], *, outcome: Outcome | MotionOutcome, effect: EffectOf) -> list[str]:
    """Return what is missing, how large, how sure, and what to do next."""
    from torquerig.reporting.diagnosis.answer_text import answer_lines
    from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL, MOTION_RESIDUAL, verdict_sentence

    measure = MOTION_RESIDUAL if isinstance(outcome, MotionOutcome) else FEATURE_RESIDUAL
    sentence = verdict_sentence(outcome.diagnosis, outcome.left, measure=measure)
    change = effect()
    shown = "" if change is None else change.sentence
    return answer_lines(data, verdict=sentence, effect=shown, remarks=outcome.diagnosis.remarks)


def _page(
    _: Mapping[str, Any], *, outcome: Outcome | MotionOutcome, title: str, command: str, model: str | None, seed: int,
    effect: EffectOf,
) -> str:  # fmt: skip
    from torquerig.reporting.diagnosis.motion_page import motion_page
    from torquerig.reporting.diagnosis.page import diagnosis_page

    if isinstance(outcome, MotionOutcome):
        return motion_page(outcome, title=title, command=command, model=model, seed=seed, effect=effect())
    return diagnosis_page(outcome, title=title, command=command, model=model, seed=seed, effect=effect())
