"""Cascades of second-order sections (biquads): causal with states, or forwards and backwards (zero-phase)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.edge_states import states_after_lines

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_EDGE_SPANS = 8.0  # time constants of a section over which its line at the edge is fitted
_FEWEST_PERIODS = 3.0  # periods of a section's frequency at the edge, at least, for a fit
_DEAD_SPANS = 28.0  # time constants after which a free response is negligible: e^-28 is 7e-13


def cascaded(values: Floats, sections: Floats, *, states: Floats | None = None) -> tuple[Floats, Floats]:
    """Return the filtered samples (causal) and the states after them.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    sections : ndarray, shape (sections, 6)
        b0, b1, b2, 1, a1, a2 of each biquad, as in scipy.
    states : ndarray, shape (sections, 2), optional
        From the previous call; zero by default.

    Notes
    -----
    Transposed direct form II in the order of operations of ``scipy.signal.sosfilt``: bit-identical results.
    """
    source = np.asarray(values, dtype=np.float64)
    filtered = np.empty(source.size) if len(sections) else source.copy()
    after = np.zeros((len(sections), 2)) if states is None else np.array(states, dtype=np.float64)
    _run(source, sections, after, out=filtered)
    return filtered, after


def zero_phase(values: Floats, sections: Floats) -> Floats:
    """Return the signal filtered forwards and backwards, with the ends continued point-symmetrically.

    The edges are those of ``scipy.signal.sosfiltfilt``. Their cost (Gustafsson 1996, "Determining the initial states in
    forward-backward filtering"): a narrow notch does not remove its line there.

    Raises
    ------
    RecordingError
        Where the signal is shorter than the continuation, about six samples per section.
    """
    return _both_ways(values, sections, quiet=None)


def zero_phase_notched(values: Floats, sections: Floats) -> Floats:
    """Return the signal notched forwards and backwards, with initial states as if the lines continued at both ends.

    Away from the edges (once the initial states have decayed) the result equals :func:`zero_phase` to the last bit.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    sections : ndarray, shape (sections, 6)
        Notches, the longest-ringing first for speed. For sections that pass a band use :func:`zero_phase`.

    Notes
    -----
    The line of each notch is fitted to the edge over eight of the notch's time constants, with a free frequency, and
    continued beyond it (:mod:`~torquerig.filters.edge_states`; Gustafsson 1996 on unknown states at the edge). Where
    the edge holds fewer than three periods of a notch, its line is taken as absent; where that is so for all notches,
    the edges are those of :func:`zero_phase`. Load near the notch frequency is removed with the line, as elsewhere.
    """
    return _both_ways(values, sections, quiet=_windows(values.size, sections))


def quiet_start(values: Floats, sections: Floats) -> Floats:
    """Return the initial states (sections, 2) as if the lines had existed before the first sample.

    As in :func:`zero_phase_notched`, for a signal that is filtered piece by piece.
    """
    from scipy.signal import sosfilt_zi

    windows = _windows(values.size, sections)
    edge = np.asarray(values[: max(int(windows.max(initial=0)), 1)], dtype=np.float64)
    given = sosfilt_zi(sections) * (edge[0] if edge.size else 0.0)
    return _at_edge(edge, sections, given, windows)


def _windows(size: int, sections: Floats) -> NDArray[np.int64]:
    """Return the number of samples over which each section's line is fitted; 0 where there are too few periods."""
    spans = np.minimum(np.ceil(_EDGE_SPANS * time_constants(sections)), size)
    periods = spans * _pole_angles(sections) / (2 * np.pi)
    return np.where(periods >= _FEWEST_PERIODS, spans, 0).astype(np.int64)


def time_constants(sections: Floats) -> Floats:
    """Return the time constant of each section [samples], shape (sections,)."""
    return np.asarray(-1 / np.log(np.minimum(np.abs(_poles(sections)).max(axis=1), 1 - 1e-15) + 1e-300))


def slow_delay(sections: NDArray[np.float64]) -> float:
    """Return the group delay of a cascade at 0 Hz [samples]: sum n b_n / sum b_n - sum n a_n / sum a_n of each."""
    n = np.arange(3)
    each = (sections[:, :3] @ n) / sections[:, :3].sum(axis=1) - (sections[:, 3:] @ n) / sections[:, 3:].sum(axis=1)
    return float(each.sum())


def _poles(sections: Floats) -> NDArray[np.complex128]:
    a1, a2 = sections[:, 4], sections[:, 5]
    root = np.sqrt((a1**2 - 4 * a2).astype(complex))
    return np.stack([(-a1 + root) / 2, (-a1 - root) / 2], axis=1)


def _pole_angles(sections: Floats) -> Floats:
    return np.asarray(np.abs(np.angle(_poles(sections))).max(axis=1))


def _run(
    values: Floats, sections: Floats, states: Floats, *, backwards: bool = False, out: Floats | None = None
) -> None:
    """Filter into ``out`` (by default in place), in groups of as many sections as the kernel has lanes."""
    from torquerig.filters.kernel import LANES, cascade

    for first in range(0, len(sections), LANES):
        rows = slice(first, first + LANES)
        coefficients = np.ascontiguousarray(sections[rows][:, [0, 1, 2, 4, 5]].T, dtype=np.float64)
        changing = np.ascontiguousarray(states[rows].T)
        target = values if out is None else out
        cascade(values if first == 0 else target, target, coefficients, changing, backwards)
        states[rows] = changing.T


def _both_ways(values: Floats, sections: Floats, *, quiet: NDArray[np.int64] | None) -> Floats:
    from scipy.signal import sosfilt_zi

    if not len(sections):
        return values
    reach = 3 * (2 * len(sections) + 1 - int(min((sections[:, 2] == 0).sum(), (sections[:, 5] == 0).sum())))
    if values.size <= reach:
        raise RecordingError(f"{values.size} samples are too few for {len(sections)} biquads; {reach + 1} are needed")
    steady = sosfilt_zi(sections)
    values = np.asarray(values, dtype=np.float64)
    filtered = np.empty(values.size)
    head, tail = 2 * values[0] - values[reach:0:-1], 2 * values[-1] - values[-2 : -reach - 2 : -1]
    states = steady * head[0]
    _run(head, sections, states)
    initial = states.copy()
    edge = values[: 0 if quiet is None else max(int(quiet.max()), 1)]
    fitted = None if quiet is None else _at_edge(edge, sections, initial, quiet)
    _run(values, sections, states, out=filtered)
    _run(tail, sections, states)
    if fitted is not None:
        _add_ringing(filtered, sections, fitted - initial)
    states = steady * tail[-1]
    _run(tail, sections, states, backwards=True)
    initial = states.copy()
    edge = filtered[: -max(int(quiet.max()), 1) - 1 : -1] if quiet is not None else filtered[:0]
    fitted = None if quiet is None else _at_edge(edge, sections, initial, quiet)
    _run(filtered, sections, states, backwards=True)
    if fitted is not None:
        _add_ringing(filtered[::-1], sections, fitted - initial)
    return filtered


def _at_edge(edge: Floats, sections: Floats, given: Floats, windows: NDArray[np.int64]) -> Floats:
    """Return the states (sections, 2) at the start of ``edge``; ``given`` where no line can be fitted."""
    if not edge.size or not windows.any():
        return given.copy()
    return states_after_lines(edge, sections, _pole_angles(sections), windows)


def _add_ringing(signal: Floats, sections: Floats, states: Floats) -> None:
    """Add the free response of the cascade from ``states``, until it is negligible."""
    from torquerig.filters.kernel import add_free_response

    spans = np.sort(time_constants(sections))
    several = int(_DEAD_SPANS * spans[-2:][0]) + 64  # from here on only the longest-ringing section rings
    ringing = np.zeros(min(several, signal.size))
    _run(ringing, sections, states)
    signal[: ringing.size] += ringing
    if several < signal.size:
        a1, a2 = sections[int(np.argmax(time_constants(sections))), 4:]
        later = signal[several : int(_DEAD_SPANS * spans[-1])]
        add_free_response(later, a1, a2, ringing[-1], ringing[-2])
