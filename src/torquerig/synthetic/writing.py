"""Writing of a synthetic recording, with the times that its faults gave to its rows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from torquerig.errors import InputError
from torquerig.recordings.files.csv import append_csv, write_header
from torquerig.recordings.files.sidecar_choice import sidecar_target
from torquerig.recordings.files.sidecar_text import sidecar_text
from torquerig.recordings.files.writing import check_target, refuse_names, write_recording
from torquerig.recordings.recording import Recording
from torquerig.schema_comment import schema_comment
from torquerig.synthetic.faults.measured import STAMPS
from torquerig.synthetic.faults.registry import BY_NAME
from torquerig.whole_file import whole_files


def refuse_without_times(recording: Recording, path: Path) -> None:
    """Raise InputError where a fault of the times cannot be written to ``path``."""
    for fault in recording.origin.get("faults", ()):
        if BY_NAME[fault["type"]].needs_times and path.suffix.lower() != ".csv":
            raise InputError(
                f"{path}: {fault['type']} is a fault of the column of times, which synth writes to .csv alone; "
                f"write --out {path.with_suffix('.csv')}"
            )


def write_synthetic(recording: Recording, path: Path, *, overwrite: bool = False) -> list[Path]:
    """Write a recording and its sidecar; return their paths.

    In a CSV the column of times holds the stamps that a fault gave to the rows. Where a fault disturbs the stamps
    themselves, the sidecar does not state the rate, so that the stamps alone tell it.

    Raises
    ------
    InputError
        As ``recordings.files.write_recording``; a fault of the times in a format that synth writes without them.
    """
    refuse_without_times(recording, path)
    stamps = recording.channels.get(STAMPS)
    plain = replace(recording, channels={name: one for name, one in recording.channels.items() if name != STAMPS})
    if stamps is None or path.suffix.lower() != ".csv":
        return write_recording(plain, path, overwrite=overwrite)
    check_target(path, overwrite=overwrite)
    refuse_names(plain, path)
    text = sidecar_text(plain)
    if any(BY_NAME[fault["type"]].needs_times for fault in plain.origin["faults"]):
        # the sidecar's first line states the rate
        text = text.partition("\n")[2]
    sidecar = sidecar_target(path)
    with whole_files([path, sidecar]) as (partial, partial_sidecar):
        with partial.open("wb") as file:
            write_header(file, plain)
            append_csv(file, {name: one.values for name, one in plain.channels.items()}, times=stamps.values)
        partial_sidecar.write_bytes((schema_comment(sidecar, "sidecar") + text).encode())
    return [path, sidecar]
