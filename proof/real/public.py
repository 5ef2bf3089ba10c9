"""Public sources of the real recordings, with revision and SHA-256 of every file; none is shipped.

They are read from the folder that the environment variable TORQUERIG_REAL_DATA names (with one subfolder per source),
or downloaded by pooch (``pip install --group proof``) into the user's cache, each checked against its SHA-256.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import quote

VARIABLE = "TORQUERIG_REAL_DATA"


@dataclass(frozen=True, kw_only=True)
class Source:
    """One data set.

    Parameters
    ----------
    folder : str
        Its folder below the one that TORQUERIG_REAL_DATA names.
    repository, revision : str
        On GitHub.
    licence, cite : str
    paths : mapping of str to str
        By the name used here: the path in the repository.
    sha256 : mapping of str to str
        By the name used here.
    """

    folder: str
    repository: str
    revision: str
    licence: str
    cite: str
    paths: Mapping[str, str]
    sha256: Mapping[str, str] = field(default_factory=dict)

    def file(self, name: str) -> Path:
        """Return the path of the checked file ``name``, from the folder or downloaded.

        Raises
        ------
        FileNotFoundError
            If the file is missing and cannot be downloaded; it says what to do.
        ValueError
            If the SHA-256 differs from the recorded one.
        """
        root = os.environ.get(VARIABLE)
        path = Path(root) / self.folder / name if root else self._fetched(name)
        if not path.is_file():
            raise FileNotFoundError(
                f"{path}: there is no such file; set {VARIABLE} to the folder that holds {self.folder}"
            )
        found = hashlib.sha256(path.read_bytes()).hexdigest()
        if found != self.sha256[name]:
            raise ValueError(
                f"{path}: its SHA-256 is {found}, not {self.sha256[name]}; download revision {self.revision}"
            )
        return path

    def address(self, name: str) -> str:
        """Return the address of the file ``name`` on GitHub."""
        return f"https://raw.githubusercontent.com/{self.repository}/{self.revision}/{quote(self.paths[name])}"

    def _fetched(self, name: str) -> Path:
        try:
            import pooch
        except ImportError:
            raise FileNotFoundError(
                f"the recordings of {self.repository} are missing; set {VARIABLE} to their folder, or install "
                "pooch to download them"
            ) from None
        known = f"sha256:{self.sha256[name]}"
        return Path(pooch.retrieve(self.address(name), known_hash=known, path=pooch.os_cache("torquerig"), fname=None))
