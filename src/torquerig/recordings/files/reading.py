"""Read any recording file into a checked Recording: format from its ending, channels from sidecar or column names."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path

from torquerig.errors import InputError, RecordingError, did_you_mean
from torquerig.extensions import extensions
from torquerig.recordings.files.checks import check_finite, check_lengths
from torquerig.recordings.files.csv import read_csv
from torquerig.recordings.files.gz import TEXT_ENDINGS, read_gz
from torquerig.recordings.files.hdf5 import read_hdf5
from torquerig.recordings.files.lvm import read_lvm
from torquerig.recordings.files.mat import read_mat
from torquerig.recordings.files.mdf import read_mdf
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.other_formats import export_for, other_content
from torquerig.recordings.files.parquet import read_parquet
from torquerig.recordings.files.plain_names import with_plain_names
from torquerig.recordings.files.sidecar import ChannelEntry, Sidecar
from torquerig.recordings.files.sidecar_choice import sidecar_of
from torquerig.recordings.files.starts import refuse_late_starts, remedy_for_lengths
from torquerig.recordings.files.tdms import read_tdms
from torquerig.recordings.files.timebase import refuse_two_rates, sample_rate_of
from torquerig.recordings.files.wav import read_wav
from torquerig.recordings.files.xlsx import read_xlsx
from torquerig.recordings.names.interpretation import interpret
from torquerig.recordings.names.time_column import time_column
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run

TEXT_READERS: dict[str, Callable[[Path, Collection[str]], Table]] = {
    **dict.fromkeys(TEXT_ENDINGS, read_csv),
    ".gz": read_gz,
    ".xlsx": read_xlsx,
}
"""Readers that can read some columns alone, so that a faulty cell in another column does not matter."""

READERS: dict[str, Callable[[Path], Table]] = {
    ".parquet": read_parquet,
    **dict.fromkeys(TEXT_ENDINGS, read_csv),
    ".gz": read_gz,
    ".xlsx": read_xlsx,
    ".mat": read_mat,
    ".tdms": read_tdms,
    ".lvm": read_lvm,
    ".wav": read_wav,
    **dict.fromkeys((".h5", ".hdf5", ".hdf"), read_hdf5),
    **dict.fromkeys((".mf4", ".mdf"), read_mdf),
}


def readers() -> Mapping[str, Callable[[Path], Table]]:
    """Return the reader of each ending: the built-in ones, and those of other installed packages."""
    return READERS | {f".{name.lower()}": reader for name, reader in extensions("torquerig.readers").items()}


def read_recording(path: Path) -> Recording:
    """Read a recording, with its sidecar where there is one; all channels become float64.

    With ``channels`` in the sidecar, exactly these columns are read. Without it, the columns' names determine quantity
    and unit, and a ``time_s`` column the rate.

    Raises
    ------
    InputError
        A missing file, an unknown ending, a sidecar that cannot be read.
    RecordingError
        A damaged file; no or one sample; channels of unequal length or with other names than the sidecar's; samples
        that are not numbers; a missing rate, or two rates that contradict each other.
    """
    path = Path(path)
    check_readable(path)
    sidecar, table = _described(path)
    entries = channel_entries(list(table.columns), table.units, sidecar, path)
    time = table.time_name()
    refuse_two_rates(table.rates, entries, where=str(path))
    refuse_late_starts(table.starts, table.rates, entries, where=str(path))
    used = {name: table.columns[name] for name in ([time] if time else []) + list(entries)}
    check_lengths(used, str(path), remedy=remedy_for_lengths(table.rates, used, where=str(path)))
    rate = sample_rate_of(table, entries, sidecar=sidecar, where=str(path))
    channels = {name: entry.channel(table.columns[name]) for name, entry in entries.items()}
    return check_finite(
        Recording(
            sample_rate=rate,
            channels=channels,
            run=sidecar.run if sidecar else Run(),
            origin=sidecar.origin if sidecar else {},
            name=path.name,
            path=path,
        )
    )


def _described(path: Path) -> tuple[Sidecar | None, Table]:
    """Return the sidecar and the table; of a text only the columns that the sidecar names need to be sound."""
    if path.suffix.lower() in TEXT_READERS:
        sidecar, _ = sidecar_of(path, lambda: list(_table(path, ()).columns))
        table = _table(path, sidecar.channels if sidecar else ())
    else:
        table = _table(path, ())
        sidecar, _ = sidecar_of(path, lambda: list(table.columns), embedded=table.sidecar)
    return sidecar, with_plain_names(table, kept=sidecar.channels if sidecar else ())


def _table(path: Path, only: Collection[str]) -> Table:
    ending = path.suffix.lower()
    if ending in TEXT_READERS:
        return TEXT_READERS[ending](path, only)
    return readers()[ending](path)


def check_readable(path: Path) -> None:
    """Raise InputError for a missing file, a folder, a sidecar, and an ending of no known or of another format."""
    if path.is_dir():
        raise InputError(f"{path}: is a folder; name a recording in it")
    if not path.exists():
        near = [one.name for one in path.parent.iterdir() if one.suffix in readers()] if path.parent.is_dir() else []
        hint = did_you_mean(path.name, near[:20]) if near else "check the path"
        raise InputError(f"{path}: there is no such file; {hint}")
    ending = path.suffix.lower()
    if ending == ".yaml":
        raise InputError(f"{path}: is a sidecar; name its table file ({path.stem}.parquet, {path.stem}.csv, ...)")
    content = "" if ending in readers().keys() - READERS.keys() else other_content(path)
    if content:
        raise InputError(f"{path}: {content}")
    if ending not in readers():
        export = export_for(ending)
        if export:
            raise InputError(f"{path}: the format {ending} is not read; {export}")
        raise InputError(
            f"{path}: the ending {ending!r} is no known format of a recording; readable are {', '.join(readers())}"
        )


def channel_entries(
    columns: Sequence[str], units: Mapping[str, str], sidecar: Sidecar | None, path: Path
) -> Mapping[str, ChannelEntry]:
    """Return the entry of each channel but the time: from the sidecar, else from the columns' names and units."""
    time = time_column(columns, units)
    names = [name for name in columns if time is None or name != time.name]
    if sidecar is None or not sidecar.channels:
        if not names:
            raise RecordingError(f"{path}: there is no channel of numbers in it; add one, for example torque_V")
        return {name: entry_by_name(name, units.get(name)) for name in names}
    for name in sidecar.channels:
        if name not in names:
            raise RecordingError(
                f"{path}: there is no column {name!r}, which {sidecar.path.name} names; {did_you_mean(name, names)}"
            )
    return sidecar.channels


def entry_by_name(name: str, unit: str | None) -> ChannelEntry:
    """Return what a column without a sidecar is; ``other`` where its name and unit do not determine it."""
    found = interpret(name, unit)
    return ChannelEntry(
        quantity=found.quantity,
        unit=found.unit,
        si_per_unit=found.si_per_unit,
        reason=found.reason,
        missing=found.missing,
    )
