"""Moved rigs of the tests' own: a carriage by its own equations, and a motor that is turned."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.recordings.recording import Channel, Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

Floats = NDArray[np.float64]
Extra = Callable[[Floats, Floats, Floats], Floats]

RATE, COUNT, MASS = 400.0, 4800, 10.0
CARRIAGE = """
operating_point: {}
measured: motion
rig:
  carriage: {kind: slide, mass: {value: 11.5 kg, rel_sd: 0.1}}
  motion: {kind: imposed_motion, at: carriage, channel: position}
"""
ROTOR = """
operating_point: {}
measured: motion
rig:
  motor: {kind: motor, inertia: 1.0e-4 kg*m^2, torque_limit: 1 N*m, pole_pairs: 7, slots: 12}
  motion: {kind: imposed_motion, at: motor, channel: angle}
"""


def scenario(text: str) -> Scenario:
    return read_scenario(parse_document(text, Path("rig.yaml")), Catalog(), seed=0)


def recorded(extra: Extra, *, name: str = "run.csv") -> Recording:
    """Two swings that do not meet: M a + extra(time, position, speed), noise of 0.5 N, of some 40 N."""
    time = np.arange(COUNT) / RATE
    swings = ((0.1, 2 * np.pi * 0.5, 0.0), (0.02, 2 * np.pi * 1.3, 1.0))
    position = sum(a * np.sin(w * time + p) for a, w, p in swings)
    speed = sum(a * w * np.cos(w * time + p) for a, w, p in swings)
    gained = sum(-a * w**2 * np.sin(w * time + p) for a, w, p in swings)
    noise = 0.5 * np.random.default_rng(7).standard_normal(COUNT)
    force = MASS * gained + extra(time, np.asarray(position), np.asarray(speed)) + noise
    channels = {
        "force_N": Channel(values=force, quantity="force", unit="N"),
        "position_m": Channel(values=np.asarray(position), quantity="position", unit="m"),
    }
    return Recording(sample_rate=RATE, channels=channels, name=name)
