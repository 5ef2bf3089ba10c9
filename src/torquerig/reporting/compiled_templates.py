"""Compiled templates in Python's own folder for compiled files: compiling those of a page takes 60 ms."""

from __future__ import annotations

import sys
from contextlib import suppress
from hashlib import blake2b
from importlib.util import cache_from_source
from pathlib import Path

from jinja2 import BytecodeCache, __version__
from jinja2.bccache import Bucket

from torquerig.whole_file import temporary_name

DIGEST = 16  # bytes


class CompiledTemplates(BytecodeCache):
    """The compiled templates of a folder, as ``__pycache__`` has modules.

    A file that does not belong to the text of its template, to this Python or this jinja2 is not used. Where none can
    be written, or Python shall write none, the template is compiled in each process.

    Parameters
    ----------
    folder : Path
        Of the templates.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def load_bytecode(self, bucket: Bucket) -> None:
        """Fill a bucket from its file."""
        with suppress(OSError):
            found = self._path(bucket).read_bytes()
            content = found[DIGEST:]
            if found[:DIGEST] == _digest(content):  # what is damaged could end the process
                bucket.bytecode_from_string(content)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Write a bucket to its file."""
        if sys.dont_write_bytecode:
            return
        path = self._path(bucket)
        partial = temporary_name(path, "partial")
        with suppress(OSError):
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
                content = bucket.bytecode_to_string()
                partial.write_bytes(_digest(content) + content)
                partial.replace(path)
            finally:
                partial.unlink(missing_ok=True)

    def _path(self, bucket: Bucket) -> Path:
        name = f"template-{bucket.key}-jinja{__version__}.py"
        return Path(cache_from_source(str(self.folder / name)))


def _digest(content: bytes) -> bytes:
    return blake2b(content, digest_size=DIGEST).digest()
