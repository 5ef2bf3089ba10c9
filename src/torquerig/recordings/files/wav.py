"""WAV files of a sound card or an audio logger; the samples are shares of full scale (FS)."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces, pieces_of


def read_wav(path: Path) -> Table:
    """Read a WAV file as ``channel_1``, ``channel_2``, ... in shares of full scale, unit ``FS``.

    Integer samples are divided by half their range (-1 <= x < 1); float samples are not changed. The value of full
    scale (``Nm_per_FS``) must be stated in a sidecar.

    Raises
    ------
    RecordingError
        When the file is no WAV file, or is shorter than its header states.
    """
    rate, samples = _opened(path, mapped=False)
    table = np.atleast_2d(samples.T)
    names = [f"channel_{number + 1}" for number in range(table.shape[0])]
    columns = {name: _share_of_full_scale(row) for name, row in zip(names, table, strict=True)}
    return Table(columns=columns, rates=dict.fromkeys(names, float(rate)), units=dict.fromkeys(names, "FS"))


def wav_pieces(path: Path) -> TablePieces:
    """Return a WAV file in pieces; one of 24 bits is read at once, because scipy cannot map it."""
    try:
        rate, samples = _opened(path, mapped=True)
    except RecordingError:
        return pieces_of(read_wav(path), reason="a WAV file of 24 bits, or one without samples, is read whole")
    frames, width = samples.shape[0], 1 if samples.ndim == 1 else samples.shape[1]
    kind, position = samples.dtype, samples.offset
    every = [f"channel_{number + 1}" for number in range(width)]

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        # read, not memory-mapped: mapped pages would count as memory of the process
        with path.open("rb") as file:
            file.seek(position)
            for first in range(0, frames, PIECE):
                block = np.fromfile(file, kind, min(PIECE, frames - first) * width).reshape(-1, width)
                yield {name: _share_of_full_scale(block[:, every.index(name)]) for name in names}

    return TablePieces(
        names=tuple(every),
        lengths=dict.fromkeys(every, frames),
        pieces=pieces,
        rates=dict.fromkeys(every, float(rate)),
        units=dict.fromkeys(every, "FS"),
    )


def _opened(path: Path, *, mapped: bool) -> tuple[int, Any]:
    from scipy.io import wavfile

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            rate, samples = wavfile.read(path, mmap=mapped)
        # scipy raises errors of many kinds for a damaged header: division by zero, a name that is not set
        except Exception as error:
            if "Unknown wave file format" in str(error):
                coding = str(error).partition(": ")[2].partition(".")[0] or "unknown"
                raise RecordingError(
                    f"{path}: the coding {coding} of the WAV file is not read; save it as PCM or as floats"
                ) from None
            raise RecordingError(f"{path}: not a whole WAV file ({error}); copy it again from its source") from None
    if rate <= 0:
        raise RecordingError(f"{path}: the header of the WAV file states {rate} samples per second; copy it again")
    # other warnings are about skipped text chunks
    if any("prematurely" in str(warning.message) for warning in caught):
        raise RecordingError(
            f"{path}: the WAV file ends before the length that its header states; copy it again from its source"
        )
    return rate, samples


def _share_of_full_scale(samples: np.ndarray) -> np.ndarray:
    if samples.dtype.kind == "f":
        with np.errstate(invalid="ignore"):  # a damaged float may be a signalling NaN
            return samples.astype(np.float64)
    half = 2.0 ** (8 * samples.dtype.itemsize - 1)
    centre = half if samples.dtype.kind == "u" else 0.0
    shares: np.ndarray = (samples.astype(np.float64) - centre) / half
    return shares
