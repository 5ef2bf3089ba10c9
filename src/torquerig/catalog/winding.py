"""The pole pairs and slots of a catalog motor, from which its order lines follow."""

from __future__ import annotations

from torquerig.catalog.drawing import nominal
from torquerig.catalog.motor import Motor


def winding_of(motor: Motor) -> tuple[int | None, int | None, str]:
    """Return pole pairs and slots, the likeliest where they are not documented, and what was assumed in words."""
    copy = nominal(motor)
    counts = {key: copy.count(key) if key in copy.values else None for key in ("pole_pairs", "slots")}
    words = [
        f"{key.replace('_', ' ')} {count} of {copy.assumed[key].known}"
        for key, count in counts.items()
        if key in copy.assumed
    ]
    return counts["pole_pairs"], counts["slots"], ", ".join(words)
