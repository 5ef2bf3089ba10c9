"""Hidden effects of the fleet: one file per mechanism of the contract; each draws itself for a rig or returns None."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from proof.fleet.effect import Effect
from proof.fleet.effects.backlash import draw_backlash
from proof.fleet.effects.bearing_defect import draw_bearing_defect
from proof.fleet.effects.blade_pass import draw_blade_pass
from proof.fleet.effects.clipping import draw_clipping
from proof.fleet.effects.cogging import draw_cogging
from proof.fleet.effects.commutation_ripple import draw_commutation_ripple
from proof.fleet.effects.gear_mesh import draw_gear_mesh
from proof.fleet.effects.mains_interference import draw_mains_interference
from proof.fleet.effects.pwm_aliasing import draw_pwm_aliasing
from proof.fleet.effects.quadratic_drag import draw_quadratic_drag
from proof.fleet.effects.quantization import draw_quantization
from proof.fleet.effects.sensor_bandwidth import draw_sensor_bandwidth
from proof.fleet.effects.sensor_drift import draw_sensor_drift
from proof.fleet.effects.signal_dropout import draw_signal_dropout
from proof.fleet.effects.stribeck_friction import draw_stribeck_friction
from proof.fleet.effects.torsional_mode import draw_torsional_mode
from proof.fleet.setting import Setting

Draw = Callable[[np.random.Generator, Setting], Effect | None]

MECHANISMS: dict[str, Draw] = {
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
