"""EMPS: motor force and position of a carriage on a ball screw, as recordings."""

from __future__ import annotations

import numpy as np

from proof.real.public import Source
from torquerig.recordings.recording import Channel, Recording

FIT, HELD = "DATA_EMPS.mat", "DATA_EMPS_PULSES.mat"

SOURCE = Source(
    folder="emps",
    repository="forgi86/sysid-neural-continuous",
    revision="956aa7ecd73061b0321c6f6098d74c9e4a7ce67a",
    licence="open benchmark; the repository is Apache-2.0",
    cite="A. Janot, M. Gautier, M. Brunot, Data Set and Reference Models of EMPS, Workshop on Nonlinear System "
    "Identification Benchmarks, Eindhoven, 2019",
    paths={FIT: f"examples/EMPS/data/{FIT}", HELD: f"examples/EMPS/data/{HELD}"},
    sha256={
        FIT: "6cf6814ae14618795da0101aae2bb97ff0c6351b0501b5492751b02b07facf7e",
        HELD: "0eab75bb1f6b16228ee78791343a88bf9bfd9a51036ac9807d7b5fc11c0e1704",
    },
)


def recordings() -> tuple[Recording, ...]:
    """Return the two runs: force [N] = 35.15 N/V times the motor's command, and the carriage's position [m]."""
    return tuple(_recording(name) for name in (FIT, HELD))


def _recording(name: str) -> Recording:
    from scipy.io import loadmat

    data = {key: np.ravel(value) for key, value in loadmat(SOURCE.file(name)).items() if not key.startswith("__")}
    force = Channel(values=data["vir"].astype(float), quantity="force", unit="V", si_per_unit=float(data["gtau"][0]))
    position = Channel(values=data["qm"].astype(float), quantity="position", unit="m")
    return Recording(sample_rate=1000.0, channels={"command_V": force, "position_m": position}, name=name)
