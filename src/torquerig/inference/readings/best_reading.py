"""The reading of the samples that the nominal rig explains best.

Each fact of the set-up that contradicts the recordings gives another reading of the same samples. The nominal rig is
fitted to each. Readings are compared by the evidence per feature: they differ in the number of features.
"""

from __future__ import annotations

from dataclasses import replace

from torquerig.inference.fit import sketch_error
from torquerig.inference.readings.clock import rescaled, set_point, speed_factor
from torquerig.inference.readings.other_teeth import other_teeth
from torquerig.inference.readings.reading import CLEARLY, Read, Reading, gain_of, per_feature
from torquerig.inference.readings.sensor_scale import other_scale
from torquerig.inference.readings.sensor_sign import other_sign
from torquerig.rig.assembly import Rig


def best_reading(as_stated: Reading, rig: Rig, read: Read, *, set_point_error: float) -> Reading:
    """Return the reading of the runs that the nominal rig explains best.

    ``as_stated`` is the one without faults; ``set_point_error`` the largest error of a set-point of the speed [1].
    """
    factor = speed_factor(as_stated, rig, set_point_error=set_point_error)
    if factor is None:
        return _corrected(other_teeth(as_stated, rig, read), rig)
    best = _corrected(as_stated, rig)
    made = rescaled(as_stated.runs, factor)
    others = [_corrected(replace(read(rig, runs), faults=(fault,)), rig) for runs, fault in made]
    stated = replace(best, faults=(*best.faults, set_point(factor)))
    sketch = max([stated, *others], key=lambda each: per_feature(each.fit))
    behind = [gain_of(sketch.fit, each.fit) for each in (stated, *others)]
    reach = CLEARLY + sketch_error(max(behind))
    within = [each for each, gain in zip((stated, *others), behind, strict=True) if gain <= reach]
    ranked = sorted((each.finished() for each in within), key=lambda each: -per_feature(each.fit))
    first = ranked[0]
    near = [each.faults[-1].kind for each in ranked[1:] if gain_of(first.fit, each.fit) <= CLEARLY]
    return replace(first, faults=(*first.faults[:-1], replace(first.faults[-1], equivalent_to=tuple(near))))


def _corrected(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with sense and scale of the sensor corrected where they contradict the recordings."""
    return other_scale(other_sign(reading, rig), rig)
