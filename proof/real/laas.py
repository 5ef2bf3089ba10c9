"""LAAS: current and position of a motor that is turned a step at a time, one turn forward and one back."""

from __future__ import annotations

import numpy as np

from proof.real.public import Source
from torquerig.recordings.recording import Channel, Recording

MAPPING = "mapping_stopped_data.txt"
FIT, HELD = "forward", "backward"
TORQUE_CONSTANT = 60 / (2 * np.pi * 300)  # [N m/A] of a motor of 300 rpm/V
_STEPS_PER_SECOND = 20.0  # [1/s] a step about every 50 ms, with standstill in between
_SETTLING = 20  # steps until the controller has reversed

SOURCE = Source(
    folder="laas-cogging",
    repository="heitor-andrade/laas_anti_cogging",
    revision="eb0391d736f1aaaf6cb0c72ea5a9b5c1350284c4",
    licence="BSD-3-Clause",
    cite="H. Andrade, laas_anti_cogging, LAAS-CNRS, 2023",
    paths={MAPPING: "codes/Mapping/stopped_data/stopped_data.txt"},
    sha256={MAPPING: "3a72c809e100194a660777f66addb2c081d061fbe8df542c1af4a6944d8ca3cb"},
)


def recordings() -> tuple[Recording, ...]:
    """Return the turn forward and the turn back, each point of standstill as a sample of a slow, even turn."""
    data = np.loadtxt(SOURCE.file(MAPPING), delimiter=",", skiprows=1)
    top = int(np.argmax(data[:, 1]))
    return _recording(data[:top], FIT), _recording(data[top + _SETTLING :], HELD)


def _recording(data: np.ndarray, name: str) -> Recording:
    channels = {
        "current_A": Channel(values=data[:, 3], quantity="motor_torque", unit="A", si_per_unit=TORQUE_CONSTANT),
        "angle_rad": Channel(values=data[:, 1], quantity="motor_angle", unit="rad"),
    }
    return Recording(sample_rate=_STEPS_PER_SECOND, channels=channels, name=name)
