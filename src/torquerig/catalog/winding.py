"""The pole pairs and slots of a catalog motor, from which its order lines follow."""

from __future__ import annotations

from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import nominal


def winding_of(motor: Motor) -> tuple[int | None, int | None, str]:
    """Return pole pairs and slots, the likeliest where they are not documented, and the assumptions in words."""
    sample = nominal(motor)
    counts = {key: sample.count(key) if key in sample.values else None for key in ("pole_pairs", "slots")}
    words = [
        f"{key.replace('_', ' ')} {count} of {sample.assumed[key].known}"
        for key, count in counts.items()
        if key in sample.assumed
    ]
    return counts["pole_pairs"], counts["slots"], ", ".join(words)
