"""What the start of a studio refuses, each in one sentence."""

import socket

import pytest

from torquerig.cli import main
from torquerig.studio.session.studio_lock import studio_lock


@pytest.fixture
def extra():
    pytest.importorskip("nicegui")


def refused(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        main(["studio", *map(str, words), "--no-browser"])
    assert ended.value.code == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    return said.err


@pytest.mark.usefixtures("extra")
def test_a_port_in_use(tmp_path, capsys):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert "another program uses this port" in refused(capsys, tmp_path, "--port", port)


@pytest.mark.usefixtures("extra")
def test_a_second_studio_on_one_folder(tmp_path, capsys):
    with studio_lock(tmp_path):
        assert "a studio works on this folder already" in refused(capsys, tmp_path)


def test_a_folder_that_is_not_there(tmp_path, capsys):
    assert "there is no such folder or scenario" in refused(capsys, tmp_path / "missing")


def test_a_missing_extra(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("torquerig.studio.server.start.find_spec", lambda name: None)
    assert "pip install 'torquerig[studio]'" in refused(capsys, tmp_path)
