"""Effects that can be drawn, and pairs that mask each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from proof.rig_program.effects.backlash import draw_backlash
from proof.rig_program.effects.bearing_defect import draw_bearing_defect
from proof.rig_program.effects.blade_pass import draw_blade_pass
from proof.rig_program.effects.clipping import draw_clipping
from proof.rig_program.effects.cogging import draw_cogging
from proof.rig_program.effects.commutation_ripple import draw_commutation_ripple
from proof.rig_program.effects.effect import Effect, Setting
from proof.rig_program.effects.gain_jump import draw_gain_jump
from proof.rig_program.effects.gear_mesh import draw_gear_mesh
from proof.rig_program.effects.hardening_shaft import draw_hardening_shaft
from proof.rig_program.effects.intermittent_slip import draw_intermittent_slip
from proof.rig_program.effects.jumping_line import draw_jumping_line
from proof.rig_program.effects.linear_chirp import draw_linear_chirp
from proof.rig_program.effects.load_step import draw_load_step
from proof.rig_program.effects.mains_interference import draw_mains_interference
from proof.rig_program.effects.noise_band import draw_noise_band
from proof.rig_program.effects.pwm_aliasing import draw_pwm_aliasing
from proof.rig_program.effects.quadratic_drag import draw_quadratic_drag
from proof.rig_program.effects.quantization import draw_quantization
from proof.rig_program.effects.sensor_bandwidth import draw_sensor_bandwidth
from proof.rig_program.effects.sensor_drift import draw_sensor_drift
from proof.rig_program.effects.signal_dropout import draw_signal_dropout
from proof.rig_program.effects.stribeck_friction import draw_stribeck_friction
from proof.rig_program.effects.telegraph import draw_telegraph
from proof.rig_program.effects.time_base_jump import draw_time_base_jump
from proof.rig_program.effects.tone_bursts import draw_tone_bursts
from proof.rig_program.effects.torsional_mode import draw_torsional_mode
from proof.rig_program.plan import PlanKind, Profile, Run

IN_LIBRARY: dict[str, Callable[..., Effect]] = {
    "gear_mesh": draw_gear_mesh,
    "commutation_ripple": draw_commutation_ripple,
    "torsional_mode": draw_torsional_mode,
    "backlash": draw_backlash,
    "stribeck_friction": draw_stribeck_friction,
    "bearing_defect": draw_bearing_defect,
    "mains_interference": draw_mains_interference,
    "sensor_bandwidth": draw_sensor_bandwidth,
    "sensor_drift": draw_sensor_drift,
    "clipping": draw_clipping,
    "quantization": draw_quantization,
    "pwm_aliasing": draw_pwm_aliasing,
    "blade_pass": draw_blade_pass,
    "quadratic_drag": draw_quadratic_drag,
    "signal_dropout": draw_signal_dropout,
    "cogging": draw_cogging,
}

IN_NO_LIBRARY: dict[str, Callable[..., Effect]] = {
    "linear_chirp": draw_linear_chirp,
    "noise_band": draw_noise_band,
    "telegraph": draw_telegraph,
    "jumping_line": draw_jumping_line,
    "hardening_shaft": draw_hardening_shaft,
    "load_step": draw_load_step,
    "intermittent_slip": draw_intermittent_slip,
    "time_base_jump": draw_time_base_jump,
    "gain_jump": draw_gain_jump,
    "tone_bursts": draw_tone_bursts,
}

# pairs in which one effect masks the other
HIDING = {
    frozenset(pair)
    for pair in (
        ("backlash", "stribeck_friction"),
        ("sensor_bandwidth", "bearing_defect"),
        ("sensor_bandwidth", "cogging"),
        ("sensor_bandwidth", "commutation_ripple"),
        ("sensor_bandwidth", "torsional_mode"),
        ("clipping", "sensor_drift"),
        ("clipping", "signal_dropout"),
        ("quantization", "pwm_aliasing"),
        ("quadratic_drag", "stribeck_friction"),
        ("commutation_ripple", "cogging"),
    )
}

NEEDS_TURNING = {"backlash", "stribeck_friction"}  # seen where the torque crosses zero, or near standstill
NEEDS_SPEEDS = {"quadratic_drag", "torsional_mode", "hardening_shaft"}  # at one speed they are a parameter


def draw_effect(rng: np.random.Generator, kind: str, setting: Setting, *, size: float) -> Effect:
    """Draw one effect of a kind at ``size`` (0 just visible, 1 far larger than in handbooks)."""
    return (IN_LIBRARY | IN_NO_LIBRARY)[kind](rng, setting, size=size)


def draw_pair(rng: np.random.Generator, first: str) -> str:
    """Draw a second kind of the library that the first does not hide."""
    others = [kind for kind in IN_LIBRARY if kind != first and frozenset((kind, first)) not in HIDING]
    return str(rng.choice(others))


def plan_kind(rng: np.random.Generator, kinds: tuple[str, ...]) -> PlanKind:
    """Draw a test programme in which these kinds are visible."""
    if NEEDS_TURNING.intersection(kinds):
        return PlanKind.TURNING if rng.random() < 0.85 else PlanKind.OTHER
    weights = {PlanKind.TYPICAL: 0.5, PlanKind.TURNING: 0.15, PlanKind.OTHER: 0.25, PlanKind.ONE_SPEED: 0.1}
    if NEEDS_SPEEDS.intersection(kinds):
        del weights[PlanKind.ONE_SPEED]
    total = sum(weights.values())
    return list(weights)[int(rng.choice(len(weights), p=[w / total for w in weights.values()]))]


def shows(plan: Sequence[Run], kinds: tuple[str, ...]) -> bool:
    """Return whether a run of a plan can show these kinds; a constant load prevents contact loss."""
    return "backlash" not in kinds or any(run.occupancy == 0 or run.profile is Profile.REVERSAL for run in plan)
