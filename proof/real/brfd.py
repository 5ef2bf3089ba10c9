"""BRFD: displacement and force of a banded drum brake."""

from __future__ import annotations

import json

import numpy as np

from proof.real.public import Source
from torquerig.recordings.recording import Channel, Recording

_FOLDER = "data/dataset-3/characterization tests"
_NAMES = tuple(
    f"dataset-3/{name}amplitude.json"
    for name in ("0.5Hz30lbtension1", "0.5Hz30lbtension1.5", "1Hz30lbtension0.5", "0.25Hz30lbtension1")
)
FIT, HELD = _NAMES[0], _NAMES[1:]
INCH, KIP = 0.0254, 4448.2216  # [m], [N]

SOURCE = Source(
    folder="brfd-backlash",
    repository="ARTS-Laboratory/Dataset-Friction-Damper-with-Backlash",
    revision="0e09aa9d950760277e31c08cd93fd01f39a5af09",
    licence="CC BY-SA 4.0",
    cite="D. Coble, P. Huggins, L. Cao, J. Ricles, A. Downey, Dataset-Friction-Damper-with-Backlash, 2022",
    paths={name: f"{_FOLDER}/{name.split('/')[1]}" for name in _NAMES},
    sha256=dict(
        zip(
            _NAMES,
            (
                "e0af256cd576a7ae50db4e3210ced0b9c59cab75d36064e2b989c0ce27c2ecda",
                "7049f85c79556ff306a3babf78974efab38f41f945ce52a6cb33ec0163f4495c",
                "c7d61217aaa9b08def45c9baeccd8b0a9fb318c8a0c204b8314c42ff104556bb",
                "ba715dc17e8b5cb4cce6f87e43750e5207c7c112a8883d52d7e727b80dcd629a",
            ),
            strict=True,
        )
    ),
)


def recordings() -> tuple[Recording, ...]:
    """Return the run to fit and the three to hold out: friction force and displacement."""
    return tuple(_recording(name) for name in _NAMES)


def _recording(name: str) -> Recording:
    data = np.array(json.loads(SOURCE.file(name).read_text(encoding="utf-8"))["data"])
    channels = {
        "force_kip": Channel(values=data[:, 2], quantity="force", unit="kip", si_per_unit=KIP),
        "displacement_in": Channel(values=data[:, 1], quantity="position", unit="in", si_per_unit=INCH),
    }
    return Recording(sample_rate=1024.0, channels=channels, name=name)
