"""Each class of the contract, once, end to end: simulated with drawn numbers, diagnosed, named, and its numbers read.

The recordings come of the project's own simulator, at 5 kHz where the effect stands below its half, and with five
uncertain numbers; what an independent program records is the business of ``python -m proof``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import pi
from zlib import crc32

import numpy as np
import pytest

from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.mechanisms import (
    Backlash,
    BearingDefect,
    BladePass,
    Clipping,
    Cogging,
    CommutationRipple,
    GearMesh,
    MainsInterference,
    PwmAliasing,
    QuadraticDrag,
    Quantization,
    SensorBandwidth,
    SensorDrift,
    SignalDropout,
    StribeckFriction,
    TorsionalMode,
)
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario

Draw = Callable[[float, float], float]
Plan = tuple[tuple[float, float, str], ...]  # motor rpm, occupancy in per cent, profile
Record = Callable[..., Recording]

AT_TWO_SPEEDS: Plan = ((1000, 5, "steady"), (700, 5, "steady"), (1000, 5, "ramp"))
SLOWER: Plan = ((500, 5, "steady"), (350, 5, "steady"), (500, 5, "ramp"))  # order 84 below half the rate
OFF_THE_MAINS: Plan = ((900, 5, "steady"), (640, 5, "steady"), (900, 5, "ramp"))  # order 3 of 1000 rpm hides 50 Hz
IDLE: Plan = ((1000, 5, "steady"), (700, 0, "steady"), (1400, 0, "ramp"))
TURNING_BACK: Plan = ((1000, 5, "steady"), (400, 0, "steady"), (600, 0, "reversal"), (1400, 0, "ramp"))
LOADED: Plan = ((1000, 15, "steady"), (1000, 5, "steady"), (700, 5, "steady"))


@dataclass(frozen=True, kw_only=True)
class Drawn:
    """An effect, the contract's parameters that must come back, and within what part of themselves."""

    part: Part
    parameters: Mapping[str, tuple[float, float]]
    plan: Plan = AT_TWO_SPEEDS
    rate: float = 5000.0


def gear_mesh(draw: Draw) -> Drawn:
    teeth, error = float(round(draw(55, 110))), draw(4e-5, 1e-4)
    part = GearMesh(name="hidden", order_output=teeth, transmission_error=(error, 0.25 * error))
    return Drawn(part=part, parameters={"order_output": (teeth, 1e-3), "transmission_error_rad": (error, 0.1)})


def commutation_ripple(draw: Draw) -> Drawn:
    order, depth = 42.0, draw(0.06, 0.12)  # six times the field: what six steps make
    part = CommutationRipple(name="hidden", order_motor=order, depth=depth)
    return Drawn(part=part, parameters={"order_motor": (order, 1e-3), "depth": (depth, 0.12)})


def cogging(draw: Draw) -> Drawn:
    size = draw(0.15, 0.3)
    part = Cogging(name="hidden", slots=12, pole_pairs=7, native=size)
    return Drawn(part=part, parameters={"order_motor": (84.0, 1e-3), "amplitude_Nm": (size, 0.15)}, plan=SLOWER)


def blade_pass(draw: Draw) -> Drawn:
    blades, size = float(round(draw(6, 9))), draw(0.3, 0.6)
    part = BladePass(name="hidden", order_output=blades, amplitude=size)
    return Drawn(part=part, parameters={"order_output": (blades, 1e-3), "amplitude_Nm": (size, 0.12)})


def mains_interference(draw: Draw) -> Drawn:
    grid, size = draw(49.95, 50.05), draw(0.03, 0.08)
    part = MainsInterference(name="hidden", frequency=grid, amplitudes=(size, 0.0, 0.3 * size))
    return Drawn(part=part, parameters={"frequency_Hz": (grid, 5e-4), "amplitude_V": (size, 0.15)}, plan=OFF_THE_MAINS)


def pwm_aliasing(draw: Draw) -> Drawn:
    at, size = draw(3000, 3900), draw(0.004, 0.01)
    part = PwmAliasing(name="hidden", frequency=at, amplitude=size)
    return Drawn(part=part, parameters={"frequency_Hz": (at, 1e-4), "amplitude_V": (size, 0.1)}, rate=10_000.0)


def torsional_mode(draw: Draw) -> Drawn:
    at, inertia = draw(60, 110), draw(8e-4, 1.4e-3)
    part = TorsionalMode(name="hidden", after="wear_part", frequency=at, inertia=inertia, damping_ratio=0.03)
    return Drawn(part=part, parameters={"frequency_Hz": (at, 0.04), "inertia_kgm2": (inertia, 0.25)})


def sensor_bandwidth(draw: Draw) -> Drawn:
    cutoff = draw(60, 250)  # one of 296 Hz gains 52 here, and foretells nothing better
    return Drawn(part=SensorBandwidth(name="hidden", cutoff=cutoff), parameters={"cutoff_Hz": (cutoff, 0.08)})


