"""What the tests of a diagnosis share: the wear rig, runs of it recorded at 5 kHz, and runs made by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

from tests.known_rigs import RATE, Record, bench, known_rig, record, wear_rig  # noqa: F401 (fixtures)
from torquerig.diagnosis.looking.observed import Observed, observed
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig


@pytest.fixture(scope="session")
def three_runs(record: Record) -> Callable[..., list[Recording]]:  # noqa: F811
    """Two speeds and a ramp: the least that tells orders, fixed lines and levels apart."""

    def made(rig: Rig, seed: int, **settings: Any) -> list[Recording]:
        plan = [(1000.0, "steady"), (700.0, "steady"), (1000.0, "ramp")]
        return [
            record(rig, 10 * seed + index, rpm=rpm, profile=profile, **settings)
            for index, (rpm, profile) in enumerate(plan)
        ]

    return made


@pytest.fixture(scope="session")
def by_hand() -> Callable[..., Observed]:
    """A run made of arrays: torque [V, 1 N m each], angle of the motor [rad]."""

    def made(torque: Sequence[float], angle: Sequence[float], *, rate: float = RATE, profile: str = "steady",
             name: str = "run", measured: bool = True) -> Observed:  # fmt: skip
        turned = np.asarray(angle, dtype=float)
        speed = float(np.abs(np.gradient(turned)).max() * rate)
        volts = Channel(values=np.asarray(torque, dtype=float), quantity="torque", unit="V")
        run = Run(speed=speed, gear_ratio=5.0, profile=profile)  # type: ignore[arg-type]
        recording = Recording(sample_rate=rate, channels={"torque_V": volts}, run=run, name=name)
        return observed(recording, ShaftAngle(turned, measured, "made by hand"), ratio=5.0)

    return made
