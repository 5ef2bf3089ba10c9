"""Nameless lines: a torque that is periodic in the angle or place, or in time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import log, pi

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.motion.fitted_model import Fit, effort_scale
from torquerig.inference.motion.hypotheses.shown import in_a_line, weighted_signals
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.inference.motion.imposed_run import BAND, ImposedRun
from torquerig.rig.assembly import Part
from torquerig.rig.imposed_part import imposed_part

Floats = NDArray[np.float64]

_PER_PLACE = 4  # points of the grid for each resolved place
_MOST = 60_000  # points
_LEAST_CYCLES = 2.0  # that a line must have in a run: fewer are a slow course
_FORMS = (("", False, False), ("by_direction", True, False), ("of each run", False, True),
          ("of each run, by direction", True, True))  # fmt: skip
_LESS_SIMPLE = 1.0  # [nats] prior odds of each of the two complications
_HARMONICS = 6


@dataclass(frozen=True)
class Score:
    """What a line at each place would gain.

    Parameters
    ----------
    places : ndarray
        [1/rev], [1/m] or [Hz].
    gain : ndarray
        Log evidence [nats], sizes common to all runs, or one phase for each run, whichever is larger.
    resolved : float
        Number of places that the runs resolve.
    """

    places: Floats
    gain: Floats
    resolved: float


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield the strongest line over the angle (at a whole order and anywhere) and over time, in four forms."""
    turn = 1.0 if in_a_line(fit) else 1 / (2 * pi)
    axis = "cycles/m" if in_a_line(fit) else "motor_shaft"
    for kind, over, unit in (("line_family", turn, axis), ("tone", 0.0, "Hz")):
        score = scored(fit, over)
        if score.places.size == 0 or score.gain.max() <= 0:
            continue
        at = _refined(fit, over, score)
        whole = round(at)
        if (
            kind == "line_family"
            and unit == "motor_shaft"
            and whole
            and abs(at - whole) * score.resolved < score.places[-1]
        ):
            yield from lines(fit, kind, over, [float(whole * k) for k in range(1, _HARMONICS + 1)], unit,
                             places=score.places[-1])  # fmt: skip
        yield from lines(fit, kind, over, [at], unit, places=score.resolved)


def lines(
    fit: Fit, kind: str, over: float, orders: Sequence[float], axis: str, *, places: float
) -> Iterator[Hypothesis]:  # fmt: skip
    """Yield a line family in its four forms; ``places`` is the number of places that were searched."""
    in_band = [order for order in orders if any(_shown_in(run, order, over) for run in fit.runs)]
    if not in_band:
        return
    turning, imposed = over > 0, imposed_part(fit.model.nominal)
    assert imposed is not None
    for form, by_direction, local in _FORMS:
        if by_direction and not turning:
            continue
        unit = {"motor_shaft": "per turn", "cycles/m": "cycles/m", "Hz": "Hz"}[axis]
        yield Hypothesis(
            name=f"{kind}_{in_band[0]:.5g}", kind=kind, variant=form, axis=axis, at=in_band[0], orders=tuple(in_band),
            label=f"a periodic effort at {in_band[0]:.4g} {unit}{', ' + form.replace('_', ' ') if form else ''}",
            columns=_Waves(tuple(in_band), over, by_direction), scale=effort_scale(fit.runs), local=local,
            log_odds=-log(max(places, 2.0)) - _LESS_SIMPLE * (by_direction + local),
            written=None if form or not turning else _Written(imposed.at, tuple(in_band), over),
        )  # fmt: skip


@dataclass(frozen=True)
class _Waves:
    """Cosine and sine of each order over an axis, by direction where wished."""

    orders: tuple[float, ...]
    over: float
    by_direction: bool

    def __call__(self, run: ImposedRun) -> Floats:
        phase = 2 * pi * axis_of(run, self.over)
        waves = np.column_stack([wave(order * phase) for order in self.orders for wave in (np.cos, np.sin)])
        if not self.by_direction:
            return np.asarray(waves)
        ahead = (run.speed > 0)[:, None]
        return np.hstack([waves * ahead, waves * ~ahead])


@dataclass(frozen=True)
class _Written:
    """The part of fitted sizes: the effort is the opposite of the torque; its orders are per radian or metre."""

    at: str
    orders: tuple[float, ...]
    over: float

    def __call__(self, sizes: Floats) -> tuple[Part, ...]:
        torque = {2 * pi * self.over * o: -(sizes[2 * i] - 1j * sizes[2 * i + 1]) for i, o in enumerate(self.orders)}
        return (
            mechanisms.TorqueRipple(
                name=f"unnamed_line_{self.orders[0]:g}".replace(".", "_"), at=self.at, group="mechanical",
                amplitudes={order: float(abs(size)) for order, size in torque.items()},
                phases={order: float(np.angle(size)) for order, size in torque.items()},
            ),
        )  # fmt: skip


