"""A recording with its torque shifted by some orders: the placebo test of chains with a tooth at every harmonic."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.comb import CausalComb, Comb
from torquerig.filters.evaluation.shifted_chain import shiftable_lines
from torquerig.filters.synchronous_average import SynchronousAverage

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage

_STEP, _LEAST_GAP = 0.05, 0.2  # [1/rev]


def comb_lines(chain: Chain) -> tuple[KinematicLine, ...]:
    """Return the distinct lines from which a chain's combs and synchronous averages estimate the speed."""
    return tuple(dict.fromkeys(line for stage in chain.stages for line in _lines(stage)))


def comb_teeth(chain: Chain) -> tuple[tuple[float, float], ...]:
    """Return spacing and half width of each comb's teeth [orders of the output shaft]; () for none."""
    return tuple(one for stage in chain.stages for one in _teeth(stage))


def empty_order_shifts(chain: Chain, *, known: Sequence[KinematicLine]) -> tuple[float, ...]:
    """Return the shifts in orders at which every known line falls between all teeth.

    Parameters
    ----------
    known : sequence of KinematicLine
        All lines of the drive; they must not meet the single lines that the chain removes, either.
    """
    teeth = comb_teeth(chain)
    if not teeth:
        return ()
    lines = np.array([line.output_order for line in known])
    single = np.array([line.output_order for line in shiftable_lines(chain)])
    # all sets of teeth repeat after their widest spacing
    count = round(max(spacing for spacing, _ in teeth) / _STEP)
    turns = [step / round(1 / _STEP) for step in range(1, count)]
    return tuple(by for by in turns if all(_between(lines + by, *one) for one in teeth) and _clear(lines + by, single))


def order_shifted(recording: Recording, orders: float, *, angle: NDArray[np.float64], ratio: float) -> Recording:
    """Return the recording with its torque, except the mean, shifted up by ``orders`` of the output shaft.

    Parameters
    ----------
    angle : ndarray, shape (samples,)
        Of the motor [rad].
    ratio : float
        Motor turns per output turn [1].

    Notes
    -----
    The analytic signal is multiplied by the shift's unit vector, and its real part is taken. Spectrum and variance are
    the same, shifted by ``orders``.
    """
    name = recording.torque_name()
    values = recording.channels[name].values
    mean, size = values.mean(), values.size
    spectrum = np.fft.fft(values - mean)
    spectrum[1 : (size + 1) // 2] *= 2
    spectrum[size // 2 + 1 :] = 0
    moved = (np.fft.ifft(spectrum) * np.exp(1j * orders / ratio * angle)).real
    return recording.with_values(name, moved + mean)


def _teeth(stage: Stage) -> list[tuple[float, float]]:
    if isinstance(stage, Comb | CausalComb):
        return [(line.output_order, line.output_order / (2 * stage.periods + 1)) for line in stage.lines]
    if isinstance(stage, SynchronousAverage):
        return [(1.0, 0.0)]
    return [one for inner in getattr(stage, "around", ()) for one in _teeth(inner)]


def _lines(stage: Stage) -> list[KinematicLine]:
    if isinstance(stage, Comb | CausalComb | SynchronousAverage):
        return list(stage.lines)
    return [one for inner in getattr(stage, "around", ()) for one in _lines(inner)]


def _between(lines: NDArray[np.float64], spacing: float, half_width: float) -> bool:
    distance = np.abs(lines - spacing * np.round(lines / spacing))
    # narrow spacings allow only a smaller gap
    gap = max(min(_LEAST_GAP, 0.25 * spacing), half_width)
    return bool(distance.min(initial=np.inf) >= gap - 1e-9)


def _clear(lines: NDArray[np.float64], single: NDArray[np.float64]) -> bool:
    return bool(np.abs(lines[:, None] - single[None, :]).min(initial=np.inf) >= _LEAST_GAP - 1e-9)
