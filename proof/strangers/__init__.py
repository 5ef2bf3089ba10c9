"""Strangers: effects that no mechanism of the library describes, for the question of what a diagnosis says of them.

- ``stranger``   what all have in common: domain, axis, place and size
- ``lines``      locked to a shaft       - ``tones``  by time
- ``readings``   of the sensor and file  - ``structure``  of springs, friction and load
- ``draw``       a rig with one stranger
"""

from __future__ import annotations

from proof.strangers import lines, readings, structure, tones
from proof.strangers.stranger import Stranger


def _all() -> dict[str, type[Stranger]]:
    kinds = [one for module in (lines, tones, readings, structure) for one in vars(module).values()]
    found = [one for one in kinds if isinstance(one, type) and issubclass(one, Stranger) and one.kind]
    return {one.kind: one for one in found}


STRANGERS: dict[str, type[Stranger]] = _all()
"""Every stranger by its name."""
