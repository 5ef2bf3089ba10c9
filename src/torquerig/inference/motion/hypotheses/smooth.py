"""Nameless smooth effects: an effort as a function of the place, of the speed or of time, or in proportion to one."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.fitted_model import Fit, effort_scale
from torquerig.inference.motion.hypotheses.shown import hats, residual_scale
from torquerig.inference.motion.hypothesis import ANYWHERE, Hypothesis
from torquerig.inference.motion.imposed_run import BAND, ImposedRun

Floats = NDArray[np.float64]

_NODES, _OF_TIME = 12, 8
_TAPS = (-2, -1, 0, 1, 2)  # quarters of the shortest period that is compared


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield all families that the model does not have."""
    present = {each.name for each in fit.model.additions}
    for each in _families(fit):
        if each.name not in present:
            yield each


def _families(fit: Fit) -> Iterator[Hypothesis]:
    whole, left = effort_scale(fit.runs), residual_scale(fit)
    fast = max(float(np.abs(run.speed).max()) for run in fit.runs)
    position = np.concatenate([run.position for run in fit.runs])
    speed = np.concatenate([run.speed for run in fit.runs])
    places = np.linspace(float(position.min()), float(position.max()), _NODES)
    speeds = np.unique(np.quantile(speed, np.linspace(0, 1, _NODES)))
    middle, half = 0.5 * (places[0] + places[-1]), 0.5 * float(np.ptp(places))

    def one(name: str, label: str, columns: Callable[[ImposedRun], Floats], scale: float, *, local: bool = False,
            axis: str = "") -> Hypothesis:  # fmt: skip
        return Hypothesis(name=name, kind=name, label=label, columns=columns, scale=scale, local=local,
                          log_odds=ANYWHERE, axis=axis)  # fmt: skip

    yield one(
        "constant_effort", "a constant force or torque (a weight)", lambda run: np.ones((run.time.size, 1)), whole
    )
    yield one("viscous_friction", "friction in proportion to the speed", lambda run: (run.speed / fast)[:, None], whole)
    yield one("spring_to_frame", "a force in proportion to the position (a spring to the frame)",
              lambda run: ((run.position - middle) / half)[:, None], whole)  # fmt: skip
    yield one("over_position", "an effort that is a function of the position",
              lambda run: hats(run.position, places), left, axis="position")  # fmt: skip
    yield one("over_position_by_direction", "an effort that is a function of the position, by direction",
              lambda run: _by_direction(run, places), left, axis="position")  # fmt: skip
    yield one("motion_response", "an effort that follows each small change of the motion (a loop, an inertia)",
              _responses, left)  # fmt: skip
    if speeds.size > 2:
        yield one("over_speed", "an effort that is a function of the speed", lambda run: hats(run.speed, speeds), left,
                  axis="speed")  # fmt: skip
    yield one("slow_course", "an effort that changes slowly with time",
              lambda run: hats(run.time, np.linspace(0, run.time[-1], _OF_TIME)), left, local=True,
              axis="time")  # fmt: skip


def _by_direction(run: ImposedRun, places: Floats) -> Floats:
    """Return functions of the place, and those that turn with the direction, shape (samples, 2 places - 1).

    The latter have no mean over the places: what turns with the direction and is the same at all places is friction.
    """
    at = hats(run.position, places)
    return np.hstack([at, (at[:, 1:] - at[:, :-1]) * np.sign(run.speed)[:, None]])


def _responses(run: ImposedRun) -> Floats:
    """Return the speed's deviation from its median, earlier and later, over its rms, shape (samples, taps).

    Any linear response with a memory of half the shortest period, to either side, is a sum of these: a delay, a wrong
    inertia, a drag, and the loop that answers a deviation of the position with a current. Source: Ljung 1999, System
    Identification, 10.1 (finite impulse response by least squares). Not true for a resonance, which rings longer.
    """
    moved = run.speed - np.median(run.speed)
    moved = moved / max(float(np.sqrt(np.mean(moved**2))), 1e-300)
    return np.column_stack([np.roll(moved, round(tap / (4 * BAND))) for tap in _TAPS])
