"""A line that no mechanism explains, modelled without a name: periodic in the place, or fixed in frequency."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.lines import Line, even, phase_of, turn_of, waves
from torquerig.diagnosis.motion.moved import Moved
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import ImposedMotion

Floats = NDArray[np.float64]

_HALVES = 2  # of a run: the first is fitted, the second predicted


@dataclass(frozen=True, kw_only=True)
class Neutral:
    """What a nameless term does: rms residual at even speed of the second halves, without it and fitted to the first.

    Phase and size are those of each run and direction: where the place is counted from may differ from run to run.
    """

    line: Line
    before: float
    after: float


def neutral(line: Line, residuals: Sequence[Floats], runs: Sequence[Moved]) -> Neutral:
    """Return how far a nameless line, fitted to the first half of each run, lowers what is left of the second."""
    before, after = [], []
    for residual, run in zip(residuals, runs, strict=True):
        if not run.seen.any():
            continue
        turn = np.arange(residual.size) * _HALVES // residual.size == 0
        going = even(run) & (run.seen | run.held)
        check = going & ~turn
        before.append(residual[check])
        after.append((residual - waves(run, line, residual, going & turn))[check])
    return Neutral(line=line, before=root_mean_square(before), after=root_mean_square(after))


def neutral_part(line: Line, residual: Floats, run: Moved, rig: Rig, *, number: int) -> TorqueRipple | None:
    """Return the part by which a scenario states its ``number``-th line over the place, as in one run.

    None for a frequency.
    """
    if line.domain != "order":
        return None
    mask, phase = run.seen & even(run), phase_of(run, line)
    basis = np.column_stack([np.cos(phase), np.sin(phase), np.ones(phase.size)])
    held = np.linalg.lstsq(basis[mask], residual[mask], rcond=None)[0]
    size, order = -complex(held[0], -held[1]), line.at * turn_of([run])
    return TorqueRipple(
        name=f"unexplained_line_{number}", at=cast("ImposedMotion", imposed_part(rig)).at, group="mechanical",
        amplitudes={order: abs(size)}, phases={order: float(np.angle(size))},
    )  # fmt: skip
