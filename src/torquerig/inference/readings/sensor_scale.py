"""Another scale of the sensor: where lines and mean torques all have another size."""

from __future__ import annotations

from dataclasses import replace
from math import log

import numpy as np

from torquerig.inference.fit import Fit, finished, sketch_error
from torquerig.inference.likelihood import floor_density
from torquerig.inference.one_number import without_priors
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.readings.reading import CLEARLY, Reading, SetupFault, gain_of, sketched_like
from torquerig.rig.assembly import Rig

SLIPS = tuple(sorted(one**sign for one in (2**0.5, 2.0, 4.0, 10.0, 100.0, 1000.0) for sign in (-1, 1)))
_NEAR_SLIP = 0.14  # of the logarithm: half the distance of the nearest two slips, 1.41 and 2, less a margin of 0.03
_FAR_SCALE = float(np.log(1.3))  # of the median size: nearer than this, numbers of the parts explain it
_WIDE = 1.4  # of the logarithm of the scale: a factor of 4
_MOVED = 2.0  # [standard deviations] a number that is off would not be nearer to its stated value without its prior
_OF_RANGE = 0.5  # of the largest mean torque: standard deviation of a zero that nobody set
_NUMBERS = 3  # that are fitted in place of the scale
_MOST = 3.0  # [standard deviations] of the wide prior: a fit begins no farther off
_ALIKE = log(20.0)  # [nats] numbers less far behind are not excluded
_STRONG, _LARGE = 10.0, 0.2  # times the noise, and of the largest level: lines and levels that show a scale


def other_scale(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with another scale of the sensor where lines and levels all have it."""
    fit, ratio = reading.fit, _ratio_of_sizes(reading)
    columns = [at for at, knob in enumerate(fit.knobs) if (knob.part, knob.field) == (rig.measured, "scale")]
    if not columns or abs(np.log(ratio)) < _FAR_SCALE:
        return reading
    wide = replace(fit.knobs[columns[0]], spread=_WIDE)
    again = sketched_like(fit, reading.data, knob=(columns[0], wide, float(np.log(ratio)) / _WIDE))
    stated = wide.value(fit.rig)
    found = wide.turned(stated, float(again.positions[columns[0]]))
    if slip(found / stated) != found / stated:  # then it is that slip, and known as well as the stated value was
        found = stated * slip(found / stated)
        sensor = replace(fit.rig.part(rig.measured), scale=found)  # type: ignore[call-arg]
        again = sketched_like(fit, reading.data, rig=fit.rig.changed(sensor))
    if gain_of(again, fit) <= CLEARLY:
        return reading
    again = finished(again, reading.data)
    ahead = again.log_evidence - _best_number(reading, columns[0], again)
    if ahead < 0:
        return reading
    fault = SetupFault(
        kind="sensor_scale", of=rig.measured, stated=stated, estimated=found, unit="1",
        equivalent_to=("parameter",) if ahead < _ALIKE else (),
        explanation=f"The sensor {rig.measured} reads {found:.4g} times the torque that the scenario and the sidecars "
        "state.",
    )  # fmt: skip
    return Reading(reading.runs, reading.data, again, (fault, *reading.faults))


def _best_number(reading: Reading, scale: int, again: Fit) -> float:
    """Return the largest evidence [nats] with one number of the rig far from its stated value in place of the scale.

    Those are fitted that would gain most without their prior, whether or not the fit has moved them; a fit is finished
    where it may come near that of another scale, ``again``.
    """
    fit, best = reading.fit, -np.inf
    least = again.log_evidence - _ALIKE - sketch_error(again.log_evidence - fit.log_evidence)
    free, gains = without_priors(fit)
    largest = max(float(np.abs(seen.level).max(initial=0.0)) for seen in reading.data.seen)
    wide = [_WIDE if knob.factor else _OF_RANGE * largest for knob in fit.knobs]
    far = [at for at, knob in enumerate(fit.knobs)
           if at != scale and knob.spread < wide[at] and abs(free[at]) > _MOVED]  # fmt: skip
    for at in sorted(far, key=lambda one: -gains[one])[:_NUMBERS]:
        start = float(np.clip(free[at] * fit.knobs[at].spread / wide[at], -_MOST, _MOST))
        knob = at, replace(fit.knobs[at], spread=wide[at]), start
        one = sketched_like(fit, reading.data, knob=knob)
        one = one if one.log_evidence < least else finished(one, reading.data)
        best = max(best, one.log_evidence)
    return best


def slip(ratio: float) -> float:
    """Return the common slip of unit, range or count that a ratio is near to, else the ratio itself."""
    near = min(SLIPS, key=lambda one: abs(np.log(ratio / one)))
    return near if abs(np.log(ratio / near)) < _NEAR_SLIP else ratio


def _ratio_of_sizes(reading: Reading) -> float:
    """Return the median ratio of measured and stated sizes, over all strong lines and all levels."""
    logs = list[float]()
    for seen in reading.data.seen:
        stated = expected_run(reading.fit.nominal, seen)
        noise = seen.lines.noise_bandwidth * floor_density(seen, stated)
        strong = (seen.lines.count > 0) & (seen.lines.power > _STRONG * noise) & (stated.line_power > 0)
        logs += (0.5 * np.log((seen.lines.power - noise)[strong] / stated.line_power[strong])).tolist()
        large = np.abs(stated.level) > _LARGE * np.abs(stated.level).max(initial=0.0)
        logs += np.log(np.maximum(np.abs(seen.level[large]), 1e-12) / np.abs(stated.level[large])).tolist()
    return float(np.exp(np.median(logs))) if logs else 1.0
