"""Test whether a gap is visible in a recording: constant contact makes the recordings equal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from proof.rig_program.effects.backlash import Backlash
from proof.rig_program.effects.effect import Effect
from proof.rig_program.laws import Laws
from proof.rig_program.plan import Run
from proof.rig_program.recording import record
from proof.rig_program.true_rig import TrueRig


def gap_shows(
    plan: Sequence[Run], rig: TrueRig, laws: Laws, *, effects: Sequence[Effect], seed: tuple[int, ...]
) -> bool:
    """Return whether some run's torque differs from the same run's without the gap by more than the sensor noise (rms).

    True where there is no gap: how large other effects must be to be just visible is drawn from closed forms
    (``effects.visible``), which a contact has not.
    """
    closed = tuple(replace(effect, gap=0.0) if isinstance(effect, Backlash) else effect for effect in effects)
    if closed == tuple(effects):
        return True
    return any(
        _apart(run, rig, laws, effects=(tuple(effects), closed), seed=[*seed, i]) > rig["noise"]
        for i, run in enumerate(plan, start=1)
    )


def _apart(
    run: Run, rig: TrueRig, laws: Laws, *, effects: tuple[tuple[Effect, ...], tuple[Effect, ...]], seed: list[int]
) -> float:
    with_gap, without = (record(run, rig, laws, effects=each, seed=seed).torque for each in effects)
    size = min(with_gap.size, without.size)  # an effect on the file may have dropped samples
    return float(np.sqrt(np.nanmean((with_gap[:size] - without[:size]) ** 2)))
