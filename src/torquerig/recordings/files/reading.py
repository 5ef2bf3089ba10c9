"""Any recording file to a checked Recording: the format by its ending, the meaning by its sidecar or its names."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from torquerig.errors import InputError, RecordingError, did_you_mean
from torquerig.extensions import extensions
from torquerig.recordings.files.checks import check_finite, check_lengths
from torquerig.recordings.files.csv import read_csv
from torquerig.recordings.files.lvm import read_lvm
from torquerig.recordings.files.mat import read_mat
from torquerig.recordings.files.naming import sheet_by_name
from torquerig.recordings.files.parquet import read_parquet
from torquerig.recordings.files.sidecar import ChannelSheet, Sidecar, read_sidecar, sidecar_path
from torquerig.recordings.files.table import Table, time_among
from torquerig.recordings.files.tdms import read_tdms
from torquerig.recordings.files.text import read_text
from torquerig.recordings.files.timebase import sample_rate_of
from torquerig.recordings.files.wav import read_wav
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

READERS: dict[str, Callable[[Path], Table]] = {
    ".parquet": read_parquet,
    ".csv": read_csv,
    ".tsv": read_csv,
    ".txt": read_text,
    ".dat": read_text,
    ".mat": read_mat,
    ".tdms": read_tdms,
    ".lvm": read_lvm,
    ".wav": read_wav,
}


def readers() -> Mapping[str, Callable[[Path], Table]]:
    """Return the reader of each ending: the built-in ones, and those of other installed packages."""
    return READERS | {f".{name.lower()}": reader for name, reader in extensions("torquerig.readers").items()}


def read_recording(path: Path) -> Recording:
    """Read a recording, with its sidecar where there is one; all channels become float64.

    With ``channels`` in the sidecar, exactly these columns are read. Without, the columns' names tell quantity and
    unit, and a ``time_s`` column the rate.

    Raises
    ------
    InputError
        A missing file, an unknown ending, a sidecar that cannot be read.
    RecordingError
        A damaged file; no or one sample; channels of unequal length or other names than the sidecar's; samples that
        are no numbers; a rate that nothing states, or that two statements contradict.
    """
    path = Path(path)
    check_readable(path)
    reader = readers()[path.suffix.lower()]
    beside = sidecar_path(path)
    sidecar = read_sidecar(beside) if beside.is_file() else None
    table = reader(path)
    sheets = sheets_of(list(table.columns), table.units, sidecar, path)
    time = table.time_name()
    check_lengths({name: table.columns[name] for name in ([time] if time else []) + list(sheets)}, str(path))
    rate = sample_rate_of(table, sheets, sidecar=sidecar, where=str(path))
    channels = {
        name: Channel(
            values=table.columns[name],
            quantity=sheet.quantity,
            unit=sheet.unit,
            si_per_unit=sheet.si_per_unit,
            truth=sheet.truth,
        )
        for name, sheet in sheets.items()
    }
    return check_finite(
        Recording(
            sample_rate=rate,
            channels=channels,
            run=sidecar.run if sidecar else Run(),
            origin=sidecar.origin if sidecar else {},
            name=path.name,
        )
    )


def check_readable(path: Path) -> None:
    """Raise InputError for a missing file, a folder, a sidecar or an ending that is no format of a recording."""
    if path.is_dir():
        raise InputError(f"{path}: is a folder; name a recording in it")
    if not path.exists():
        near = [one.name for one in path.parent.iterdir() if one.suffix in readers()] if path.parent.is_dir() else []
        hint = did_you_mean(path.name, near[:20]) if near else "check the path"
        raise InputError(f"{path}: there is no such file; {hint}")
    ending = path.suffix.lower()
    if ending == ".yaml":
        raise InputError(f"{path}: is a sidecar; name the table beside it ({path.stem}.parquet, {path.stem}.csv, ...)")
    if ending not in readers():
        raise InputError(f"{path}: the ending {ending!r} is no format of a recording; read are {', '.join(readers())}")


def sheets_of(
    columns: Sequence[str], units: Mapping[str, str], sidecar: Sidecar | None, path: Path
) -> Mapping[str, ChannelSheet]:
    """Return what each channel means: what the sidecar says, else what the names of the columns but the time say."""
    time = time_among(columns)
    names = [name for name in columns if name != time]
    if sidecar is None or not sidecar.channels:
        if not names:
            raise RecordingError(f"{path}: there is no channel of numbers in it; add one, for example torque_V")
        return {name: sheet_by_name(name, unit=units.get(name), where=str(path)) for name in names}
    for name in sidecar.channels:
        if name not in names:
            raise RecordingError(
                f"{path}: there is no column {name!r}, which {sidecar.path.name} names; {did_you_mean(name, names)}"
            )
    return sidecar.channels
