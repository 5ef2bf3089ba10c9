"""Steady runs that end with another spectrum than they begin with, and those whose load only is never the same."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.judging import along_runs as judged
from torquerig.diagnosis.judging.changing import changing
from torquerig.diagnosis.looking.observed import Observed

RATE, COUNT = 10_000.0, 120_000


@pytest.fixture(autouse=True)
def _whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judged, "moments_without_signal", lambda recording: recording.lost)


def rings(force: NDArray[np.float64], hertz: float, damping: float = 0.05) -> NDArray[np.float64]:
    from scipy.signal import cont2discrete, lfilter

    omega = 2 * np.pi * hertz
    top, bottom, _ = cont2discrete(([omega**2], [1.0, 2 * damping * omega, omega**2]), 1 / RATE)
    return np.asarray(lfilter(np.ravel(top), bottom, force))


def run(seed: int, *, softens: float = 1.0, steady: bool = True, lost: tuple[int, ...] = ()) -> Observed:
    """Hits of a load, sixty a second, that ring a shaft at 190 Hz, softer at the end; a line and noise beside it."""
    rng = np.random.default_rng(seed)
    hits = rng.exponential(1.0, COUNT) * (rng.random(COUNT) < 60 / RATE)
    course = np.linspace(0.0, 1.0, COUNT)
    ringing = (1 - course) * rings(hits, 190.0) + course * rings(hits, 190.0 * softens)
    line = 0.3 * np.cos(2 * np.pi * 50.0 * np.arange(COUNT) / RATE) * (1 + course)
    torque = ringing + line + 1e-4 * rng.standard_normal(COUNT)
    recording = SimpleNamespace(lost=lost, duration=COUNT / RATE)
    return cast("Observed", SimpleNamespace(
        name=f"run{seed}", torque=torque, rate=RATE, steady=steady, rebuilt=False, recording=recording
    ))  # fmt: skip


@pytest.mark.parametrize("seed", range(20))
def test_a_load_that_is_never_the_same_and_a_line_that_grows_are_no_change(seed: int) -> None:
    assert changing([run(3 * seed + at) for at in range(3)]) == ()


def test_a_shaft_that_softens_is_told_with_its_band() -> None:
    ((sentence, mismatch),) = changing([run(at, softens=0.5) for at in range(3)])
    assert (mismatch.domain, mismatch.axis) == ("time", "s")
    assert mismatch.recordings == ("run0", "run1", "run2")
    assert mismatch.at > 0.5 * COUNT / RATE
    assert mismatch.p_value < 1e-3
    assert "Something changes during the recordings" in sentence


def test_what_is_no_steady_run_or_has_moments_without_signal_is_left_out() -> None:
    soft = [run(at, softens=0.5, lost=(1,)) for at in range(3)]
    assert changing(soft) == ()
    assert changing([run(at, softens=0.5, steady=False) for at in range(3)]) == ()
    assert changing([]) == ()
