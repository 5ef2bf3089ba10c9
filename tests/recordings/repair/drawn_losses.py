"""Recordings that lose their signal before the amplifier, and recordings that lose nothing but could mislead."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tests.recordings.repair.drawn_rig import RATE, Floats, amplified, converted, drawn_torque, slow, unit_hits

DURATION = 60.0  # [s]
CLEAR = 5.0  # standard deviations of the neighbourhood that departures reach behind the low-pass
NEAR = 0.25  # [s] either way: the neighbourhood
_AT_ZERO = 0.5  # share of the recordings that fall to 0 V
_UNCLEAR = 0.05  # share of the moments that may depart by less than ``CLEAR``


@dataclass(frozen=True)
class Drawn:
    """Samples in ``unit`` at 25 kHz and what is true of their losses; ``count`` is 0 of a clean recording.

    ``length`` is their median [s], ``low_pass`` the cut-off [Hz], ``level`` in ``unit``, ``kind`` what was drawn.
    """

    values: Floats
    unit: str
    kind: str
    count: int = 0
    length: float = 0.0
    low_pass: float = 0.0
    level: float = 0.0
    moments: tuple[tuple[int, int], ...] = ()
    nm_per_unit: float = 1.0


def lossy(seed: int, *, duration: float = DURATION) -> Drawn:
    """Return a recording with losses; rigs that would hide them below ``CLEAR`` are drawn again."""
    rng = np.random.default_rng([seed, 1])
    zero, profile = rng.random() < _AT_ZERO, str(rng.choice(["steady", "steady", "steady", "ramp", "reversal"]))
    while True:
        level = 0.0 if zero else float(rng.uniform(-9.5, 9.5))
        drawn = _lossy(rng, duration, level=level, profile="steady" if zero else profile)
        if drawn is not None:
            return drawn


def _lossy(rng: np.random.Generator, duration: float, *, level: float, profile: str) -> Drawn | None:
    torque = drawn_torque(rng, duration=duration, profile=profile, hits=rng.uniform(0.05, 0.1))
    volts = torque.values * rng.choice([1.0, -1.0])
    low_pass, length = float(np.exp(rng.uniform(np.log(60), np.log(3000)))), float(rng.uniform(0.002, 0.010))
    kind = str(rng.choice(["butterworth", "butterworth", "butterworth", "bessel", "first order"]))
    moments = _moments(rng, volts.size, length, spread=float(rng.choice([0.0, 0.0, 0.3])))
    whole = amplified(volts, low_pass=low_pass, kind=kind)
    if profile == "steady" and abs(whole.mean() - level) < CLEAR * whole[: int(2 * NEAR * RATE)].std():
        return None
    lost = volts.copy()
    for start, stop in moments:
        lost[start:stop] = level
    behind = amplified(lost, low_pass=low_pass, kind=kind)
    tail, clear = int(2 / low_pass * RATE), []
    for start, stop in moments:
        near = whole[max(start - int(NEAR * RATE), 0) : stop + int(NEAR * RATE)]
        part = slice(start, stop + tail)
        clear.append(np.abs(behind[part] - whole[part]).max() / near.std())
    if np.quantile(clear, _UNCLEAR) < CLEAR:
        return None
    unit, factor, scale = _unit(rng)
    lengths = [(stop - start) / RATE for start, stop in moments]
    return Drawn(
        values=converted(rng, behind) * factor, unit=unit, kind=f"{profile} {kind}", count=len(moments),
        length=float(np.median(lengths)), low_pass=low_pass, level=level * factor, moments=tuple(moments),
        nm_per_unit=scale,
    )  # fmt: skip


def _moments(rng: np.random.Generator, samples: int, length: float, *, spread: float) -> list[tuple[int, int]]:
    """Return 10 to 70 moments a minute at random times; those that meet are one."""
    count = max(round(rng.uniform(10, 70) * samples / RATE / 60), 1)
    lengths = np.clip(length * (1 + spread * rng.uniform(-1, 1, count)), 0.002, 0.010)
    starts = np.sort(rng.uniform(0.01, samples / RATE - 0.05, count))
    merged: list[tuple[int, int]] = []
    for start, own in zip(starts, lengths, strict=True):
        first, last = round(start * RATE), round((start + own) * RATE)
        if merged and first <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(last, merged[-1][1]))
        else:
            merged.append((first, last))
    return merged


def _unit(rng: np.random.Generator) -> tuple[str, float, float]:
    """Return a unit, how many of it a volt is, and how many N*m one of it is."""
    return [("V", 1.0, 1.0), ("V", 1.0, 1.0), ("mV", 1e3, 1e-3), ("N*m", 1.0, 1.0), ("N*m", 25.0, 1.0)][rng.integers(5)]


def clean(seed: int, *, duration: float = DURATION) -> Drawn:
    """Return a recording without losses, of a kind that ``seed`` names in turn."""
    rng = np.random.default_rng([seed, 2])
    name, make = CLEAN[seed % len(CLEAN)]
    unit, factor, scale = _unit(rng)
    low_pass = float(np.exp(rng.uniform(np.log(60), np.log(3000))))
    kind = str(rng.choice(["butterworth", "bessel", "first order"]))
    behind = amplified(make(rng, duration), low_pass=low_pass, kind=kind)
    return Drawn(values=converted(rng, behind) * factor, unit=unit, kind=name, low_pass=low_pass, nm_per_unit=scale)


def _plain(rng: np.random.Generator, duration: float) -> Floats:
    return drawn_torque(rng, duration=duration).values


def _idle(rng: np.random.Generator, duration: float) -> Floats:
    return drawn_torque(rng, duration=duration, occupancy=0.0).values


def _heavy_hits(rng: np.random.Generator, duration: float) -> Floats:
    particle, hits = float(rng.choice([2.0, 4.0, 8.0])), float(rng.uniform(0.1, 0.4))
    return drawn_torque(
        rng, duration=duration, occupancy=float(rng.choice([5.0, 21.0])), particle=particle, hits=hits
    ).values


def _ramp(rng: np.random.Generator, duration: float) -> Floats:
    return drawn_torque(rng, duration=duration, profile="ramp").values


def _reversal(rng: np.random.Generator, duration: float) -> Floats:
    return drawn_torque(rng, duration=duration, profile="reversal").values


def _steps(rng: np.random.Generator, duration: float) -> Floats:
    """Steps of the load up and down, 0.3 s to some seconds apart."""
    volts = drawn_torque(rng, duration=duration).values
    at = np.sort(rng.integers(0, volts.size, int(rng.integers(4, 60))))
    level = np.zeros(volts.size)
    for index, start in enumerate(at):
        level[start:] = (index % 2) * rng.uniform(0.3, 1.5)
    return volts + level


def _telegraph(rng: np.random.Generator, duration: float) -> Floats:
    """A zero that jumps between two levels and stays at each for 0.1 s and longer."""
    volts = drawn_torque(rng, duration=duration).values
    dwell = 0.1 + rng.exponential(0.5, int(duration / 0.3) + 10)
    flips = (np.cumsum(dwell) * RATE).astype(int)
    level = np.zeros(volts.size)
    level[flips[flips < volts.size]] = 1.0
    return volts + rng.uniform(0.05, 1.0) * (np.cumsum(level) % 2)


def _hum(rng: np.random.Generator, duration: float) -> Floats:
    volts = drawn_torque(rng, duration=duration).values
    time = np.arange(volts.size) / RATE
    hum = sum(
        rng.uniform(0, 1) / order * np.cos(2 * np.pi * order * 50.02 * time + rng.uniform(0, 6)) for order in (1, 3, 5)
    )
    return volts + rng.uniform(0.05, 1.0) * hum


def _clipped(rng: np.random.Generator, duration: float) -> Floats:
    """Hits of the load that an amplifier cuts at its limit, before its low-pass."""
    volts = _heavy_hits(rng, duration)
    side = np.sign(np.median(volts)) or 1.0
    limit = float(np.quantile(side * volts, rng.uniform(0.99, 0.9995)))
    return np.asarray(side * np.minimum(side * volts, limit))


def _blades(rng: np.random.Generator, duration: float) -> Floats:
    """Pulses of the load at every passing blade; some rigs have one that is narrow."""
    drawn = drawn_torque(rng, duration=duration)
    power = float(rng.choice([2, 2, 20, 200]))
    wave = np.maximum(np.cos(int(rng.integers(1, 7)) * drawn.angle), 0.0) ** power
    return np.asarray(drawn.values + rng.uniform(0.2, 1.5) * wave)


def _bearing(rng: np.random.Generator, duration: float) -> Floats:
    """Impacts at an odd order that ring at a local mode."""
    drawn = drawn_torque(rng, duration=duration)
    turns = drawn.angle / (2 * np.pi) * rng.uniform(2.5, 7.5)
    struck = np.zeros(drawn.values.size)
    struck[np.flatnonzero(np.diff(np.floor(turns)) != 0)] = 1.0
    ring, damping = rng.uniform(150, 2500), rng.uniform(0.01, 0.1)
    time = np.arange(int(0.1 * RATE)) / RATE
    shape = np.exp(-2 * np.pi * ring * damping * time) * np.sin(2 * np.pi * ring * time)
    return np.asarray(drawn.values + rng.uniform(0.1, 1.5) * np.convolve(struck, shape)[: struck.size])


def _contact_loss(rng: np.random.Generator, duration: float) -> Floats:
    """A light load that swings: flanks of a gap part, the torque rests at zero, and strikes when they meet."""
    samples = round(duration * RATE)
    load = rng.uniform(0.05, 0.6) * (1 + 0.1 * slow(rng, samples, low_pass=1.5))
    turning = np.arange(samples) / RATE * 2 * np.pi * rng.uniform(5, 40)
    load += rng.uniform(0.3, 1.5) * load.mean() * np.cos(turning + 0.5 * slow(rng, samples, low_pass=1.0))
    load += rng.uniform(0.0, 1.0) * load.mean() * slow(rng, samples, low_pass=60.0)
    return _over_gap(load, stiffness=1000.0, inertia=1.4e-3, damping=0.1, gap=rng.uniform(2e-4, 4e-3))


def _over_gap(load: Floats, *, stiffness: float, inertia: float, damping: float, gap: float) -> Floats:
    from numba import njit

    @njit(cache=False)
    def run(load: Floats, step: float) -> Floats:  # pragma: no cover
        twist, speed = load[0] / stiffness, 0.0
        torque = np.empty(load.size)
        for at in range(load.size):
            if twist > 0:
                torque[at] = stiffness * twist + damping * speed
            elif twist < -gap:
                torque[at] = stiffness * (twist + gap) + damping * speed
            else:
                torque[at] = 0.0
            speed += step / inertia * (load[at] - torque[at])
            twist += step * speed
        return torque

    return np.asarray(run(load, 1 / RATE))


def _rare_contact_loss(rng: np.random.Generator, duration: float) -> Floats:
    """A loaded shaft whose torque big particles throw back to zero now and then."""
    samples = round(duration * RATE)
    load = rng.uniform(0.5, 1.5) * (1 + 0.06 * slow(rng, samples, low_pass=1.5))
    load += load.mean() * rng.uniform(0.1, 0.4) * unit_hits(rng, samples, 5.0, float(rng.choice([1.0, 2.0, 4.0])))
    return _over_gap(np.maximum(load, 0), stiffness=1000.0, inertia=1.4e-3, damping=0.05, gap=rng.uniform(5e-4, 4e-3))


Make = Callable[[np.random.Generator, float], Floats]
CLEAN: tuple[tuple[str, Make], ...] = (
    ("steady", _plain), ("idle", _idle), ("heavy hits", _heavy_hits), ("ramp", _ramp), ("reversal", _reversal),
    ("steps of the load", _steps), ("telegraph noise", _telegraph), ("hum", _hum), ("clipped hits", _clipped),
    ("blades", _blades), ("bearing", _bearing), ("contact loss", _contact_loss),
    ("rare contact loss", _rare_contact_loss),
)  # fmt: skip
