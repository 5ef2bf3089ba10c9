"""MATLAB .mat of every version: vectors, columns of matrices, fields of structs, labelled signals of scopes."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.matlab.channels import Channels, channels_of
from torquerig.recordings.files.matlab.headers import with_headers
from torquerig.recordings.files.matlab.leaves import leaves_of
from torquerig.recordings.files.matlab.tables import with_tables
from torquerig.recordings.files.matlab.tree import Variables
from torquerig.recordings.files.matlab.version4 import is_v4, variables_v4
from torquerig.recordings.files.matlab.version5 import DamagedError, variables_v5
from torquerig.recordings.files.matlab.version73 import variables_v73
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.sidecar_text import SIDECAR_KEY, sidecar_text
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces, pieces_of
from torquerig.recordings.recording import Recording

# what h5py raises for damaged files
_BROKEN = (ValueError, TypeError, OSError, EOFError, LookupError, NotImplementedError, RuntimeError, struct.error)
_REMEDY = "save the channels as vectors, for example save('run1.mat', 'time_s', 'torque_V')"
# the first 116 bytes of a v5 file are free text, where scipy writes the date
_TITLE_LENGTH = 116


def read_mat(path: Path) -> Table:
    """Read every vector of numbers, and the columns of a matrix; a scalar ``fs`` or ``sample_rate_Hz`` is the rate.

    The fields of a struct count as variables. Where structs have times of their own, each field has the rate of its
    struct. A single matrix of two columns is the bare table of time and volts.

    Raises
    ------
    RecordingError
        When the file is damaged, or holds no vector of numbers.
    """
    found, sidecar = _channels(path)
    columns = {}
    for name, channel in found.channels.items():
        try:
            columns[name] = channel.read(0, channel.numbers.samples)
        except _BROKEN as error:
            raise _not_whole(path, error) from None
    return Table(
        columns=columns,
        rates=found.rates,
        units=found.units,
        skipped=found.skipped,
        notes=found.notes,
        sidecar=sidecar,
        starts=found.starts,
    )


def mat_pieces(path: Path) -> TablePieces:
    """Return a v7.3 file in pieces; an older one is read at once, because each of its variables is compressed."""
    import h5py

    if not h5py.is_hdf5(path):
        return pieces_of(
            read_mat(path), reason="a .mat file before v7.3 is read whole; save it with -v7.3, or as TDMS or Parquet"
        )
    found, sidecar = _channels(path)

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        channels = {name: found.channels[name] for name in names}
        try:
            for first in range(0, max((one.numbers.samples for one in channels.values()), default=0), PIECE):
                yield {name: one.read(first, first + PIECE) for name, one in channels.items()}
        except _BROKEN as error:
            raise _not_whole(path, error) from None

    return TablePieces(
        names=tuple(found.channels),
        lengths={name: channel.numbers.samples for name, channel in found.channels.items()},
        pieces=pieces,
        rates=found.rates,
        units=found.units,
        skipped=found.skipped,
        notes=found.notes,
        starts=found.starts,
        sidecar=sidecar,
    )


def _channels(path: Path) -> tuple[Channels, str]:
    """Return the channels of a file, and the sidecar that torquerig wrote into it."""
    try:
        variables = dict(_variables(path))
        sidecar = variables.pop(SIDECAR_KEY, "")
        leaves = with_headers(leaves_of(with_tables(variables, path)), where=str(path))
        found = channels_of(leaves, where=str(path), remedy=_REMEDY)
        return found, sidecar if isinstance(sidecar, str) else ""
    except (DamagedError, *_BROKEN) as error:
        raise _not_whole(path, error) from None


def _variables(path: Path) -> Variables:
    import h5py

    if h5py.is_hdf5(path):
        return variables_v73(path)
    data = path.read_bytes()
    return variables_v4(data) if is_v4(data) else variables_v5(data)


def _not_whole(path: Path, error: Exception) -> RecordingError:
    reason = " ".join(str(error).split())
    return RecordingError(f"{path}: not a whole .mat file ({reason}); save it again in MATLAB")


def write_mat(recording: Recording, path: Path) -> None:
    """Write a v5 file: each channel a column vector, and the scalar ``sample_rate_Hz``; same recording, same bytes.

    Raises
    ------
    InputError
        For a channel whose name is not a valid MATLAB variable, or one of 2 GiB or more (the limit of v5).
    """
    from scipy.io import savemat

    for name, channel in recording.channels.items():
        if channel.values.nbytes >= 2**31:
            raise InputError(f"{path}: {name} is larger than the 2 GiB of a v5 .mat file; write Parquet or TDMS")
    vectors = {name: np.asarray(channel.values, dtype=np.float64) for name, channel in recording.channels.items()}
    others = {"sample_rate_Hz": recording.sample_rate, SIDECAR_KEY: sidecar_text(recording)}
    savemat(path, {**vectors, **others}, appendmat=False, oned_as="column")
    with path.open("r+b") as file:
        file.write(b"MATLAB 5.0 MAT-file, written by torquerig".ljust(_TITLE_LENGTH))


def refuse_variable_names(names: Iterable[str], path: Path) -> None:
    """Raise InputError for a channel whose name is not a valid MATLAB variable."""
    for name in names:
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,30}", name):
            raise InputError(
                f"{path}: {name!r} cannot name a MATLAB variable; rename the channel (letters, digits and _, at most "
                "31, a letter first), or write Parquet"
            )
