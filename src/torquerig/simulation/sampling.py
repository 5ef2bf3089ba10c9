"""How a simulation is sampled where nothing else is stated: numbers alone, so that readers load no compiler."""

from __future__ import annotations

SAMPLE_RATE = 25_000.0  # [Hz] the rig's converter
SETTLING = 1.5  # [s] the rig turns this long before the recording starts
