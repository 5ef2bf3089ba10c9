"""Runs of which nothing but the distribution of values tells how good a model is."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from torquerig.diagnosis.expecting.simulated import limit_of, simulated_runs
from torquerig.diagnosis.looking.features import Features
from torquerig.errors import SimulationError
from torquerig.recordings.repair.samples_at_limit import at_limit, too_long
from torquerig.rig.assembly import Rig

_SEED = 101


def of_untold_loads(held: Sequence[Features], *, fitted: Collection[str]) -> frozenset[str]:
    """Return the loaded runs that no fit has seen, and whose load nothing tells but its prior.

    All where the runs that fits have seen ran without load; else those that stand at a limit too long to be rebuilt:
    how much of a load it takes away grows steeply with the load, and their spectrum is that of flat tops.
    """
    loaded = {each.observed.name for each in held if each.observed.run.occupancy_percent}
    unseen = loaded.difference(fitted)
    if unseen == loaded:
        return frozenset(loaded)
    flat = {each.observed.name for each in held if not each.observed.rebuilt}
    return frozenset(unseen & flat)


def flat_in_the_model_alone(before: Rig, after: Rig, held: Sequence[Features]) -> frozenset[str]:
    """Return the runs in which ``after`` stands at a limit of its own for long, and the recording never does.

    The torque is wrong there, by as much before as after; with a limit, lines of flat tops come to it that neither
    the recording nor a better torque would have. The distribution of values tells that it reaches the limit.

    Parameters
    ----------
    before, after : Rig
        Where ``after`` has no limit below that of ``before``, there are none.
    held : sequence of Features
    """
    limit = limit_of(after)
    if limit >= limit_of(before):
        return frozenset()
    free = [each for each in held if not at_limit(each.observed.recording, limit=limit).any()]
    try:
        copies = simulated_runs(after, free, seeds=[_SEED])
    except SimulationError:  # judged by linear twins, which have no limit
        return frozenset()
    stand = [too_long(at_limit(each.recording, limit=limit)) for (each,) in copies]
    return frozenset(each.observed.name for each, stands in zip(free, stand, strict=True) if stands)
