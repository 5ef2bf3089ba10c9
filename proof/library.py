"""A reduced library of mechanisms for a diagnosis."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager

from torquerig import mechanisms

CLASSES = {
    name: "".join(word.capitalize() for word in name.split("_"))
    for name in (
        "gear_mesh", "commutation_ripple", "torsional_mode", "backlash", "stribeck_friction", "bearing_defect",
        "mains_interference", "sensor_bandwidth", "sensor_drift", "clipping", "quantization", "pwm_aliasing",
        "blade_pass", "quadratic_drag", "signal_dropout", "cogging",
    )
}  # fmt: skip
"""Class of the library for every mechanism of the contract."""


@contextmanager
def library_of(kept: Collection[str]) -> Iterator[None]:
    """Hide all mechanisms of the contract but ``kept``, as if their files were deleted.

    The diagnosis ignores classes that are missing in ``torquerig.mechanisms``. They are restored at the end. The change
    is local to the process, which must not run another diagnosis at the same time.
    """
    hidden = {
        one: getattr(mechanisms, one)
        for name, one in CLASSES.items()
        if name not in kept and hasattr(mechanisms, one)
    }  # fmt: skip
    try:
        for name in hidden:
            delattr(mechanisms, name)
        yield
    finally:
        for name, one in hidden.items():
            setattr(mechanisms, name, one)