def bearing_defect(draw: Draw) -> Drawn:
    at, ring = draw(3.1, 7.3), draw(900, 1500)
    part = BearingDefect(name="hidden", order_output=at, ring_frequency=ring, amplitude=0.15, slip=0.01)
    return Drawn(part=part, parameters={"order_output": (at, 5e-3), "ring_frequency_Hz": (ring, 0.1)})


def quadratic_drag(draw: Draw) -> Drawn:
    size = draw(8e-4, 1.5e-3)
    return Drawn(
        part=QuadraticDrag(name="hidden", coefficient=size), parameters={"coefficient_Nms2": (size, 0.2)}, plan=IDLE
    )


def sensor_drift(draw: Draw) -> Drawn:
    span, tau = draw(0.4, 0.8), draw(1.2, 2.0)
    part = SensorDrift(name="hidden", span=span, time_constant=tau)
    return Drawn(part=part, parameters={"span_V": (span, 0.15), "time_constant_s": (tau, 0.35)}, plan=IDLE)


def stribeck_friction(draw: Draw) -> Drawn:
    coulomb = draw(0.28, 0.4)  # a smaller peak near standstill is named as well, and its three numbers are not told
    static, speed = coulomb * draw(2.2, 2.6), draw(0.9, 1.4)
    part = StribeckFriction(name="hidden", coulomb=coulomb, static=static, stribeck_speed=speed)
    # the speed of the peak is told poorly: +50 % is seen, see docs/howto-diagnose.md
    parameters = {"coulomb_Nm": (coulomb, 0.15), "static_Nm": (static, 0.25), "stribeck_rad_s": (speed, 0.6)}
    return Drawn(part=part, parameters=parameters, plan=TURNING_BACK)


def backlash(draw: Draw) -> Drawn:
    gap = draw(6, 20)
    part = Backlash(name="hidden", gap=gap * pi / 180 / 60)
    # named soundly, sized poorly from 6 s at 5 kHz: +47 % is seen
    # how flanks bounce hangs on the last bits, which processors round their own way: a width may be off by three
    return Drawn(part=part, parameters={"gap_arcmin": (gap, 2.0)}, plan=TURNING_BACK)


def quantization(draw: Draw) -> Drawn:
    step = draw(0.01, 0.1)
    return Drawn(part=Quantization(name="hidden", step=step), parameters={"step_V": (step, 1e-3)})


def clipping(draw: Draw) -> Drawn:
    limit = draw(2.4, 2.6)
    return Drawn(part=Clipping(name="hidden", limit=limit), parameters={"limit_V": (limit, 1e-3)}, plan=LOADED)


def signal_dropout(draw: Draw) -> Drawn:
    duration = draw(2e-3, 8e-3)
    part = SignalDropout(name="hidden", duration=duration, rate=1.5)
    return Drawn(part=part, parameters={"duration_ms": (1e3 * duration, 0.1), "rate_per_minute": (90.0, 0.7)})


QUICK = (torsional_mode, bearing_defect, quantization, signal_dropout)
LONG = (
    gear_mesh, commutation_ripple, cogging, blade_pass, mains_interference, pwm_aliasing, sensor_bandwidth,
    quadratic_drag, sensor_drift, stribeck_friction, backlash, clipping,
)  # fmt: skip
CLASSES = [*QUICK, *(pytest.param(effect, marks=pytest.mark.full, id=effect.__name__) for effect in LONG)]


def drawn_for(name: str, effect: Callable[[Draw], Drawn]) -> Drawn:
    return effect(np.random.default_rng(crc32(name.encode())).uniform)


@pytest.mark.parametrize("effect", CLASSES, ids=lambda effect: getattr(effect, "__name__", None))
@pytest.mark.long
def test_a_hidden_effect_is_named_with_its_numbers(
    effect: Callable[[Draw], Drawn], known_rig: Scenario, record: Record
) -> None:
    name = effect.__name__
    drawn = drawn_for(name, effect)
    seed, rig = crc32(name.encode()) % 1000, known_rig.rig + drawn.part
    runs = [
        record(rig, 10 * seed + index, rpm=rpm, occupancy=occupancy, profile=profile, rate=drawn.rate)
        for index, (rpm, occupancy, profile) in enumerate(drawn.plan)
    ]
    outcome = diagnose(known_rig, runs)
    check(outcome, name, drawn)


def check(outcome: Outcome, name: str, drawn: Drawn) -> None:
    made = outcome.diagnosis
    assert [finding.mechanism for finding in made.findings] == [name]
    assert made.verdict == "missing_physics"
    found = made.findings[0]
    for parameter, (value, part) in drawn.parameters.items():
        assert found.parameters[parameter].value == pytest.approx(value, rel=part), parameter
        assert found.parameters[parameter].low <= found.parameters[parameter].value <= found.parameters[parameter].high
        if name == "backlash":  # and its interval says so
            assert found.parameters[parameter].low <= value <= found.parameters[parameter].high
    # what drifts has come to rest in the part held out, and a model fitted to a constant serves there as well
    assert made.fit.after < 1.1 * made.fit.before
    assert made.fit.after < 3.5
    if name == "signal_dropout":  # filled before anything is compared, and said so
        assert made.fit.after == made.fit.before
        assert any("Dropouts are interpolated" in remark for remark in made.remarks)
