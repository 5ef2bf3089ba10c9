"""Filters beside their peers in one run: twenty notches on 10 M samples, their edges, and order lines under wander.

One thread (set before numpy is imported). Run: python benchmarks/filters.py
"""

import os

os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")

import time
from collections.abc import Callable
from math import pi

import numpy as np
from numpy.typing import NDArray
from scipy.signal import filtfilt, iirnotch, sosfiltfilt

from torquerig.signals.filters.biquad_stream import zero_phase_pieces
from torquerig.signals.filters.biquads import time_constants, zero_phase, zero_phase_notched
from torquerig.signals.filters.ideal_bandstop import without_bands

Floats = NDArray[np.float64]
RATE, SAMPLES, TURNS, QUALITY = 25_000.0, 10_000_000, 5, 30.0
SPEED = 1000 / 60  # motor turns per second
ORDERS = (0.2, 0.4, 0.6, 0.8, 1, 2, 3, 4, 6, 7, 12, 14, 16.8, 21, 28, 33.6, 36, 42, 50.4, 67.2)


def rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


def best_of(call: Callable[[], Floats], samples: int, turns: int = TURNS) -> tuple[float, Floats]:
    """Return the most samples per second [MS/s] of several turns, and the answer."""
    least, answer = 1e9, np.zeros(0)
    for _ in range(turns):
        del answer
        start = time.perf_counter()
        answer = call()
        least = min(least, time.perf_counter() - start)
    return samples / least / 1e6, answer


def loop_of_filtfilt(values: Floats) -> Floats:
    for order in ORDERS:
        values = filtfilt(*iirnotch(order * SPEED, QUALITY, RATE), values)
    return values


def throughput() -> None:
    rng = np.random.default_rng(1)
    values = 1.0 + rng.normal(size=SAMPLES)
    sections = np.array([np.concatenate(iirnotch(order * SPEED, QUALITY, RATE)) for order in ORDERS])
    bands = [(order * SPEED * (1 - 0.5 / QUALITY), order * SPEED * (1 + 0.5 / QUALITY)) for order in ORDERS]
    zero_phase_notched(values[:500_000], sections)  # compiles
    print(f"20 notches without delay, {SAMPLES / 1e6:g} M float64, one thread; best of {TURNS}, in MS/s")
    speed, theirs = best_of(lambda: sosfiltfilt(sections, values), SAMPLES, 2)
    print(f"  scipy sosfiltfilt                  {speed:7.1f}")
    speed, _ = best_of(lambda: without_bands(values, RATE, bands), SAMPLES, 2)
    print(f"  FFT ideal notch (numpy)            {speed:7.1f}")
    speed, _ = best_of(lambda: loop_of_filtfilt(values), SAMPLES, 1)
    print(f"  loop of filtfilt(iirnotch)         {speed:7.1f}")
    speed, ours = best_of(lambda: zero_phase(values, sections), SAMPLES)
    print(f"  compiled cascade, scipy's edges    {speed:7.1f}   largest difference {np.abs(ours - theirs).max():.1e}")
    speed, ours = best_of(lambda: zero_phase_notched(values, sections), SAMPLES)
    inner = slice(int(30 * time_constants(sections).max()), -int(30 * time_constants(sections).max()))
    apart = np.abs(ours - theirs)[inner].max()
    print(f"  compiled cascade, quiet edges      {speed:7.1f}   wanted 40; apart from the edges {apart:.1e}")
    pieces = np.array_split(values, 20)
    speed, streamed = best_of(lambda: np.concatenate(list(zero_phase_pieces(pieces, sections))), SAMPLES, 2)
    print(f"  the same over overlapping blocks   {speed:7.1f}   largest difference {np.abs(streamed - ours).max():.1e}")


def edges() -> None:
    print("edges: 20 lines of 0.5 N m, noise 0.1 N m, 40 s; lowest notch 3.3 Hz at Q 30 (3 s)")
    at, rng = np.arange(1_000_000) / RATE, np.random.default_rng(2)
    load = 1.0 + 0.1 * rng.normal(size=at.size)
    sections = np.array([np.concatenate(iirnotch(order * SPEED, QUALITY, RATE)) for order in ORDERS])
    lines = sum(0.5 * np.cos(2 * pi * order * SPEED * at + rng.uniform(0, 2 * pi)) for order in ORDERS)
    second, middle = slice(0, int(RATE)), slice(400_000, 600_000)
    for name, call in (("scipy sosfiltfilt", sosfiltfilt), ("quiet edges", lambda s, v: zero_phase_notched(v, s))):
        answer = call(sections, load + lines)
        wrong = answer - load
        print(
            f"  {name:18s} answer less mean, first second {rms(answer[second] - 1):.3f}, middle "
            f"{rms(answer[middle] - 1):.3f} N m; less the load itself {rms(wrong[second]):.4f}, last second "
            f"{rms(wrong[-int(RATE) :]):.4f}, middle {rms(wrong[middle]):.4f} N m"
        )


if __name__ == "__main__":
    throughput()
    edges()
