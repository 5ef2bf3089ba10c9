"""What would the diagnosis say if its library held fewer effects? The contract's classes taken out for a while."""

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
"""Every mechanism of the contract, and the class of the library that is its file."""


@contextmanager
def library_of(kept: Collection[str]) -> Iterator[None]:
    """Leave only these mechanisms of the contract in the library, as if the files of the others were deleted.

    The diagnosis takes a class that is not in ``torquerig.mechanisms`` for one that is in no library. It is put back
    at the end. For this process alone, and not beside another diagnosis of the same process.
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
