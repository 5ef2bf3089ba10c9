"""A rig with one stranger whose size counts."""

from __future__ import annotations

import numpy as np

from proof.fleet.draw import RIGS, FleetCase, NoRigError, with_effects
from proof.fleet.rig import draw_rig
from proof.fleet.setting import setting_of
from proof.strangers import STRANGERS


def stranger_case(name: str, seed: tuple[int, ...], kind: str) -> FleetCase:
    """Draw a rig that can have the stranger, with it."""
    rng = np.random.default_rng([*seed, 22])
    for attempt in range(RIGS):
        rig = draw_rig(name, (*seed, attempt))
        setting = setting_of(rig)
        if STRANGERS[kind].draw(np.random.default_rng(0), setting) is not None:
            return with_effects(rig, setting, [STRANGERS[kind].draw], rng)
    raise NoRigError(f"{name}: none of {RIGS} drawn rigs can have {kind}")
