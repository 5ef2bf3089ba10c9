"""Random rigs: chains of two to six inertias with gears, gaps, dry friction, loads, and stiffnesses far apart."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from torquerig.mechanisms import BladePass, GearMesh, ParticleLoad, QuadraticDrag, StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController, TorqueSensor

SAMPLE_RATES = (1000.0, 5000.0, 25_000.0)  # [Hz]


def random_rig(seed: int) -> tuple[Rig, float]:
    """Return a rig and its sample rate [Hz].

    Inertias are referred to the shaft they are on, modes lie between 5 Hz and 3 kHz, damping ratios between 0.5 and 20
    per cent; half of the gears have play, half of the rigs dry friction, a third of them run through standstill.
    """
    rng = np.random.default_rng(seed)
    size = 10 ** rng.uniform(-4, -1)
    parts: list[Part] = [Motor(
        name="motor", inertia=size, torque_limit=_log(rng, 200, 2000) * size, viscous=_log(rng, 0.01, 0.3) * size,
        current_loop_bandwidth=_log(rng, 100, 2000),
    )]  # fmt: skip
    turns, place, whole = 1.0, int(rng.integers(1, 4)), size
    for number in range(1, int(rng.integers(2, 6)) + 1):
        geared = number != place and rng.random() < 0.4
        ratio = float(rng.choice([-1.0, 1.0]) * _log(rng, 1.5, 10)) if geared else 1.0
        turns /= ratio
        inertia = size * _log(rng, 0.05, 5) / turns**2
        stiffness = inertia * (2 * pi * _log(rng, 5, 3000)) ** 2
        damping = 2 * _log(rng, 0.005, 0.2) * sqrt(stiffness * inertia)
        whole += inertia * turns**2
        parts += _stage(rng, number, ratio, stiffness=stiffness, damping=damping, inertia=inertia, read=number == place)
    if not any(part.name == "sensor" for part in parts):
        parts.append(TorqueSensor(
            name="sensor", after=parts[-1].name, stiffness=whole / turns**2 * 1e5, damping=whole / turns**2 * 5,
            inertia=0.1 * whole / turns**2, bandwidth=1e3,
        ))  # fmt: skip
    end, torque = parts[-1].name, _log(rng, 2, 60) * whole / abs(turns)
    speed = _log(rng, 5, 150)
    crossover = _log(rng, 0.5, 8)
    kp = 2 * pi * crossover * whole
    parts += [SpeedController(name="loop", kp=kp, ki=kp * 2 * pi * crossover / 10), *_effects(rng, end, torque, parts)]
    profile = str(rng.choice(["steady", "steady", "reversal"]))
    return Rig(tuple(parts), Run(speed=speed, profile=profile), measured="sensor"), float(rng.choice(SAMPLE_RATES))


def _stage(
    rng: np.random.Generator, number: int, ratio: float, *, stiffness: float, damping: float, inertia: float, read: bool
) -> list[Part]:
    after = "motor" if number == 1 else f"body{number - 1}"
    body = Body(name=f"body{number}", after="sensor" if read else f"stage{number}", inertia=0.9 * inertia)
    if read:
        sensor = TorqueSensor(
            name="sensor", after=after, stiffness=stiffness, damping=damping, inertia=0.1 * inertia, bandwidth=1e3
        )
        return [sensor, body]
    if ratio == 1.0:
        bar = Coupling(name=f"stage{number}", after=after, stiffness=stiffness, damping=damping, inertia=0.1 * inertia)
        return [bar, body]
    play = _log(rng, 1e-4, 2e-2) if rng.random() < 0.5 else 0.0
    gear = Gear(
        name=f"stage{number}", after=after, ratio=ratio, stiffness=stiffness, damping=damping, backlash=play,
        efficiency=float(rng.choice([1.0, 0.95, 0.8])), output_inertia=0.1 * inertia,
    )  # fmt: skip
    return [gear, body]


def _effects(rng: np.random.Generator, end: str, torque: float, parts: list[Part]) -> list[Part]:
    found: list[Part] = []
    if rng.random() < 0.5:
        found.append(StribeckFriction(
            name="dry", at=end, coulomb=0.3 * torque, static=float(rng.choice([0.3, 0.5])) * torque,
            stribeck_speed=_log(rng, 0.1, 3), smoothing=_log(rng, 0.01, 0.2),
        ))  # fmt: skip
    if rng.random() < 0.5:
        found.append(ParticleLoad(name="load", at=end, mean_by_occupancy_percent={0: torque, 100: torque}))
    if rng.random() < 0.4:
        found.append(BladePass(name="blades", at=end, order_output=float(rng.integers(2, 8)), amplitude=torque))
    if rng.random() < 0.4:
        found.append(
            TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 0.1 * torque, 24: 0.03 * torque})
        )
    if rng.random() < 0.3:
        found.append(QuadraticDrag(name="drag", at=end, coefficient=torque / 1e4))
    gears = [part.name for part in parts if isinstance(part, Gear)]
    if gears and rng.random() < 0.5:
        found.append(GearMesh(name="mesh", gear=gears[0], order_output=40, transmission_error=(1e-4,)))
    return found


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))
