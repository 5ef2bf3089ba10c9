"""What a stored study is: which study, computed with which code, in which columns."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from torquerig.cases.case import Column, checked_columns
from torquerig.errors import InputError
from torquerig.version import __version__
from torquerig.whole_file import whole_file

SOURCES = "torquerig's sources"
FORMAT = 1  # of a store's folder
LIBRARIES = ("numpy", "scipy", "numba")  # a digit of a result can depend on them


@cache
def code_here(memory: Path | None = None) -> Mapping[str, str]:
    """Return the versions of the code of this process, which the answers of a case may depend on.

    ``memory`` is a file that remembers the digest of the sources as long as their files stay the same.
    """
    found = {"torquerig": __version__, SOURCES: sources_digest() if memory is None else remembered_digest(memory)}
    found["python"] = f"{sys.version_info.major}.{sys.version_info.minor}"
    for library in LIBRARIES:
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            found[library] = "none"
    return found


@dataclass(frozen=True)
class Identity:
    """The identity of a study, which a store keeps and a resumed study must have.

    Parameters
    ----------
    study : mapping of str to str
        What determines the answers, by its name for people: the digest of the scenario, of the catalog values, the name
        of the work function, settings. The number of cases is not part of it: cases can be added.
    values, results : sequence of Column
        Columns that the cases bring, and columns that the work function returns.
    code : mapping of str to str
        Versions of torquerig, of its sources, of Python and of the libraries that compute; of this process by default.

    Raises
    ------
    InputError
        For two columns of one name.
    """

    study: Mapping[str, str]
    values: Sequence[Column] = ()
    results: Sequence[Column] = ()
    code: Mapping[str, str] = field(default_factory=code_here)

    def __post_init__(self) -> None:
        checked_columns(self.values, self.results)

    def as_json(self) -> str:
        """Return the text of the file that holds the identity."""
        parts = {
            "format": FORMAT,
            "study": dict(self.study),
            "code": dict(self.code),
            "values": [asdict(column) for column in self.values],
            "results": [asdict(column) for column in self.results],
        }
        return json.dumps(parts, indent=1, ensure_ascii=False) + "\n"


def sources_digest() -> str:
    """Return the digest of all source files of the installed torquerig."""
    root = Path(__file__).resolve().parents[1]
    digest = hashlib.blake2b(digest_size=8)
    for path in sorted(root.rglob("*.py")):
        digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def remembered_digest(memory: Path) -> str:
    """Return :func:`sources_digest`, read from a file while names, sizes and times of the sources are those it holds.

    A file that cannot be read or written is no obstacle.
    """
    state = digest_of(repr(sorted(_states(str(Path(__file__).resolve().parents[1])))))
    with suppress(OSError, ValueError, AttributeError):
        found = json.loads(memory.read_text(encoding="utf-8")).get(state)
        if isinstance(found, str):
            return found
    found = sources_digest()
    with suppress(OSError):
        memory.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        with whole_file(memory) as partial:
            partial.write_text(json.dumps({state: found}), encoding="utf-8")
    return found


def _states(folder: str) -> Iterator[tuple[str, int, int, int]]:
    """Yield path, size, time of change and number of each source file."""
    with os.scandir(folder) as found:
        for one in found:
            if one.name.endswith(".py"):
                state = one.stat()
                yield one.path, state.st_size, state.st_mtime_ns, state.st_ino
            elif one.name != "__pycache__" and one.is_dir(follow_symlinks=False):
                yield from _states(one.path)


def digest_of(text: str | bytes) -> str:
    """Return a short digest of a text, for a part of a study's identity that is too long to be read."""
    return hashlib.blake2b(text.encode() if isinstance(text, str) else text, digest_size=8).hexdigest()


def refuse_other(stored: str, wanted: Identity, *, folder: Path) -> None:
    """Refuse to go on with a store of another study, or of one that other code has computed.

    Raises
    ------
    InputError
        With the first part in which they differ.
    """
    there, here = _parts_of(stored, folder), json.loads(wanted.as_json())
    another = f"go on in another folder, or delete {folder} to compute all cases again"
    if there.get("format") != FORMAT:
        raise InputError(
            f"{folder} has store format {there.get('format')}, this version of torquerig has {FORMAT}; {another}"
        )
    for name, value, other in _differences(there["study"], here["study"]):
        raise InputError(f"{folder} holds another study: its {name} is {value}, this study's is {other}; {another}")
    for name, value, other in _differences(there["code"], here["code"]):
        if name == SOURCES:
            raise InputError(f"{folder} was computed by other sources of torquerig; the rows could differ; {another}")
        raise InputError(
            f"{folder} was computed with {name} {value}, here is {other}; the rows could differ; "
            f"use {name} {value} again, or {another}"
        )
    for kind in ("values", "results"):
        if there[kind] != here[kind]:
            names = ", ".join(column["name"] for column in there[kind]) or "none"
            raise InputError(f"{folder} holds a study with other columns of {kind} ({names}); {another}")


def _parts_of(stored: str, folder: Path) -> dict[str, Any]:
    try:
        parts: dict[str, Any] = json.loads(stored)
        if {"format", "study", "code", "values", "results"} <= parts.keys():
            return parts
    except (ValueError, AttributeError):
        pass
    raise InputError(f"{folder}/study.json is no identity of a stored study; give another folder, or delete that one")


def _differences(there: Mapping[str, str], here: Mapping[str, str]) -> list[tuple[str, str, str]]:
    return [
        (name, there.get(name, "not stated"), here.get(name, "not stated"))
        for name in sorted(there.keys() | here.keys())
        if there.get(name) != here.get(name)
    ]
