"""What the start of a studio refuses, each in one sentence."""

import shutil
import socket

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main
from torquerig.studio.session.folder_files import opened_at
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


def test_a_file_that_is_no_scenario(tmp_path, capsys):
    (tmp_path / "run.csv").write_text("u\n1\n")
    assert "run.csv: is no scenario" in refused(capsys, tmp_path / "run.csv")
    assert [one.name for one in tmp_path.iterdir()] == ["run.csv"]  # nothing is left behind


def test_the_folder_of_init_is_opened_at_its_scenarios(tmp_path):
    scenarios = tmp_path / "scenarios"
    shutil.copytree(shipped_scenarios(), scenarios)
    assert opened_at(tmp_path) == (scenarios, None)
    shutil.copy(scenarios / "wear_rig.yaml", tmp_path)
    assert opened_at(tmp_path) == (tmp_path, None)


def test_a_missing_extra(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("torquerig.studio.server.start.find_spec", lambda name: None)
    assert "pip install 'torquerig[studio]'" in refused(capsys, tmp_path)
