"""What a cascade of biquads makes of a signal: sample by sample with states, or both ways without delay."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.edge_lines import states_after_lines

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_EDGE_SPANS = 8.0  # time constants of a section over which its line at the edge is fitted
_FEWEST_PERIODS = 3.0  # of a section's own frequency that the edge must hold for a fit
_DEAD_SPANS = 28.0  # time constants after which a free response has died away: e^-28 is 7e-13


def cascaded(values: Floats, sections: Floats, *, states: Floats | None = None) -> tuple[Floats, Floats]:
    """Return what the cascade makes of the next samples, and its states after them: no sample waits for a later one.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    sections : ndarray, shape (sections, 6)
        b0, b1, b2, 1, a1, a2 of each biquad, as scipy has them.
    states : ndarray, shape (sections, 2), optional
        From the call before; at rest where there was none.

    Notes
    -----
    Transposed direct form II in the order of operations of ``scipy.signal.sosfilt``: the same numbers to the last bit.
    """
    source = np.asarray(values, dtype=np.float64)
    answer = np.empty(source.size) if len(sections) else source.copy()
    after = np.zeros((len(sections), 2)) if states is None else np.array(states, dtype=np.float64)
    _run(source, sections, after, out=answer)
    return answer, after


def zero_phase(values: Floats, sections: Floats) -> Floats:
    """Return the cascade run forwards and backwards, with the ends continued point-symmetrically.

    The edges are those of ``scipy.signal.sosfiltfilt`` (Gustafsson 1996, "Determining the initial states in
    forward-backward filtering", names what they cost: a ringing notch lets its line through there).

    Raises
    ------
    RecordingError
        Where the signal is shorter than the continuation, about six samples per section.
    """
    return _both_ways(values, sections, quiet=None)


def zero_phase_notched(values: Floats, sections: Floats) -> Floats:
    """Return the notches run forwards and backwards, at both ends as if the lines went on beyond them.

    Away from the edges (once the states have died away) the answer equals :func:`zero_phase` to the last bit.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    sections : ndarray, shape (sections, 6)
        Notches, the longest-ringing first for speed. For sections that pass a band use :func:`zero_phase`.

    Notes
    -----
    The line of each notch is fitted to the edge over eight of the notch's time constants, at a frequency of its own,
    and continued beyond it (:mod:`~torquerig.filters.edge_lines`): Gustafsson 1996 names what unknown states
    at the edge cost. Where the edge holds fewer than three periods of a notch, its line is taken as absent; where that
    holds of all, the edges are those of :func:`zero_phase`. Load near the notch within the first ringing time is taken
    along as anywhere else.
    """
    return _both_ways(values, sections, quiet=_windows(values.size, sections))


def quiet_start(values: Floats, sections: Floats) -> Floats:
    """Return the states (sections, 2) before the first sample as if its lines had always been there.

    As in :func:`zero_phase_notched`, for a signal that is to be filtered piece by piece.
    """
    from scipy.signal import sosfilt_zi

    windows = _windows(values.size, sections)
    edge = np.asarray(values[: max(int(windows.max(initial=0)), 1)], dtype=np.float64)
    given = sosfilt_zi(sections) * (edge[0] if edge.size else 0.0)
    return _at_edge(edge, sections, given, windows)


def _windows(size: int, sections: Floats) -> NDArray[np.int64]:
    """Over how many samples each section's state is fitted; 0 where the edge holds too few of its periods."""
    spans = np.minimum(np.ceil(_EDGE_SPANS * time_constants(sections)), size)
    periods = spans * _pole_angles(sections) / (2 * np.pi)
    return np.where(periods >= _FEWEST_PERIODS, spans, 0).astype(np.int64)


def time_constants(sections: Floats) -> Floats:
    """Return after how many samples each section's ringing has fallen to 1/e, shape (sections,)."""
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
    """Filter into ``out`` (by default in place), as many sections at a time as the kernel has lanes."""
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
    answer = np.empty(values.size)
    head, tail = 2 * values[0] - values[reach:0:-1], 2 * values[-1] - values[-2 : -reach - 2 : -1]
    states = steady * head[0]
    _run(head, sections, states)
    begun = states.copy()
    edge = values[: 0 if quiet is None else max(int(quiet.max()), 1)]
    quietest = None if quiet is None else _at_edge(edge, sections, begun, quiet)
    _run(values, sections, states, out=answer)
    _run(tail, sections, states)
    if quietest is not None:
        _add_ringing(answer, sections, quietest - begun)
    states = steady * tail[-1]
    _run(tail, sections, states, backwards=True)
    begun = states.copy()
    edge = answer[: -max(int(quiet.max()), 1) - 1 : -1] if quiet is not None else answer[:0]
    quietest = None if quiet is None else _at_edge(edge, sections, begun, quiet)
    _run(answer, sections, states, backwards=True)
    if quietest is not None:
        _add_ringing(answer[::-1], sections, quietest - begun)
    return answer


def _at_edge(edge: Floats, sections: Floats, given: Floats, windows: NDArray[np.int64]) -> Floats:
    """Return the states (sections, 2) at the start of ``edge``, those ``given`` where no line can be fitted there."""
    if not edge.size or not windows.any():
        return given.copy()
    return states_after_lines(edge, sections, _pole_angles(sections), windows)


def _add_ringing(answer: Floats, sections: Floats, states: Floats) -> None:
    """Add what the cascade gives for no input from ``states``, until it has died away."""
    from torquerig.filters.kernel import add_free_response

    spans = np.sort(time_constants(sections))
    several = int(_DEAD_SPANS * spans[-2:][0]) + 64  # from here on only the longest-ringing section still sounds
    ringing = np.zeros(min(several, answer.size))
    _run(ringing, sections, states)
    answer[: ringing.size] += ringing
    if several < answer.size:
        a1, a2 = sections[int(np.argmax(time_constants(sections))), 4:]
        alone = answer[several : int(_DEAD_SPANS * spans[-1])]
        add_free_response(alone, a1, a2, ringing[-1], ringing[-2])
