"""Writing of a recording's sidecar as YAML text that reads back to the same floats."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import yaml

from torquerig.recordings.files.scale import written_scale
from torquerig.recordings.files.set_point_text import set_point_entry
from torquerig.recordings.files.sidecar_schema import IN_OTHERS
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.units import UNITS

SIDECAR_KEY = "torquerig_sidecar"
"""The name under which a Parquet, TDMS or .mat file holds its sidecar, so that it opens without the other file."""


class _Dumper(yaml.SafeDumper):
    """PyYAML's safe dumper that also quotes strings that are numbers only in YAML 1.2 (``1e5``)."""


_Dumper.add_implicit_resolver(
    "tag:yaml.org,2002:float", re.compile(r"^[-+]?(?:\.\d+|\d+(?:\.\d*)?)(?:[eE][-+]?\d+)?$"), list("-+0123456789.")
)


def sidecar_text(recording: Recording) -> str:
    """Return the sidecar of a recording: rate, channels with their scale, run and origin."""
    content: dict[str, Any] = {
        "sample_rate_Hz": _number(recording.sample_rate),
        "channels": {name: _channel_entry(channel) for name, channel in recording.channels.items()},
    }
    run = recording.run
    if "teeth" in run.others:
        content["teeth"] = _plain(run.others["teeth"])
        run = replace(run, others={key: value for key, value in run.others.items() if key != "teeth"})
    if run != Run():
        content["run"] = _run_entry(run)
    if recording.origin:
        content["origin"] = _plain(recording.origin)
    return yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1000)


def _channel_entry(channel: Channel) -> dict[str, Any]:
    scale = {key: _number(value) for key, value in written_scale(channel).items()}
    stated = {"truth": channel.truth, "of": channel.of, "role": channel.role, "tare": channel.tare}
    return {
        "quantity": channel.quantity, "unit": channel.unit, **scale,
        **{key: value for key, value in stated.items() if value},
    }  # fmt: skip


def _run_entry(run: Run) -> dict[str, Any]:
    entry = {
        "motor": run.motor,
        "gear_ratio": None if run.gear_ratio is None else _number(run.gear_ratio),
        "travel_per_turn_mm": None
        if run.travel_per_turn is None
        else _counted_in(run.travel_per_turn, UNITS["length"]["mm"]),
        "speed_rpm": None if run.speed is None else _counted_in(run.speed, UNITS["speed"]["rpm"]),
        "profile": run.profile,
        "set_point": set_point_entry(run),
        "occupancy_percent": None if run.occupancy_percent is None else _number(run.occupancy_percent),
        "particle_size_mm": None
        if run.particle_size is None
        else _counted_in(run.particle_size, UNITS["length"]["mm"]),
    }
    own = {key: value for key, value in run.others.items() if key in IN_OTHERS}
    further = {key: value for key, value in run.others.items() if key not in IN_OTHERS}
    entry |= {**_plain(own), "others": _plain(further) if further else None}
    return {key: value for key, value in entry.items() if value is not None}


def _counted_in(value: float, factor: float) -> float:
    """Return the shortest number that, multiplied by ``factor``, is ``value``: 1000 rpm, not 999.9999999999999."""
    for digits in range(1, 18):
        candidate = float(f"{value / factor:.{digits}g}")
        if candidate * factor == value:
            return _number(candidate)
    return value / factor


def _number(value: float) -> float:
    plain = float(value)
    return int(plain) if plain.is_integer() and abs(plain) < 1e15 else plain


def _plain(value: Any) -> Any:
    """Return ``value`` in the data types of YAML."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    return value if value is None or isinstance(value, bool | int | float | str) else str(value)
