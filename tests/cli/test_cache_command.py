"""``torquerig cache``: shows what is kept, clears it by age, and says where nothing is kept."""

from __future__ import annotations

import json
import os
import re
import time
from pathlib import Path

import pytest

from torquerig.cases.content import content_digest
from torquerig.cases.kept_results import KeptResults
from torquerig.cli import main


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a result of now and one of 40 days ago, named by the environment."""
    kept = KeptResults(tmp_path / "kept")
    for number in (1, 2):
        kept.put(content_digest(number), bytes(1000))
    old = time.time() - 40 * 86400
    os.utime(kept._path(content_digest(1)), (old, old))
    monkeypatch.setenv("TORQUERIG_CACHE", str(tmp_path / "kept"))
    return tmp_path / "kept"


def test_it_shows_folder_number_size_and_age(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["cache"])
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"folder   {folder}"
    assert lines[1] == "results  2"
    assert lines[2] == "size     2.0 KiB of 2.00 GiB (TORQUERIG_CACHE_LIMIT sets the limit)"
    assert re.fullmatch(r"used     \d+ s to 40 days ago", lines[3])


@pytest.mark.parametrize(("options", "kept"), [(("--older-than", "30 d"), 1), (("--older-than", "2000 h"), 2), ((), 0)])
def test_it_clears_all_or_by_age(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], options: tuple[str, ...], kept: int
) -> None:
    main(["cache", "clear", *options, "--json", str(tmp_path / "out.json")])
    found = json.loads((tmp_path / "out.json").read_text())
    assert (found["entries"], found["removed_entries"]) == (kept, 2 - kept)
    assert f"removed {2 - kept} results" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("cache", "--older-than", "30 d"), "--older-than is for clear"),
        (("cache", "clear", "--older-than", "30 kg"), "--older-than: "),
        (("compare", "x.yaml", "--cache", "a", "--no-cache"), "x.yaml: there is no such file"),
    ],
)
def test_what_cannot_be_done_is_said(
    folder: Path, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], said: str
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    assert said in capsys.readouterr().err


def test_without_a_folder_nothing_is_shown(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("TORQUERIG_CACHE", "none")
    with pytest.raises(SystemExit):
        main(["cache"])
    assert "TORQUERIG_CACHE=none: no results are kept" in capsys.readouterr().err
