"""Text tables compressed by gzip: ``run.csv.gz``, unpacked while it is read, within bounds."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from torquerig.errors import InputError
from torquerig.recordings.files.csv import source_pieces, table_of, whole_pieces
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import TablePieces
from torquerig.recordings.files.text_tables.source import TextSource, open_text

TEXT_ENDINGS = (".csv", ".tsv", ".txt", ".dat", ".asc", ".log", ".prn")
"""Endings of text tables."""
# a smaller packed file is read at once, so that its number of samples is known [bytes]
_SMALL = 2**20


def read_gz(path: Path, only: Collection[str] = ()) -> Table:
    """Read a compressed text table, as :func:`~torquerig.recordings.files.csv.read_csv`.

    Raises
    ------
    InputError
        Where the compressed file is no text table by its ending.
    RecordingError
        For a damaged file, and one that unpacks to more than 4 GiB or 200 times its size.
    """
    return table_of(_source(path), only)


def gz_pieces(path: Path) -> TablePieces:
    """Return a compressed text table in pieces; a small one is read at once."""
    source = _source(path)
    return whole_pieces(source) if path.stat().st_size <= _SMALL else source_pieces(source)


def _source(path: Path) -> TextSource:
    inner = path.with_suffix("").suffix.lower()
    if inner not in TEXT_ENDINGS:
        endings = ", ".join(f"{one}.gz" for one in TEXT_ENDINGS)
        raise InputError(f"{path}: only compressed text tables are read ({endings}); unpack the file")
    return open_text(path, packed=True)
