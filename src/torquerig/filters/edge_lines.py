"""From which states notches start so that the edge is as right as the middle: as if the lines had always been there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Complex = NDArray[np.complex128]


def states_after_lines(edge: Floats, sections: Floats, angles: Floats, windows: NDArray[np.int64]) -> Floats:
    """Return the states (sections, 2) before ``edge[0]`` if its lines and its level had stood there for ever.

    Parameters
    ----------
    edge : ndarray, shape (samples,)
        The start of the signal, read away from its end.
    sections : ndarray, shape (sections, 6)
        Notches, the longest-ringing first.
    angles : ndarray, shape (sections,)
        Of each notch [rad/sample].
    windows : ndarray of int, shape (sections,)
        Over how much of the edge the line of each notch is looked for; 0 where it is taken as absent.

    Notes
    -----
    The line of each notch is fitted at a frequency refined from the edge itself (the phase between the two halves of
    its window, Hann-weighted), because a line beside its notch passes it in part and never stops ringing there. A
    sinusoid's steady state in a section has a closed form; nothing is filtered before the edge. What the load did
    there is unknown, and taken as its mean over the slowest line's first period.
    """
    offset = edge.mean()  # would leak into the slowest lines
    rest = edge - offset
    amplitudes, found = _taken(rest, angles, windows)
    slowest = float(angles[windows > 0].min(initial=2 * np.pi))
    level = offset + rest[: max(int(2 * np.pi / slowest), 1)].mean()
    return steady_states(np.append(amplitudes, level), np.append(found, 0.0), sections)


def steady_states(amplitudes: Complex, angles: Floats, sections: Floats) -> Floats:
    """Return the states (sections, 2) before sample 0 of a cascade that has always had some lines as input.

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


def _taken(rest: Floats, angles: Floats, windows: NDArray[np.int64]) -> tuple[Complex, Floats]:
    """Return complex amplitude and angle of the line at each notch, one after the other taken out of ``rest``."""
    from torquerig.filters.kernel import take_line, turned_back

    amplitudes, found = np.zeros(angles.size, dtype=np.complex128), angles.copy()
    for row in np.flatnonzero(windows):
        size = int(windows[row])
        half = size // 2
        early, late = (turned_back(rest, first, half, angles[row]) for first in (0, half))
        # no farther than half a turn between the halves: at eight time constants the notch's own width
        found[row] += np.angle(late * np.conj(early)) / half
        amplitudes[row] = turned_back(rest, 0, size, found[row])
        later = windows[row + 1 :].max(initial=0)
        longest = max(int(later), min(int(2 * np.pi / angles[windows > 0].min()), rest.size))
        take_line(rest, longest, amplitudes[row], found[row])
    return amplitudes, found
