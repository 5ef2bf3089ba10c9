"""Writing of a recording: a Parquet table and a sidecar of the same name with the test conditions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import yaml

from proof.rig_program import nominal
from proof.rig_program.plan import Run
from proof.rig_program.recorded import Recording


def write_recording(recording: Recording, path: Path, *, run: Run, with_encoder: bool) -> None:
    """Write ``path`` (.parquet) and its sidecar, without an encoder column if the rig has none."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    columns: dict[str, Any] = {"torque_V": pa.array(recording.torque.astype(np.float32))}
    if with_encoder:
        columns["encoder_count"] = pa.array(recording.encoder)
    path.parent.mkdir(parents=True, exist_ok=True)
    pq.write_table(pa.table(columns), path)
    text = yaml.safe_dump(sidecar(run, with_encoder=with_encoder), sort_keys=False)
    path.with_suffix(".yaml").write_text(text, encoding="utf-8")


def sidecar(run: Run, *, with_encoder: bool) -> dict[str, Any]:
    """Return the test conditions of a run: channels and set-points, no true values."""
    channels: dict[str, Any] = {"torque_V": {"quantity": "torque", "unit": "V", "Nm_per_V": 1.0}}
    if with_encoder:
        counts = nominal.ENCODER_COUNTS
        channels["encoder_count"] = {"quantity": "motor_angle", "unit": "count", "counts_per_rev": counts}
    return {
        "sample_rate_Hz": round(nominal.SAMPLE_RATE),
        "channels": channels,
        "run": {
            "motor": "bldc-12n14p",
            "gear_ratio": round(nominal.RATIO),
            "speed_rpm": run.speed,
            "profile": run.profile.value,
            "occupancy_percent": run.occupancy,
            "particle_size_mm": run.particle,
        },
    }
