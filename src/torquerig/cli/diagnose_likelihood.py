"""``torquerig diagnose --engine likelihood``: what it refuses, and its answer in words."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from torquerig.diagnosis.motion.moved import under_measured_motion
from torquerig.errors import InputError
from torquerig.inference.engine import Outcome, diagnose
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured

_VERDICTS = {
    "adequate": "The model explains the recordings; nothing is missing that they can show.",
    "missing_physics": "The model lacks physics; with the findings below it explains the recordings.",
    "setup_error": "The model explains the recordings once the numbers below are corrected.",
    "unexplained": "Something remains that no mechanism explains.",
}


def diagnosed_by_likelihood(
    scenario: Scenario, recordings: Sequence[Recording], *, progress: Callable[[str], None]
) -> Outcome:
    """Return the outcome; InputError for a rig whose motion was measured, which this engine does not compare yet."""
    if under_measured_motion(scenario.rig):
        raise InputError("--engine likelihood does not compare rigs whose motion was measured yet; leave --engine out")
    return diagnose(scenario, as_measured(recordings, scenario.rig), progress=progress)


def answer_lines_of(data: Mapping[str, Any]) -> Iterator[str]:
    """Yield the answer: the verdict, what was found with its size and confidence, and how the residual fell."""
    yield _VERDICTS[data["verdict"]]
    for each in (*data["findings"], *data["unnamed"]):
        size = each["size"]
        yield f"{each['explanation']} {size['value']:.3g} {size['unit']}, confidence {each['confidence']:.2f}."
    for each in data["setup"]:
        yield f"{each['explanation']} Confidence {each['confidence']:.2f}."
    fit = data["fit"]
    before, after = fit["before"]["heldout_misfit"], fit["after"]["heldout_misfit"]
    yield f"Mean squared standardised residual of held-out data: {before:.3g} before, {after:.3g} after."
