"""Dry friction that its smoothing hides is named."""

from __future__ import annotations

from math import pi, tanh

import pytest

from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Motor, SpeedController
from torquerig.simulation.simulator import simulate

SMOOTHING = 0.5


def warnings_at(speed: float) -> list[str]:
    rig = Rig(
        (
            Motor(name="motor", inertia=1e-3, torque_limit=50.0),
            Coupling(name="shaft", after="motor", stiffness=500.0, damping=0.5),
            Body(name="drum", after="shaft", inertia=1e-3, coulomb=0.2, smoothing=SMOOTHING),
            SpeedController(name="loop", motor="motor", kp=0.5, ki=5.0),
        ),
        Run(speed=speed), measured="shaft",
    )  # fmt: skip
    recording = simulate(rig, duration=0.2, seed=1, sample_rate=5000.0, settling=3.0)
    return [one for one in recording.origin.get("warnings", []) if "smoothing" in one]


@pytest.mark.parametrize("speed", [0.1, -0.1])
def test_a_slow_shaft_has_the_share_of_the_formula(speed: float) -> None:
    (sentence,) = warnings_at(speed)
    assert f"{100 * tanh(0.1 / SMOOTHING):.2g} % of the work of its 0.2 N*m" in sentence
    assert "smoothed over 0.5 rad/s" in sentence


@pytest.mark.parametrize("speed", [0.0, 2 * pi])
def test_rest_and_fast_shafts_are_not_named(speed: float) -> None:
    assert not warnings_at(speed)
