"""Loads as a scenario states them: particles, fan, brake, mixer, conveyor, or none."""

from __future__ import annotations

from typing import Any

import numpy as np

from proof.fleet.scale import Scale
from proof.fleet.stated import Parts, Stated

LEVELS = (0, 25, 50, 100)  # occupancy or setting [%]


def state_load(rng: np.random.Generator, kind: str, at: str, body: dict[str, Any], scale: Scale) -> Parts:
    """Return the load and the lines at the body; friction is written into ``body``."""
    torque, speed = scale.torque, scale.output_speed
    body["viscous"] = Stated(torque / speed * float(rng.uniform(0.02, 0.08)), "N*m*s/rad", 0.3)
    parts: Parts = {"load_lines": _lines(rng, at, torque)}
    if kind == "free":
        body["viscous"] = Stated(torque / speed * float(rng.uniform(0.1, 0.2)), "N*m*s/rad", 0.3)
        body["coulomb"] = Stated(torque * float(rng.uniform(0.05, 0.15)), "N*m", 0.3)
        parts["load_lines"] = _lines(rng, at, 0.3 * torque)
        return parts
    if kind in ("fan", "mixer"):
        parts["flow"] = {
            "kind": "turbulent_load",
            "at": at,
            "quadratic": Stated(0.85 * torque / speed**2, "N*m*s^2/rad^2", 0.1),
            "turbulence": round(float(rng.uniform(0.02, 0.08)), 3),
            "turbulence_cutoff": f"{rng.uniform(1.0, 6.0):.3g} Hz",
        }
        if kind == "mixer":
            parts["baffles"] = {
                "kind": "blade_pass", "at": at, "order_output": int(rng.choice([2, 3, 4])),
                "amplitude": Stated(torque * float(rng.uniform(0.03, 0.08)), "N*m", 0.2),
            }  # fmt: skip
        return parts
    if kind == "conveyor":
        body["coulomb"] = Stated(torque * float(rng.uniform(0.03, 0.08)), "N*m", 0.3)
    means = {level: Stated(torque * (0.03 + 0.82 * level / 100.0), "N*m", 0.08) for level in LEVELS}
    load: dict[str, Any] = {"kind": "particle_load", "at": at, "mean_by_occupancy_percent": means}
    if kind == "particles":
        load |= {
            "hit_rate": f"{rng.uniform(30.0, 150.0):.3g} 1/s", "hit_decay": f"{rng.uniform(2.0, 8.0):.3g} ms",
            "hit_rms": round(float(rng.uniform(0.05, 0.12)), 3), "slow_rms": round(float(rng.uniform(0.02, 0.06)), 3),
            "slow_cutoff": f"{rng.uniform(0.8, 2.5):.3g} Hz",
        }  # fmt: skip
    else:
        slow = (0.005, 0.02) if kind == "brake" else (0.02, 0.06)
        load |= {"hit_rms": 0, "slow_rms": round(float(rng.uniform(*slow)), 4),
                 "slow_cutoff": f"{rng.uniform(0.5, 4.0):.3g} Hz"}  # fmt: skip
    parts["load"] = load
    return parts


def _lines(rng: np.random.Generator, at: str, torque: float) -> dict[str, Any]:
    sizes = {order: torque * float(10.0 ** rng.uniform(-2.5, -1.6)) for order in (1, 2, 3)[: int(rng.integers(2, 4))]}
    amplitudes = {order: Stated(size, "N*m") for order, size in sizes.items()}
    return {"kind": "torque_ripple", "at": at, "group": "mechanical", "amplitudes": amplitudes,
            "amplitude_rel_sd": 0.25}  # fmt: skip
