"""Dry friction with a Stribeck peak at the body of the load, with the rest law of the rig."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.setting import Setting
from proof.fleet.train import Train


@dataclass(frozen=True)
class StribeckFriction(Effect):
    """Coulomb and static torque [N m], Stribeck speed [rad/s]; ``backward`` is the factor of the other direction."""

    kind: ClassVar[str] = "stribeck_friction"
    coulomb: float
    static: float
    speed: float
    backward: float

    def parameters(self) -> dict[str, float | None]:
        """Return the parameters; by direction where these differ."""
        plain: dict[str, float | None] = {
            "coulomb_Nm": self.coulomb,
            "static_Nm": self.static,
            "stribeck_rad_s": self.speed,
        }
        if self.backward == 1.0:
            return plain
        back = {"coulomb_Nm": self.coulomb * self.backward, "static_Nm": self.static * self.backward,
                "stribeck_rad_s": self.speed}  # fmt: skip
        return {f"{k}_forward": v for k, v in plain.items()} | {f"{k}_backward": v for k, v in back.items()}

    def places(self) -> tuple[Place, ...]:
        """Return the level and the low speeds."""
        return (Place("level", "V", 0.0, 1.0), Place("speed", "rpm", 0.0, 1.0))

    def on_train(self, train: Train) -> Train:
        """Add the friction of both directions."""
        directions = np.array([1.0, self.backward])
        return train._replace(dry=train.dry + self.coulomb * directions, stribeck_speed=self.speed,
                              peak=train.peak + (self.static - self.coulomb) * directions)  # fmt: skip


def draw_stribeck_friction(rng: np.random.Generator, setting: Setting) -> StribeckFriction | None:
    """Draw friction of 3 to 50 % of the rated torque; it needs a run that passes low speeds."""
    runs = setting.rig.runs
    if not any(run.profile in ("ramp", "reversal") for run in runs):
        return None
    coulomb = setting.torque * float(10.0 ** rng.uniform(-1.5, -0.3))
    slowest = min(run.speed for run in runs) / abs(setting.rig.design.ratio)
    reverses = any(run.profile == "reversal" for run in runs)
    return StribeckFriction(
        part=setting.rig.design.body, coulomb=coulomb, static=coulomb * float(rng.uniform(1.3, 3.0)),
        speed=slowest * float(rng.uniform(0.03, 0.25)),
        backward=float(rng.choice([1.0, rng.uniform(0.6, 1.5)])) if reverses else 1.0,
    )  # fmt: skip
