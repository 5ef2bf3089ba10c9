"""WAV: what a sound card or an audio logger wrote; the samples are shares of full scale (FS)."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np

from torquerig.errors import RecordingError
from torquerig.signals.files.table import Table


def read_wav(path: Path) -> Table:
    """Read a WAV file as ``channel_1``, ``channel_2``, ... in shares of full scale, unit ``FS``.

    Integer samples are divided by half their range (-1 <= x < 1); float samples are taken as they are. What full scale
    means (``Nm_per_FS``) only a sidecar can tell.

    Raises
    ------
    RecordingError
        When the file is no WAV file, or ends before its header says.
    """
    from scipy.io import wavfile

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            # scipy stumbles over its own unset variable (a NameError) where a file has no chunks
            rate, samples = wavfile.read(path)
        except (ValueError, EOFError, OSError, TypeError, NameError) as error:
            raise RecordingError(f"{path}: not a whole WAV file ({error}); copy it again from its source") from None
    # other warnings tell of text chunks that are skipped
    if any("prematurely" in str(warning.message) for warning in caught):
        raise RecordingError(f"{path}: the WAV file ends before its header says; copy it again from its source")
    table = np.atleast_2d(samples.T)
    names = [f"channel_{number + 1}" for number in range(table.shape[0])]
    columns = {name: _share_of_full_scale(row) for name, row in zip(names, table, strict=True)}
    return Table(columns=columns, rates=dict.fromkeys(names, float(rate)), units=dict.fromkeys(names, "FS"))


def _share_of_full_scale(samples: np.ndarray) -> np.ndarray:
    if samples.dtype.kind == "f":
        return samples.astype(np.float64)
    half = 2.0 ** (8 * samples.dtype.itemsize - 1)
    centre = half if samples.dtype.kind == "u" else 0.0
    shares: np.ndarray = (samples.astype(np.float64) - centre) / half
    return shares
