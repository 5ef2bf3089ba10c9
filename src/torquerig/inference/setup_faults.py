"""Facts of the set-up that contradict the recordings: sense and scale of the sensor, counts, sample rate, set-points.

Each is an alternative reading of the same samples. The nominal rig is fitted to each reading, and the one that it
explains best is used. Readings are compared by the evidence per feature: they differ in the number of features.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import pi

import numpy as np

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, fitted
from torquerig.inference.likelihood import floor_density
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.rig.assembly import Rig

CLEARLY = 15.0  # [nats] by which another reading must explain the features better: 3e6 to 1
_SPEED_ERROR, _SLIP = 0.03, 0.15  # [1] of the set-point: more is no error of a drive, and none of an induction motor
_ALIKE = 0.02  # [1] within which the factors of all runs are one
SLIPS = tuple(sorted(one**sign for one in (2**0.5, 2.0, 4.0, 10.0, 100.0, 1000.0) for sign in (-1, 1)))
_NEAR_SLIP = 0.14  # of the logarithm: half the distance of the nearest two slips, 1.41 and 2, less a margin of 0.03
_FAR_SCALE = float(np.log(1.3))  # of the median size: nearer than this, numbers of the parts explain it
_WIDE = 1.4  # of the logarithm of the scale: a factor of 4
_MOVED = 2.0  # [standard deviations] a number that is off does not stay nearer to its stated value
_STRONG, _LARGE = 10.0, 0.2  # times the noise, and of the largest level: lines and levels that show a scale
_SIGN_MATTERS = 3  # levels at least, with a mean that exceeds their scatter

FitTo = Callable[[Sequence[MeasuredRun]], tuple[Data, Fit]]


@dataclass(frozen=True, kw_only=True)
class SetupFault:
    """A fact of the set-up as it is stated and as the recordings show it.

    Parameters
    ----------
    kind : str
        As the contract names it.
    of : str
        The sensor, the encoder or the recordings.
    stated, estimated : float
    unit : str
    equivalent_to : tuple of str
        Other kinds that explain the features as well.
    explanation : str
    """

    kind: str
    of: str
    stated: float
    estimated: float
    unit: str
    equivalent_to: tuple[str, ...]
    explanation: str


@dataclass(frozen=True)
class Reading:
    """The runs as they are read with a fact of the set-up corrected, the nominal fit to them, and the fault."""

    runs: tuple[MeasuredRun, ...]
    data: Data
    fit: Fit
    faults: tuple[SetupFault, ...] = ()


def best_reading(as_stated: Reading, rig: Rig, fit_to: FitTo) -> Reading:
    """Return the reading of the runs that the nominal rig explains best.

    ``fit_to`` returns features and the fit of the nominal rig for runs; ``as_stated`` is the reading without faults.
    """
    runs = as_stated.runs
    best = _corrected(as_stated, rig)
    factor = _speed_factor(runs, rig)
    if factor is None:
        return best
    others = [_corrected(Reading(made, *fit_to(made), (fault,)), rig) for made, fault in _rescaled(runs, factor)]
    stated = replace(best, faults=(*best.faults, _set_point(runs, factor)))
    ranked = sorted([stated, *others], key=lambda each: -per_feature(each.fit))
    first = ranked[0]
    near = [each.faults[-1].kind for each in ranked[1:] if not _clearly(first.fit, each.fit)]
    return replace(first, faults=(*first.faults[:-1], replace(first.faults[-1], equivalent_to=tuple(near))))


def per_feature(fit: Fit) -> float:
    """Return the log-evidence per feature [nats]."""
    return fit.log_evidence / max(fit.value.size, 1)


def _clearly(better: Fit, worse: Fit) -> bool:
    return min(better.value.size, worse.value.size) * (per_feature(better) - per_feature(worse)) > CLEARLY


def _corrected(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with sense and scale of the sensor corrected where they contradict the recordings."""
    return _other_scale(_other_sign(reading, rig), rig)


