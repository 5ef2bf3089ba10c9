"""A .mat file of v7.3, written block by block: HDF5 with MATLAB's header."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.sidecar_text import SIDECAR_KEY, sidecar_text
from torquerig.recordings.recording import Recording

# the 512 bytes before the HDF5 part: text up to 116, subsystem offset, version 2.0 and the byte order
_HEADER = b"MATLAB 7.3 MAT-file, written by torquerig".ljust(116) + b"\0" * 8 + b"\x00\x02IM"
_USER_BLOCK, _CHUNK = 512, 2**17


@contextmanager
def mat_block_writer(path: Path, head: Recording) -> Iterator[Callable[[Mapping[str, NDArray[np.float64]]], None]]:
    """Yield a function that appends blocks: each channel grows as a column vector of doubles.

    Source: MathWorks, "MAT-File Versions" (v7.3 is HDF5); MATLAB finds a variable's class in ``MATLAB_class`` and
    stores a column of n as a dataset of 1 x n.
    """
    import h5py

    with h5py.File(path, "w", userblock_size=_USER_BLOCK) as file:
        made = {
            name: file.create_dataset(name, (1, 0), "f8", maxshape=(1, None), chunks=(1, _CHUNK))
            for name in head.channels
        }
        made["sample_rate_Hz"] = file.create_dataset("sample_rate_Hz", data=np.array([[head.sample_rate]]))
        for dataset in made.values():
            dataset.attrs["MATLAB_class"] = np.bytes_("double")
        signs = np.frombuffer(sidecar_text(head).encode("utf-16-le"), np.uint16)
        text = file.create_dataset(SIDECAR_KEY, data=signs.reshape(-1, 1))
        text.attrs["MATLAB_class"] = np.bytes_("char")
        text.attrs["MATLAB_int_decode"] = np.int32(2)

        def append(columns: Mapping[str, NDArray[np.float64]]) -> None:
            for name, values in columns.items():
                written = made[name].shape[1]
                made[name].resize((1, written + values.size))
                made[name][0, written:] = values

        yield append
    with path.open("r+b") as raw:
        raw.write(_HEADER)