def axis_of(run: ImposedRun, over: float) -> Floats:
    """Return the axis of lines [cycles at order 1]: the position times ``over``, or the time where that is zero."""
    return np.asarray(run.position * over if over else run.time)


def scored(fit: Fit, over: float) -> Score:
    """Return what a line would gain at each place, its sizes common to all runs or different in each."""
    signals = weighted_signals(fit)
    spans = [float(np.ptp(axis_of(run, over))) for run, _ in signals]
    top = max(_highest(run, over) for run, _ in signals)
    step = 1 / (_PER_PLACE * max(spans))
    count = int(min(_MOST, (top - _LEAST_CYCLES / max(spans)) / step))
    if count < 10:
        return Score(np.zeros(0), np.zeros(0), 1.0)
    places: Floats = _LEAST_CYCLES / max(spans) + step * np.arange(count, dtype=np.float64)
    total, energy, alone = np.zeros(count, dtype=complex), np.zeros(count), np.zeros(count)
    prior = effort_scale(fit.runs) ** 2
    density = [s for run, s in zip(fit.runs, fit.density, strict=True) if run.seen.any()]
    for (run, signal), s in zip(signals, density, strict=True):
        sums, power = _sums(signal, axis_of(run, over), places), _energy(run, s, places, over)
        total, energy = total + sums, energy + power
        alone += _gain(sums, power, prior)
    common = _gain(total, energy, prior)
    return Score(places, np.maximum(common, alone), count / _PER_PLACE)


def _gain(sums: NDArray[np.complex128], energy: Floats, prior: float) -> Floats:
    """Return the log evidence that a cosine and a sine gain, each with the energy and the variance of its prior."""
    shown = energy > 0
    return np.where(shown, 0.5 * np.abs(sums) ** 2 / np.where(shown, energy, 1.0), 0.0) - np.log1p(energy * prior)


def _refined(fit: Fit, over: float, score: Score) -> float:
    """Return the place of the largest gain, by a parabola through its neighbours."""
    peak = int(np.clip(np.argmax(score.gain), 1, score.gain.size - 2))
    left, middle, right = score.gain[peak - 1 : peak + 2]
    bend = left - 2 * middle + right
    shift = 0.5 * (left - right) / bend if bend < 0 else 0.0
    return float(score.places[peak] + np.clip(shift, -0.5, 0.5) * (score.places[1] - score.places[0]))


def _highest(run: ImposedRun, over: float) -> float:
    """Return the highest order that a run shows for half of its time below the band [1]."""
    quick = float(np.median(np.abs(run.speed))) * over if over else 1.0
    return BAND * run.rate / max(quick, 1e-9 * run.rate)


def _shown_in(run: ImposedRun, order: float, over: float) -> bool:
    return order <= _highest(run, over)


def _sums(signal: Floats, axis: Floats, places: Floats) -> NDArray[np.complex128]:
    """Return ``sum signal exp(-2 pi i place axis)`` at equally spaced places, from samples gathered in fine cells."""
    step = places[1] - places[0]
    length = 1 << int(np.ceil(np.log2(16 * places[-1] / step)))
    cell = 1 / (length * step)
    index = np.rint((axis - axis.min()) / cell).astype(np.int64) % length
    spectrum = np.fft.fft(np.bincount(index, weights=signal, minlength=length))
    nearest = np.rint(places / step).astype(np.int64)
    turned = np.exp(-2j * pi * nearest * step * axis.min())
    return np.asarray(spectrum[nearest] * turned)


def _energy(run: ImposedRun, density: Floats, places: Floats, over: float) -> Floats:
    """Return the sum of squares of a cosine over its variance at each place, in the band that is compared."""
    inside = run.samples_of(run.seen)
    quick = np.abs(run.speed[inside]) * over if over else np.full(int(inside.sum()), 1.0)
    speeds, counts = np.unique(np.round(np.quantile(quick, np.linspace(0.02, 0.98, 25)), 12), return_counts=True)
    share = counts / counts.sum() * inside.sum()
    known, low = run.frequencies, run.frequencies[0]
    answer = np.zeros(places.size)
    for speed, weight in zip(speeds, share, strict=True):
        at = places * speed
        power = 0.5 / np.interp(at, known, density)
        answer += weight * np.where((at >= low) & (at <= known[-1]), power, 0.0)
    return answer
