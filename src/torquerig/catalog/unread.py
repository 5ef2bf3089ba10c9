"""A catalog that is read when its first entry is looked up."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from hashlib import blake2b
from pathlib import Path
from typing import Any

from torquerig.catalog.shelves import Catalog
from torquerig.errors import InputError

SHELVES = ("motors", "gearboxes", "sensors", "couplings", "classes")


def unread_catalog(*folders: Path) -> Catalog:
    """Return the catalog of some folders, whose entries are read when the first one is looked up.

    Until then only the bytes of the files are read, for the digest. Errors are those of
    :func:`torquerig.catalog.reading.load_catalog`, at the first look-up.
    """
    source = _Source(folders, files_digest(folders))
    shelves: dict[str, Any] = {name: _Shelf(source, name) for name in SHELVES}
    return Catalog(**shelves, digest=source.digest)


def files_digest(folders: Iterable[Path]) -> str:
    """Return the digest of names and bytes of all files of catalog folders; empty where one cannot be read."""
    digest = blake2b(digest_size=16)
    for folder in folders:
        digest.update(f"{folder.resolve()}".encode("utf-8", "surrogateescape") + b"\0")
        try:
            paths = sorted(path for path in folder.rglob("*") if path.is_file())
            for path in paths:
                name = path.relative_to(folder).as_posix().encode("utf-8", "surrogateescape")
                digest.update(name + b"\0" + path.read_bytes() + b"\0")
        except OSError:
            return ""
    return digest.hexdigest()


@dataclass(frozen=True)
class _Source:
    folders: tuple[Path, ...]
    digest: str

    @cached_property
    def whole(self) -> Catalog:
        """The catalog, read now."""
        from torquerig.catalog.reading import load_catalog

        found = load_catalog(*self.folders)
        if files_digest(self.folders) != self.digest:
            names = ", ".join(map(str, self.folders))
            raise InputError(f"{names}: the catalog was changed while it was read; run the command again")
        return found


class _Shelf(Mapping[str, Any]):
    """The entries of one kind."""

    def __init__(self, source: _Source, name: str) -> None:
        self._source, self._name = source, name

    @property
    def _entries(self) -> Mapping[str, Any]:
        entries: Mapping[str, Any] = getattr(self._source.whole, self._name)
        return entries

    def __getitem__(self, name: str) -> Any:
        return self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __repr__(self) -> str:
        return repr(self._entries)

    def __reduce__(self) -> tuple[Any, ...]:
        return dict, (dict(self._entries),)
