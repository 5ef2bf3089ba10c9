"""A catalog that is read at the first look-up is the catalog, or an error."""

from __future__ import annotations

import pickle
import shutil
from pathlib import Path

import pytest

from torquerig.catalog import reading
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.catalog.unread import files_digest, unread_catalog
from torquerig.errors import InputError


def test_an_unread_catalog_is_the_read_one_and_is_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = []
    before = reading.load_catalog
    monkeypatch.setattr(reading, "load_catalog", lambda *folders: calls.append(folders) or before(*folders))
    unread = unread_catalog(shipped_folder())
    assert calls == []
    assert unread.digest == files_digest([shipped_folder()]) != ""
    read = load_catalog(shipped_folder())
    assert unread == read
    assert unread.motor("HDS5C-102A") == read.motor("HDS5C-102A")
    assert pickle.loads(pickle.dumps(unread)) == read
    assert len(calls) == 1


def test_a_catalog_that_changes_before_it_is_read_is_an_error(tmp_path: Path) -> None:
    folder = tmp_path / "catalog"
    shutil.copytree(shipped_folder(), folder)
    unread = unread_catalog(folder)
    path = next((folder / "motors").glob("*.yaml"))
    path.write_text(path.read_text() + "# another comment\n")
    with pytest.raises(InputError, match="the catalog was changed while it was read; run the command again"):
        unread.motor("GP-71M")


def test_the_digest_depends_on_names_and_bytes(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("1")
    digests = {files_digest([tmp_path])}
    (tmp_path / "a.yaml").write_text("2")
    digests.add(files_digest([tmp_path]))
    (tmp_path / "a.yaml").rename(tmp_path / "b.yaml")
    digests.add(files_digest([tmp_path]))
    assert len(digests) == 3
    assert files_digest([tmp_path / "nowhere"]) not in digests
