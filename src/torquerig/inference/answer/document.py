"""All keys of the answer, in the form of the contract with the additions for nameless effects and set-up."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from torquerig.inference.answer.confidence import far_numbers, named, nameless
from torquerig.inference.answer.effects import finding, finding_of_number, unnamed
from torquerig.inference.answer.held_out_figures import fit_figures
from torquerig.inference.answer.isolated import next_experiment, next_experiment_for_nameless, upper_limits
from torquerig.inference.answer.located import differences, fault_place, remaining
from torquerig.inference.answer.numbers import digits
from torquerig.inference.answer.owned import owned
from torquerig.inference.answer.rms import rms_errors
from torquerig.inference.answer.setup_facts import fault_answer, number_answer
from torquerig.inference.answer.tried import rejected
from torquerig.inference.answer.verdict import verdict
from torquerig.inference.engine import Outcome
from torquerig.inference.measured_run import MeasuredRun

SCHEMA = "torquerig.diagnosis/1"


def as_json(outcome: Outcome) -> dict[str, Any]:
    """Return the answer in the contract's form."""
    far = [(each, owned(outcome, each)) for each in far_numbers(outcome)]
    numbers = (number_answer(outcome, each) for each, owner in far if owner is None)
    faults = (fault_answer(each, outcome.model.fit) for each in outcome.setup)
    word = verdict(outcome)
    return {
        "schema": SCHEMA,
        "verdict": word,
        "mismatch": [*map(fault_place, outcome.untrue), *differences(outcome), *remaining(outcome)],
        "findings": [
            *(finding(outcome, each, next_experiment=next_experiment(outcome, each)) for each in named(outcome)),
            *(finding_of_number(outcome, each, owner) for each, owner in far if owner is not None),
        ],
        "setup": [*faults, *numbers],
        "unnamed": [unnamed(outcome, each) for each in nameless(outcome)],
        "fit": fit_figures(outcome),
        "rms": rms_errors(outcome),
        "upper_limits": upper_limits(outcome) if word == "adequate" else [],
        "set_aside": rejected(outcome),
        "next_experiment": next_experiment_for_nameless(outcome),
        "remarks": [*outcome.remarks],
        "model": None,
        "recordings": [
            {"file": run.name, "speed_rpm": digits(float(np.mean(run.speed)) * 30 / pi), "used_for": _use(run)}
            for run in outcome.runs
        ],
    }


def _use(run: MeasuredRun) -> str:
    held = {block.held_out for block in run.blocks}
    if not held:
        return "none"
    return "split" if len(held) > 1 else "held_out" if held == {True} else "fit"
