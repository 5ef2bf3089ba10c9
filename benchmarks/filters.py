"""Filters beside their peers in one run: twenty notches on 10 M samples, their edges, and order lines under wander.

One thread (set before numpy is imported). Run: python benchmarks/filters.py
"""

import os

os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")

import time
from collections.abc import Callable
from functools import partial
from math import pi

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, filtfilt, iirnotch, sosfiltfilt

from torquerig.filters.biquad_stream import zero_phase_pieces
from torquerig.filters.biquads import time_constants, zero_phase, zero_phase_notched
from torquerig.filters.ideal_bandstop import without_bands
from torquerig.filters.order_bandstop import OrderBandstop
from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.sensor_stages.encoder import Encoder

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
    phases = rng.uniform(0, 2 * pi, len(ORDERS))
    second, middle = slice(0, int(RATE)), slice(400_000, 600_000)
    for beside in (0.0, 0.001, 0.002, 0.005):
        waves = zip(ORDERS, phases, strict=True)
        lines = sum(0.5 * np.cos(2 * pi * order * SPEED * (1 + beside) * at + phase) for order, phase in waves)
        print(f"  lines {100 * beside:g} % beside their notches; error to the load, first and last second, middle")
        for name, call in (("scipy sosfiltfilt", sosfiltfilt), ("ours", lambda s, v: zero_phase_notched(v, s))):
            wrong = call(sections, load + lines) - load
            first, last, inner = (rms(wrong[part]) for part in (second, slice(-int(RATE), None), middle))
            told = f"{first / inner:.2f} and {last / inner:.2f} times the middle"
            print(f"    {name:18s} {first:.4f}, {last:.4f}, {inner:.4f} N m: {told}")


def tracked_in_numpy(values: Floats, angle: Floats) -> Floats:
    """A tracked heterodyne as one would write it: demodulate, low-pass twice, remodulate."""
    for order in ORDERS:
        unit = np.exp(1j * order * angle)
        low = sosfiltfilt(butter(2, 0.5, fs=RATE, output="sos"), values * unit.conj(), padlen=2 * int(RATE))
        values = values - 2 * (low * unit).real
    return values


def wandering(samples: int, share: float) -> tuple[Recording, Floats, Floats]:
    """Return a recording with encoder, its load and its lines: 20 orders of 0.5 N m, noise 0.1 N m."""
    at, rng = np.arange(samples) / RATE, np.random.default_rng(3)
    angle = np.cumsum(2 * pi * SPEED * (1 + share * np.sin(2 * pi * 0.1 * at))) / RATE
    lines = sum(0.5 * np.cos(order * angle + rng.uniform(0, 2 * pi)) for order in ORDERS)
    load = 1.0 + 0.1 * rng.normal(size=samples)
    torque = Channel(values=load + lines, quantity="torque", unit="V")
    truth = Channel(values=angle, quantity="motor_angle", unit="rad", truth=True)
    run = Run(speed=2 * pi * SPEED, gear_ratio=5)
    bare = Recording(sample_rate=RATE, channels={"torque_V": torque, "true_motor_angle_rad": truth}, run=run)
    return Encoder(counts_per_rev=16384).apply(bare).without_truth(), load, lines


def orders() -> None:
    lines = tuple(KinematicLine("motor", 1, order, 5 * order, "", "") for order in ORDERS)
    for samples in (1_000_000, 10_000_000):
        source, load, disturbance = wandering(samples, 0.02)
        bare = Recording(sample_rate=RATE, channels={"torque_V": source.channels["torque_V"]}, run=source.run)
        inner = slice(samples // 10, -samples // 10)
        print(f"20 orders under 2 % wander, {samples / 1e6:g} M samples (inner 80 % and whole record)")
        print("  rest of the lines, dB, and error as a share of the noise")
        stages = {"order band-stop, encoder": OrderBandstop(lines=lines)}
        for name, stage in stages.items():
            speed, answer = best_of(lambda s=stage, given=source: s.apply(given).torque(), samples, 3)
            tell(name, speed, answer - load, disturbance, inner)
        if samples == 1_000_000:
            angle = source.channels["encoder_count"].in_si()
            speed, answer = best_of(partial(tracked_in_numpy, source.torque(), angle), samples, 1)
            tell("heterodyne in numpy, encoder", speed, answer - load, disturbance, inner)
            for share in (0.02, 0.002, 0.0002):
                source, load, disturbance = wandering(samples, share)
                bare = Recording(sample_rate=RATE, channels={"torque_V": source.channels["torque_V"]}, run=source.run)
                speed, answer = best_of(lambda b=bare: OrderBandstop(lines=lines).apply(b).torque(), samples, 1)
                tell(f"torque alone, wander {100 * share:g} %", speed, answer - load, disturbance, inner)


def tell(name: str, speed: float, wrong: Floats, lines: Floats, inner: slice) -> None:
    figures = [(20 * np.log10(rms(wrong[part]) / rms(lines[part])), rms(wrong[part]) / 0.1)
               for part in (inner, slice(None))]  # fmt: skip
    told = "; ".join(f"{level:6.1f} dB {share:6.3f}" for level, share in figures)
    print(f"  {name:30s} {speed:6.1f} MS/s  {told}")


if __name__ == "__main__":
    throughput()
    edges()
    orders()
