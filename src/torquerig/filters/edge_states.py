"""Initial states of notches at the edge of a recording, as if the lines had existed before it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Complex = NDArray[np.complex128]


def states_after_lines(edge: Floats, sections: Floats, angles: Floats, windows: NDArray[np.int64]) -> Floats:
    """Return the steady states (sections, 2) before ``edge[0]`` for the lines and the level of the edge.

    Parameters
    ----------
    edge : ndarray, shape (samples,)
        The start of the signal (for the backward pass its end, reversed).
    sections : ndarray, shape (sections, 6)
        Notches, the longest-ringing first.
    angles : ndarray, shape (sections,)
        Frequency of each notch [rad/sample].
    windows : ndarray of int, shape (sections,)
        Length of the edge over which the line of each notch is fitted [samples]; 0 where it is taken as absent.

    Notes
    -----
    The frequency of each line is refined from the edge (by the phase between the two halves of its window,
    Hann-weighted), because a line off the notch's centre is only attenuated. A sinusoid's steady state in a section has
    a closed form; no samples before the edge are needed. The load before the edge is unknown, and taken as its mean
    over the slowest line's first period.
    """
    offset = edge.mean()  # would leak into the slowest lines
    residual = edge - offset
    amplitudes, found = _subtracted_lines(residual, angles, windows)
    slowest = float(angles[windows > 0].min(initial=2 * np.pi))
    level = offset + residual[: max(int(2 * np.pi / slowest), 1)].mean()
    return steady_states(np.append(amplitudes, level), np.append(found, 0.0), sections)


def steady_states(amplitudes: Complex, angles: Floats, sections: Floats) -> Floats:
    """Return the states (sections, 2) before sample 0 of a cascade in steady state with lines as input.

    Parameters
    ----------
    amplitudes : ndarray, shape (lines,)
        Complex, at sample 0; a constant is a line of angle 0.
    angles : ndarray, shape (lines,)
        [rad/sample].
    """
    turn = np.exp(1j * angles)
    states = np.zeros((len(sections), 2))
    given = amplitudes.astype(np.complex128)
    for row, (b0, b1, b2, _, a1, a2) in enumerate(sections):
        gain = (b0 + b1 / turn + b2 / turn**2) / (1 + a1 / turn + a2 / turn**2)
        # transposed direct form II: y[0] = b0 x[0] + z1, and one step later y[1] = b0 x[1] + (b1 x[0] - a1 y[0] + z2)
        states[row, 0] = ((gain - b0) * given).real.sum()
        states[row, 1] = (((gain - b0) * turn - b1 + a1 * gain) * given).real.sum()
        given = gain * given
    return states


def _subtracted_lines(residual: Floats, angles: Floats, windows: NDArray[np.int64]) -> tuple[Complex, Floats]:
    """Return complex amplitude and angle of the line at each notch, and subtract each from ``residual`` in turn."""
    from torquerig.filters.kernel import take_line, turned_back

    amplitudes, found = np.zeros(angles.size, dtype=np.complex128), angles.copy()
    for row in np.flatnonzero(windows):
        size = int(windows[row])
        half = size // 2
        early, late = (turned_back(residual, first, half, angles[row]) for first in (0, half))
        # at most half a turn between the halves: at eight time constants this is the notch's width
        found[row] += np.angle(late * np.conj(early)) / half
        amplitudes[row] = turned_back(residual, 0, size, found[row])
        later = windows[row + 1 :].max(initial=0)
        longest = max(int(later), min(int(2 * np.pi / angles[windows > 0].min()), residual.size))
        take_line(residual, longest, amplitudes[row], found[row])
    return amplitudes, found
