"""Write a Recording to a table file and its sidecar: both complete, or neither; overwriting only on request."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from torquerig.errors import InputError
from torquerig.harmless import csv_cell
from torquerig.recordings.files.checks import check_finite, check_lengths
from torquerig.recordings.files.csv import write_csv
from torquerig.recordings.files.mat import refuse_variable_names, write_mat
from torquerig.recordings.files.parquet import write_parquet
from torquerig.recordings.files.sidecar import read_sidecar
from torquerig.recordings.files.sidecar_choice import find_sidecar, sidecar_target
from torquerig.recordings.files.sidecar_text import sidecar_text
from torquerig.recordings.files.tdms import write_tdms
from torquerig.recordings.names.time_column import time_column
from torquerig.recordings.recording import Recording
from torquerig.schema_comment import schema_comment
from torquerig.whole_file import refuse_unwritable, whole_files

WRITERS: Mapping[str, Callable[[Recording, Path], None]] = {
    ".parquet": write_parquet,
    ".csv": write_csv,
    ".mat": write_mat,
    ".tdms": write_tdms,
}


def write_recording(recording: Recording, path: Path, *, overwrite: bool = False) -> list[Path]:
    """Write a recording and its sidecar; return the two paths. The same recording gives the same bytes.

    Both are first written under another name in the same folder and then renamed, so that an interruption leaves no
    incomplete file.

    Raises
    ------
    InputError
        An ending that cannot be written, a missing folder, a channel named like the time, a file that exists (with
        ``overwrite``: a file in the sidecar's place that is no sidecar).
    RecordingError
        A recording that could not be read back: no samples, unequal lengths, samples that are not numbers.
    """
    path = Path(path)
    write = _writer_of(path)
    _refuse_overwriting(path, sidecar_target(path), overwrite=overwrite)
    refuse_names(recording, path)
    check_lengths({name: channel.values for name, channel in recording.channels.items()}, str(path))
    check_finite(recording)
    return put_in_place(lambda partial: write(recording, partial), recording, path, overwrite=overwrite)


def put_in_place(
    write: Callable[[Path], None], recording: Recording, path: Path, *, overwrite: bool = False
) -> list[Path]:
    """Write the table by ``write`` and the sidecar under other names, then rename both; return their paths.

    Raises
    ------
    InputError
        As :func:`write_recording`, before anything is written.
    """
    check_target(path, overwrite=overwrite)
    sidecar = sidecar_target(path)
    with whole_files([path, sidecar]) as (partial, partial_sidecar):
        write(partial)
        partial_sidecar.write_bytes((schema_comment(sidecar, "sidecar") + sidecar_text(recording)).encode())
    return [path, sidecar]


def check_target(path: Path, *, overwrite: bool = False, inputs: Iterable[Path] = ()) -> None:
    """Raise the InputError that writing to ``path`` would raise; called before a long run.

    Parameters
    ----------
    inputs : iterable of Path
        Recordings that are read; neither they nor their sidecars are ever replaced.
    """
    _writer_of(path)
    for read in inputs:
        for target in (path, sidecar_target(path)):
            for what, source in (("the input", read), (f"the sidecar of the input {read}", find_sidecar(read))):
                if source is not None and target.exists() and source.exists() and target.samefile(source):
                    raise InputError(f"{target}: is {what}; choose another name to write to")
    _refuse_overwriting(path, sidecar_target(path), overwrite=overwrite)
    refuse_unwritable(path)


def _writer_of(path: Path) -> Callable[[Recording, Path], None]:
    ending = path.suffix.lower()
    if ending not in WRITERS:
        raise InputError(f"{path}: the ending {ending!r} cannot be written; use {', '.join(WRITERS)}")
    if not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    return WRITERS[ending]


def refuse_names(recording: Recording, path: Path) -> None:
    """Raise InputError for a channel named like the time, or one whose name cannot be written."""
    for name in recording.channels:
        if time_column([name]) is not None or name.strip().lower() == "sample_rate_hz":
            raise InputError(f"{path}: {name!r} names the time or its rate, not a channel; rename the channel")
        if not name.strip() or not name.isprintable():
            raise InputError(f"{path}: {name!r} cannot name a channel; use letters, digits and _")
        if path.suffix.lower() == ".csv" and name != csv_cell(name):
            raise InputError(f"{path}: a spreadsheet would take the name {name!r} for a formula; write .parquet, or "
                             f"rename the channel")  # fmt: skip
    if path.suffix.lower() == ".mat":
        refuse_variable_names(recording.channels, path)


def _refuse_overwriting(path: Path, sidecar: Path, *, overwrite: bool) -> None:
    for one in (path, sidecar):
        if one.exists() and not overwrite:
            raise InputError(f"{one}: is there already; choose another name, or overwrite it with --force")
    if sidecar.exists():
        try:
            read_sidecar(sidecar)
        except InputError:
            raise InputError(
                f"{sidecar}: is there already and is no sidecar of a recording; choose another name for {path.name}"
            ) from None
