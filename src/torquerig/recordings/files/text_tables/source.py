"""A text file as UTF-8 bytes with line feeds: byte order marks, UTF-16, CR line ends and gzip are resolved."""

from __future__ import annotations

import codecs
from collections.abc import Iterator
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from torquerig.errors import RecordingError
from torquerig.recordings.files.text_tables.bounded_gzip import BoundedGzip

# enough for the encoding [bytes]
_HEAD = 2**16
# a table has no longer line [bytes]; without a bound, a file without line ends would be held whole
_LONGEST_LINE = 2**24
# the last lines are held back until the end is known, because a footer may follow the rows [bytes]
_HELD_BACK = 2**16
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_OTHER_FORMATS = {
    b"PK\x03\x04": "is a zip archive or an Excel workbook, not text; give it the ending .xlsx, or unpack it",
    b"\x1f\x8b": "is compressed by gzip; give it the ending .csv.gz",
}


@dataclass(frozen=True, kw_only=True)
class TextSource:
    """A text file and how its bytes become UTF-8 lines.

    Parameters
    ----------
    path : Path
    encoding : str
        A Python codec. ``"utf-8"`` stands for every 8-bit encoding: its bytes stay as they are.
    mark : int
        Bytes of the byte order mark at the start.
    carriage_returns : bool
        Whether lines end with CR alone.
    packed : bool
        Whether the file is compressed by gzip.
    content : bytes or None
        The text itself, where it is in memory (the sheet of a workbook).
    is_assumed : bool
        Whether nothing in the file says how letters beyond ASCII are written, and Windows-1252 is assumed.
    """

    path: Path
    encoding: str = "utf-8"
    mark: int = 0
    carriage_returns: bool = False
    packed: bool = False
    content: bytes | None = None
    is_assumed: bool = False

    def note(self) -> str:
        """Return what is unusual about the encoding; empty for UTF-8."""
        unusual = [self.encoding.upper()] if self.encoding != "utf-8" else []
        unusual += ["carriage returns as line ends"] if self.carriage_returns else []
        found = [f"the text is in {' with '.join(unusual)}"] if unusual else []
        if self.is_assumed:
            found.append("the text is not in UTF-8 and is read as Windows-1252; if letters are wrong, save it as UTF-8")
        return "; ".join(found)

    def blocks(self, step: int, *, start: int = 0) -> Iterator[bytes]:
        """Yield UTF-8 bytes from the byte ``start`` of the converted text on, about ``step`` at a time."""
        with self._opened() as file:
            if self.encoding == "utf-8" and not self.packed:
                file.seek(self.mark + start)
                start = 0
            else:
                file.read(self.mark)
            decode = codecs.getincrementaldecoder(self.encoding)(errors="replace").decode
            while data := file.read(step):
                data = data if self.encoding == "utf-8" else decode(data).encode("utf-8", errors="replace")
                data = data.replace(b"\r", b"\n") if self.carriage_returns else data
                skipped = min(start, len(data))
                start -= skipped
                if data[skipped:]:
                    yield data[skipped:]

    def line_blocks(self, step: int, *, start: int = 0) -> Iterator[tuple[bytes, bool]]:
        """Yield blocks of complete lines, each with whether it is the last one, which holds a footer if there is one.

        Raises
        ------
        RecordingError
            For a line of more than 16 MiB.
        """
        held, hold = b"", min(_HELD_BACK, step // 2)
        for data in self.blocks(step, start=start):
            held += data
            end = held.rfind(b"\n", 0, max(len(held) - hold, 0)) + 1
            if end:
                yield held[:end], False
                held = held[end:]
            elif len(held) > max(_LONGEST_LINE, 2 * step):
                raise RecordingError(
                    f"{self.path}: one of its lines is longer than 16 MiB; it is no table of rows, export it again"
                )
        # a logger that loses its power leaves zeros in the space that it had reserved
        yield held.rstrip(b"\0"), True

    def _opened(self) -> BinaryIO | BoundedGzip:
        return BytesIO(self.content) if self.content is not None else _opened(self.path, packed=self.packed)


def open_text(path: Path, *, packed: bool = False) -> TextSource:
    """Return a text file with its encoding, which its first 64 KiB determine.

    Raises
    ------
    RecordingError
        For a binary file, and a damaged gzip file.
    """
    with _opened(path, packed=packed) as file:
        head = file.read(_HEAD)
    for mark, encoding in _MARKS:
        if head.startswith(mark):
            return _with_line_ends(head, TextSource(path=path, encoding=encoding, mark=len(mark), packed=packed))
    for start, problem in _OTHER_FORMATS.items():
        if head.startswith(start):
            raise RecordingError(f"{path}: {problem}")
    content = head.rstrip(b"\0") or head
    if b"\0" not in content:
        return _with_line_ends(head, TextSource(path=path, packed=packed, is_assumed=not _is_utf8(head)))
    even, odd = content[::2].count(0), content[1::2].count(0)
    for zeros, others, encoding in ((odd, even, "utf-16-le"), (even, odd, "utf-16-be")):
        # in UTF-16, nearly every second byte of a table is zero, and no other
        if zeros > 0.4 * len(content) and not others:
            return _with_line_ends(head, TextSource(path=path, encoding=encoding, packed=packed))
    raise RecordingError(f"{path}: is binary, not text; give it the ending of its format (.tdms, .mat, ...)")


def decoded(data: bytes) -> str:
    """Return text from UTF-8, or else from Windows-1252 (latin-1 with the signs of Windows)."""
    for encoding in ("utf-8", "cp1252"):
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1")


def _is_utf8(head: bytes) -> bool:
    try:
        codecs.getincrementaldecoder("utf-8")().decode(head)  # the last letter may be cut
    except UnicodeDecodeError:
        return False
    return True


def _with_line_ends(head: bytes, source: TextSource) -> TextSource:
    text = head.decode(source.encoding, errors="replace")
    if "\r" not in text or "\n" in text:
        return source
    return replace(source, carriage_returns=True)


def _opened(path: Path, *, packed: bool) -> BinaryIO | BoundedGzip:
    return BoundedGzip(path) if packed else path.open("rb")
