"""Results in a folder under their content, so that what was computed once is read the next time.

::

    FOLDER/CACHEDIR.TAG       tells programs for backups to leave the folder out (bford.info/cachedir)
    FOLDER/results/AB/REST    one result: a line, the digest of key and content, the content; AB REST is its key
    FOLDER/sources.json       digest of torquerig's sources by the state of their files

A result is written whole under another name and renamed, so that processes share the folder without a lock, and a
process that is killed loses nothing that was there. A key holds everything that a result depends on, so that a result
never becomes wrong: it is only not used any more, and removed when the folder reaches its limit.
"""

from __future__ import annotations

import os
import re
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from hashlib import blake2b
from pathlib import Path

from torquerig.cases.content import content_digest
from torquerig.cases.identity import code_here
from torquerig.whole_file import clear_leftovers, temporary_name

MAGIC = b"torquerig kept result 1\n"
DIGEST = 16  # bytes
LIMIT = 2 * 2**30  # bytes; the shipped study needs 5 MiB
TAG = b"Signature: 8a477f597d28d172789f06886806bc55\n# Results of torquerig, see: torquerig cache\n"
_FOLDER, _NAME = re.compile("[0-9a-f]{2}"), re.compile("[0-9a-f]{30}")


@dataclass(frozen=True)
class KeptEntry:
    """A result on the disk: its file, size [byte], and when it was used last [s since 1970]."""

    path: Path
    size: int
    used: float


@dataclass
class KeptResults:
    """A folder of results; nothing that happens to it is an error of the work that uses it.

    Parameters
    ----------
    folder : Path
        Made when the first result is kept.
    limit : int
        Most bytes of all results; those that were used longest ago are removed.
    memory : Path, optional
        File that remembers the digest of the sources.

    Attributes
    ----------
    found, stored : int
        How many results were read and written.
    notes : list of str
        What was damaged or could not be written, a sentence each.
    """

    folder: Path
    limit: int = LIMIT
    found: int = 0
    stored: int = 0
    notes: list[str] = field(default_factory=list)
    _written: int = 0
    _can_write: bool = True

    def key(self, kind: str, *content: object) -> str:
        """Return the key of a result: of its kind, its content, and the code that computes it."""
        return content_digest(kind, dict(code_here(self.folder / "sources.json")), *content)

    def get(self, key: str) -> bytes | None:
        """Return a kept result; None where there is none. A damaged one is removed, with a note."""
        path = self._path(key)
        try:
            content = path.read_bytes()
        except OSError:
            return None
        start = len(MAGIC) + DIGEST
        if content[:start] != MAGIC + _digest(key, content[start:]):
            self.notes.append(f"{path}: this kept result was damaged; it was removed and is computed again")
            with suppress(OSError):
                path.unlink()
            return None
        with suppress(OSError):  # a folder that is only read has no order of use
            os.utime(path)
        self.found += 1
        return content[start:]

    def put(self, key: str, content: bytes) -> None:
        """Keep a result; where it cannot be written, one note says why."""
        whole = MAGIC + _digest(key, content) + content
        if not self._can_write or len(whole) > self.limit:
            return
        try:
            self._write(self._path(key), whole)
        except OSError as error:
            self._can_write = False
            self.notes.append(
                f"{self.folder}: results are not kept ({error.strerror or error}); make room there, or name another "
                "folder with --cache or TORQUERIG_CACHE"
            )
            return
        self.stored += 1
        self._written += len(whole)
        if self._written > self.limit // 10:
            self.trim()

    def entries(self) -> Iterator[KeptEntry]:
        """Yield every result of the folder, in no order."""
        for path in _files(self.folder):
            with suppress(OSError):  # another process has removed it
                state = path.stat()
                yield KeptEntry(path, state.st_size, state.st_mtime)

    def trim(self) -> None:
        """Remove the results that were used longest ago until the others are within the limit."""
        self._written = 0
        held = sorted(self.entries(), key=lambda one: one.used)
        too_much = sum(one.size for one in held) - self.limit
        for one in held:
            if too_much <= 0:
                break
            with suppress(OSError):
                one.path.unlink()
                too_much -= one.size

    def clear(self, *, unused_for: float = 0.0) -> tuple[int, int]:
        """Remove the results that were not used for so long [s]; return how many, and their size [byte].

        Raises
        ------
        OSError
            Where one cannot be removed.
        """
        latest, removed, size = time.time() - unused_for, 0, 0
        for one in list(self.entries()):
            if one.used <= latest or unused_for == 0.0:
                one.path.unlink(missing_ok=True)
                removed, size = removed + 1, size + one.size
        return removed, size

    def _path(self, key: str) -> Path:
        return self.folder / "results" / key[:2] / key[2:]

    def _write(self, path: Path, whole: bytes) -> None:
        if not path.parent.is_dir():
            self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            (self.folder / "CACHEDIR.TAG").write_bytes(TAG)
            path.parent.mkdir(parents=True, exist_ok=True)
        partial = temporary_name(path, "partial")
        try:
            partial.write_bytes(whole)
            partial.replace(path)
        finally:
            with suppress(OSError):
                partial.unlink()


@contextmanager
def opened_results(folder: Path, *, limit: int = LIMIT) -> Iterator[KeptResults]:
    """Yield the results of a folder; at the end, also after an error, they are brought within the limit."""
    kept = KeptResults(folder, limit)
    try:
        yield kept
    finally:
        if kept.stored:
            for place in {path.parent for path in _files(folder)}:
                clear_leftovers(place)
            kept.trim()


def _files(folder: Path) -> Iterator[Path]:
    """Yield the files of results; other files of the folder are nobody's business here."""
    try:
        places = [one for one in os.scandir(folder / "results") if _FOLDER.fullmatch(one.name)]
    except OSError:
        return
    for place in places:
        with suppress(OSError):
            yield from (Path(one.path) for one in os.scandir(place) if _NAME.fullmatch(one.name))


def _digest(key: str, content: bytes) -> bytes:
    return blake2b(key.encode() + content, digest_size=DIGEST).digest()
