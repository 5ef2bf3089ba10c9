"""A file as it was read, whether it has changed since, and writing that never replaces what others have written."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from torquerig.errors import InputError
from torquerig.safe_yaml import LONGEST_TEXT
from torquerig.whole_file import whole_file

State = Literal["same", "changed", "gone"]
Offer = Literal["reload", "save_as"]


@dataclass(frozen=True)
class FileOnDisk:
    """A file and its content when it was read or written last; the content is None for a file that is new."""

    path: Path
    content: bytes | None

    def state(self) -> State:
        """Return whether the file on the disk is still the same, has changed, or is not there any more.

        A new file that another program has made meanwhile has changed.
        """
        try:
            now: bytes | None = self.path.read_bytes()
        except FileNotFoundError:
            now = None
        except OSError:
            return "changed"
        if now == self.content:
            return "same"
        return "gone" if now is None else "changed"


@dataclass(frozen=True)
class Saved:
    """How a saving ended: whether it was written, one sentence, and what can be done where it was refused."""

    written: bool
    sentence: str
    file: FileOnDisk
    offers: tuple[Offer, ...] = ()


def read_text(path: Path) -> tuple[str, FileOnDisk]:
    """Return the text of a file, its line breaks as they are; InputError where it is missing or no UTF-8 text."""
    try:
        content = path.read_bytes()
        if len(content) > LONGEST_TEXT:
            raise InputError(f"{path}: has more than {LONGEST_TEXT / 1e6:g} MB, too much for a YAML file")
        return content.decode("utf-8"), FileOnDisk(path, content)
    except FileNotFoundError:
        raise InputError(f"{path}: there is no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read ({error}); it must be a UTF-8 text file") from None


def save(file: FileOnDisk, text: str) -> Saved:
    """Write a text whole or not at all; refused where the file has changed on disk since it was read.

    Raises
    ------
    InputError
        Where the folder or disk cannot be written to; the file is unchanged.
    """
    content, name = text.encode("utf-8"), file.path.name
    try:
        with whole_file(file.path) as partial:
            partial.write_bytes(content)
            state = file.state()  # at the last moment before the exchange
            if state == "changed":
                raise _Changed
    except _Changed:
        return Saved(False, f"{name}: has changed on disk since it was read; nothing was written. Reload from disk, or "
                     "save your version under another name", file, ("reload", "save_as"))  # fmt: skip
    except OSError as error:
        raise InputError(f"{file.path}: cannot be written ({error.strerror}); the file is unchanged") from None
    again = " (it had been deleted)" if state == "gone" and file.content is not None else ""
    return Saved(True, f"{name}: saved{again}", FileOnDisk(file.path, content))


class _Changed(Exception):  # noqa: N818 (leaves the writing of the file, and nothing else)
    pass
