"""What a command writes to the terminal: foreign text made harmless, failures of the system in one sentence."""

from __future__ import annotations

import errno
import os
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any, TextIO

import click

from torquerig.harmless import harmless

REMEDIES: Mapping[int, str] = {
    errno.ENOSPC: "free space on the disk and run the command again",
    errno.EDQUOT: "free space in the quota and run the command again",
    errno.EFBIG: "free space or raise the limit for the size of a file, and run the command again",
    errno.EACCES: "choose another place, or change its permissions",
    errno.EPERM: "choose another place, or change its permissions",
    errno.EROFS: "choose a place that can be written to",
    errno.ENOENT: "check the path",
    errno.ENOTDIR: "check the path",
    errno.EISDIR: "name a file in it",
    errno.ENAMETOOLONG: "choose a shorter name",
    errno.ELOOP: "check the links in the path",
    errno.EMFILE: "close other programs, or raise the limit for open files",
}
"""What to do about an error of the operating system."""


class HarmlessStream:
    """A text stream to ``stream`` in which foreign text cannot act on the terminal."""

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream
        self.encoding = "utf-8"  # click writes past a stream of another encoding; what the terminal lacks is escaped

    def write(self, text: str) -> int:
        """Write the text with control characters as escapes; what the terminal's encoding lacks too."""
        encoding = getattr(self.stream, "encoding", None) or "utf-8"
        with _closed_pipes_named():
            self.stream.write(harmless(text).encode(encoding, "backslashreplace").decode(encoding))
        return len(text)

    def flush(self) -> None:
        """Flush the stream."""
        with _closed_pipes_named():
            self.stream.flush()

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


@contextmanager
def _closed_pipes_named() -> Iterator[None]:
    """Turn a closed pipe into a usage error; click itself would end with exit code 1 and no word."""
    try:
        yield
    except BrokenPipeError:
        close_output()
        raise click.ClickException(
            "the program that reads the output ended before everything was written; let it read to the end"
        ) from None


@contextmanager
def harmless_streams() -> Iterator[None]:
    """Make standard output and standard error harmless; flush them at the end, so that a full disk is an error here."""
    before = sys.stdout, sys.stderr
    for name, stream in zip(("stdout", "stderr"), before, strict=True):
        if stream is not None:  # closed by the caller, as in ``torquerig info run.csv >&-``
            setattr(sys, name, HarmlessStream(stream))
    try:
        yield
        for stream in before:
            if stream is not None:
                HarmlessStream(stream).flush()
    finally:
        sys.stdout, sys.stderr = before


def terminal(stream: TextIO) -> TextIO:
    """Return the stream that takes the control characters of a progress bar."""
    return stream.stream if isinstance(stream, HarmlessStream) else stream


def system_sentence(error: OSError) -> str:
    """Return an error of the operating system in one sentence: the file, what is wrong and what to do."""
    if isinstance(error, shutil.Error):  # several files of a folder
        copied = error.args[0][0]
        error = OSError(errno.EIO, str(copied[2]), str(copied[1]))
    place = "the output" if error.filename is None else str(error.filename)
    what = (error.strerror or str(error) or type(error).__name__).splitlines()[0].rstrip(".")
    remedy = REMEDIES.get(error.errno or 0, "check the place and run the command again")
    return f"{place}: {what[0].lower()}{what[1:]}; {remedy}"


def close_output() -> None:
    """Connect standard output with nothing, so that the interpreter does not fail again on what is still in it."""
    try:
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, sys.stdout.fileno())
        os.close(nothing)
    except (OSError, ValueError, AttributeError):  # no file at all, as in a test
        return
