"""Reading of a gzip file whose unpacked size is bounded."""

from __future__ import annotations

import zlib
from pathlib import Path

from torquerig.errors import RecordingError

# the largest unpacked text [bytes]: an hour of four channels at 25 kHz has about 3 GiB as CSV
_LARGEST = 2**32
# unpacked bytes per packed byte: tables of numbers have 2 to 50, one repeated row up to 1030
_LARGEST_RATIO = 200
# the ratio is judged beyond this many unpacked bytes
_JUDGED = 2**24


class BoundedGzip:
    """A gzip file that is read from the start; RecordingError where it is damaged or grows beyond its bounds."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = path.open("rb")
        self._inflate = zlib.decompressobj(wbits=31)
        self._packed = self._unpacked = 0
        self._input = b""

    def __enter__(self) -> BoundedGzip:
        return self

    def __exit__(self, *exception: object) -> None:
        self._file.close()

    def seek(self, place: int) -> None:
        """Skip the first ``place`` unpacked bytes; only from the start."""
        while place > 0 and (data := self.read(min(place, 2**20))):
            place -= len(data)

    def read(self, size: int) -> bytes:
        """Return the next ``size`` unpacked bytes, fewer at the end."""
        found = bytearray()
        while len(found) < size:
            if not self._input and not self._inflate.eof:
                self._input = self._file.read(2**16)
                self._packed += len(self._input)
                if not self._input:
                    raise RecordingError(f"{self._path}: the gzip file ends early; copy it again from its source")
            if self._inflate.eof and not self._next_member():
                break
            found += self._inflated(size - len(found))
        return bytes(found)

    def _inflated(self, size: int) -> bytes:
        try:
            data = self._inflate.decompress(self._input, size)
        except zlib.error as error:
            raise RecordingError(
                f"{self._path}: is not a whole gzip file ({error}); copy it again from its source"
            ) from error
        self._input = self._inflate.unconsumed_tail
        self._unpacked += len(data)
        ratio = self._unpacked / max(self._packed, 1)
        if self._unpacked > _LARGEST or (self._unpacked > _JUDGED and ratio > _LARGEST_RATIO):
            raise RecordingError(
                f"{self._path}: unpacks to more than {self._unpacked / 2**20:.0f} MiB ({ratio:.0f} times its size), "
                "which is no recording, or too long a one; unpack it by hand and save the table as Parquet or TDMS"
            )
        return data

    def _next_member(self) -> bool:
        """Begin the next of several joined gzip files; False at the end of the last one."""
        self._input = self._inflate.unused_data or self._file.read(2**16)
        self._packed += 0 if self._inflate.unused_data else len(self._input)
        if not self._input.strip(b"\0"):
            return False
        self._inflate = zlib.decompressobj(wbits=31)
        return True
