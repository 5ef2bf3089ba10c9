"""The signal that a fault is drawn into where no other one is named: a steady drive with a load, lines and noise."""

from __future__ import annotations

from math import pi

from torquerig.synthetic.mixture import Mixture

RPM = pi / 30


def base_signal(*, duration: float = 12.0, sample_rate: float = 5_000.0, seed: int = 1) -> Mixture:
    """Return a mixture without faults: a load of 1 N m that wanders by 5 %, orders 1, 4 and 12, noise, an encoder.

    Parameters
    ----------
    duration : float
        [s].
    sample_rate : float
        [Hz].
    seed : int
        Random seed.
    """
    components = {
        "mean": {"type": "constant", "part": "load", "torque": "1 N*m"},
        "slow": {"type": "coloured_noise", "part": "load", "rms": "0.05 N*m", "cutoff": "2 Hz"},
        "order_1": {"type": "order_line", "order": 1, "amplitude": "50 mN*m"},
        "order_4": {"type": "order_line", "order": 4, "amplitude": "30 mN*m", "phase": "1 rad"},
        "order_12": {"type": "order_line", "order": 12, "amplitude": "20 mN*m", "phase": "2 rad"},
        "sensor": {"type": "coloured_noise", "rms": "10 mN*m", "cutoff": f"{0.3 * sample_rate!r} Hz"},
    }
    described = {
        "synthetic": "base signal", "duration": f"{duration!r} s", "sample_rate": f"{sample_rate!r} Hz", "seed": seed,
        "motor": "bldc-12n14p", "gear_ratio": 5, "motor_speed": f"{600 * RPM!r} rad/s", "counts_per_rev": 4096,
        "components": components,
    }  # fmt: skip
    return Mixture.model_validate(described)
