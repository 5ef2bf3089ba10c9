"""Whether a run's motor stays at its torque limit, or stalls."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig.simulation import kernel
from torquerig.simulation.arrays import Floats
from torquerig.simulation.ready import Ready

AT_LIMIT = 0.99  # [1] of the limit: the current lag approaches it from below
MUCH = 0.05  # [1] share of a recording at the limit that is said; a start or a reversal takes less
STANDS = 0.05  # [1] of the set-point below which a motor at its limit has stalled


def limits_reached(run: Ready, kept: Floats) -> Iterator[str]:
    """Yield one sentence for a motor that stalls, or stays at its torque limit for much of the recording.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
    """
    rows = [row for row, one in enumerate(run.outputs) if one.kind == kernel.DRIVE_TORQUE and one.truth]
    if not rows or not run.lowered.drive_terms[0].holds_speed:
        return
    drive, span = run.lowered.drive_terms[0], run.span
    limited = np.abs(kept[rows[0]]) >= AT_LIMIT * drive.torque_limit
    share = float(limited.mean())
    if share < MUCH:
        return
    here = run.lowered.node(drive.on)
    speeds = [row for row, one in enumerate(run.outputs) if one.kind == kernel.SPEED and one.row == here]
    wanted = run.terms.drives.reference[0, span.settling : span.settling + span.samples]
    stalled = limited & (np.abs(kept[speeds[0]]) < STANDS * np.abs(wanted)) if speeds else limited[:0]
    at = f"{drive.torque_limit:.4g} N*m, the torque limit of {drive.name!r}'s motor"
    if stalled.any() and stalled.mean() >= MUCH:
        yield (
            f"the motor stalls: for {100 * float(stalled.mean()):.2g} % of the recording it stands at {at}; lower load "
            "or friction, or take a stronger motor or a higher ratio"
        )
    else:
        yield (
            f"the motor is at {at}, for {100 * share:.2g} % of the recording, and its speed is not controlled there; "
            "lower the load, the acceleration or the gains of the speed loop, or take a stronger motor"
        )
