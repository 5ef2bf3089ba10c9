"""Whether dry friction is lost because its shaft turns slower than the smoothing of the sign of its speed."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig.simulation import kernel
from torquerig.simulation.arrays import Floats
from torquerig.simulation.measured_places import TURNING, words
from torquerig.simulation.ready import Ready
from torquerig.simulation.step_choice import turns_of_nodes
from torquerig.simulation.term_kinds import KINDS

ACTS = 0.5  # [1] share of its work below which the stated friction is mostly lost


def friction_lost(run: Ready, kept: Floats) -> Iterator[str]:
    """Yield one sentence for each dry friction that does less than half the work of a constant torque.

    The torque is ``Tc tanh(w / smoothing)``, so that the share is ``sum |w tanh(w / smoothing)| / sum |w|``; w is the
    leader's recorded speed through the gears, twist left out. Rest has no work and does not count.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
    """
    lowered, leader = run.lowered, run.lowered.node(run.lowered.leader())
    rows = [row for row, one in enumerate(run.outputs) if one.kind == kernel.SPEED and one.row == leader]
    if not rows:
        return
    turns, speed = turns_of_nodes(lowered, leader), kept[rows[0]]
    for kind in KINDS:
        if kind.field != "frictions":
            continue
        for each in kind.reversals(lowered.rows_of[kind.field], getattr(run.terms, kind.field)):
            sliding = (turns[each.on] - turns[each.against]) * speed
            fastest = float(np.abs(sliding).max(initial=0.0))
            if not fastest > 0:
                continue
            acting = float(np.sum(sliding * np.tanh(sliding * each.inverse_smoothing)) / np.sum(np.abs(sliding)))
            if acting < ACTS:
                names = words(run.rig, lowered.nodes[each.on])
                effort, rate = ("N*m", "rad/s") if names is TURNING else ("N", "m/s")
                yield (
                    f"{each.what} does {100 * acting:.2g} % of the work of its {each.torque:.3g} {effort}: the speed "
                    f"is at most {fastest:.2g} {rate}, and its sign is smoothed over "
                    f"{1 / each.inverse_smoothing:.2g} {rate}; write a smaller smoothing"
                )