def _other_scale(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with another scale of the sensor where lines and levels all have it."""
    fit, ratio = reading.fit, _ratio_of_sizes(reading)
    columns = [at for at, knob in enumerate(fit.knobs) if (knob.part, knob.field) == (rig.measured, "scale")]
    if not columns or abs(np.log(ratio)) < _FAR_SCALE:
        return reading
    knobs, start = list(fit.knobs), np.zeros(len(fit.knobs))
    knobs[columns[0]] = replace(knobs[columns[0]], spread=_WIDE)
    start[columns[0]] = np.log(ratio) / _WIDE
    again = fitted(fit.rig, knobs, reading.data, start=start)
    stated = knobs[columns[0]].value(fit.rig)
    found = knobs[columns[0]].turned(stated, float(again.positions[columns[0]]))
    if slip(found / stated) != found / stated:  # then it is that slip, and known as well as the stated value was
        found = stated * slip(found / stated)
        sensor = replace(fit.rig.part(rig.measured), scale=found)  # type: ignore[call-arg]
        again = fitted(fit.rig.changed(sensor), fit.knobs, reading.data, nominal=fit.nominal)
    if not _clearly(again, fit) or again.log_evidence < _best_number(reading, columns[0]):
        return reading
    fault = SetupFault(
        kind="sensor_scale", of=rig.measured, stated=stated, estimated=found, unit="1",
        equivalent_to=(),
        explanation=f"The sensor {rig.measured} reads {found:.4g} times the torque that the scenario and the sidecars "
        "state.",
    )  # fmt: skip
    return Reading(reading.runs, reading.data, again, (fault, *reading.faults))


def _best_number(reading: Reading, scale: int) -> float:
    """Return the largest evidence [nats] with one number of the rig far from its stated value in place of the scale."""
    fit, best = reading.fit, -np.inf
    for at in np.flatnonzero(np.abs(fit.positions) > _MOVED).tolist():
        knob = fit.knobs[at]
        if at != scale and knob.factor and knob.spread < _WIDE:
            knobs, start = list(fit.knobs), np.zeros(len(fit.knobs))
            knobs[at], start[at] = replace(knob, spread=_WIDE), fit.positions[at] * knob.spread / _WIDE
            best = max(best, fitted(fit.rig, knobs, reading.data, start=start).log_evidence)
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


def _other_sign(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with the torque of the other sign where all mean torques have it."""
    measured = np.concatenate([seen.level for seen in reading.data.seen])
    expected = np.concatenate([each.level for each in reading.fit.expected])
    tells = measured.size >= _SIGN_MATTERS and abs(expected.mean()) > expected.std() / np.sqrt(expected.size)
    if not tells or float(measured @ expected) >= 0:
        return reading
    runs = tuple(replace(run, torque=-run.torque) for run in reading.runs)
    by_name = {run.name: run for run in runs}
    seen = tuple(_reversed(one, by_name[one.run.name]) for one in reading.data.seen)
    data, fit = replace(reading.data, seen=seen), reading.fit
    again = fitted(fit.rig, fit.knobs, data)
    if not _clearly(again, fit):
        return reading
    fault = SetupFault(
        kind="sensor_sign", of=rig.measured, stated=1.0, estimated=-1.0, unit="1", equivalent_to=(),
        explanation=f"The sensor {rig.measured} reads with the other sign than the scenario states: it is mounted the "
        "other way round, or its cable is.",
    )  # fmt: skip
    return Reading(runs, data, again, (fault, *reading.faults))


def _reversed(seen: RunFeatures, run: MeasuredRun) -> RunFeatures:
    return replace(seen, run=run, level=-seen.level)


def _speed_factor(runs: Sequence[MeasuredRun], rig: Rig) -> float | None:
    """Return the common factor of real speed and set-point where no drive is so far off; else None."""
    factors = np.array([run.speed_factor for run in runs])
    middle = float(np.median(factors))
    permitted = _SLIP if rig.of_kind("induction_drive") else _SPEED_ERROR
    one = bool(np.abs(factors / middle - 1).max() < _ALIKE) if middle else False
    if not one or middle <= 0 or abs(middle - 1) <= permitted:
        return None
    return slip(middle) if abs(np.log(slip(middle) / middle)) < permitted else middle


def _rescaled(runs: Sequence[MeasuredRun], factor: float) -> Iterator[tuple[tuple[MeasuredRun, ...], SetupFault]]:
    """Yield the runs with another sample rate and, where the angle was measured, with other counts per turn."""
    rate = runs[0].rate / factor
    yield (
        tuple(_at_rate(run, run.rate / factor) for run in runs),
        SetupFault(
            kind="sample_rate", of="recordings", stated=runs[0].rate, estimated=rate, unit="Hz", equivalent_to=(),
            explanation=f"The samples were taken at {rate:.5g} Hz where {runs[0].rate:.5g} Hz are stated: the speeds "
            "and the frequencies of the rig then agree with the scenario.",
        ),
    )  # fmt: skip
    counts = _counts(runs[0])
    if counts and all(run.has_encoder for run in runs):
        yield (
            tuple(_at_counts(run, factor) for run in runs),
            SetupFault(
                kind="counts_per_rev", of="encoder", stated=counts, estimated=counts * factor, unit="1/rev",
                equivalent_to=(),
                explanation=f"A turn of the encoder has {counts * factor:.5g} counts, not {counts:.5g}: the speeds and "
                "the orders of the lines then agree with the scenario.",
            ),
        )  # fmt: skip


def _counts(run: MeasuredRun) -> float | None:
    """Return the stated counts per turn of the encoder; None where no channel counts."""
    counted = (channel for channel in run.recording.channels.values() if channel.unit == "count")
    return next((2 * pi / abs(channel.si_per_unit) for channel in counted if channel.si_per_unit), None)


def _at_rate(run: MeasuredRun, rate: float) -> MeasuredRun:
    faster = rate / run.rate
    held = _with_speed(run, run.speed_factor * faster)
    return replace(held, recording=replace(held.recording, sample_rate=rate), speed=run.speed * faster)


def _at_counts(run: MeasuredRun, factor: float) -> MeasuredRun:
    held = _with_speed(run, run.speed_factor / factor)
    return replace(held, angle=run.angle / factor, speed=run.speed / factor)


def _with_speed(run: MeasuredRun, factor: float) -> MeasuredRun:
    """Return the run with another factor of real speed and set-point."""
    stated = run.run.speed
    conditions = replace(run.run, speed=None if stated is None else stated / run.speed_factor * factor)
    return replace(run, speed_factor=factor, recording=replace(run.recording, run=conditions))


def _set_point(runs: Sequence[MeasuredRun], factor: float) -> SetupFault:
    return SetupFault(
        kind="speed_scale", of="recordings", stated=1.0, estimated=factor, unit="1", equivalent_to=(),
        explanation=f"The motor turned {factor:.5g} times as fast as the sidecars state.",
    )  # fmt: skip
