"""``torquerig prove`` without its folder, and with wrong ones."""

import sys

import pytest

from torquerig.cli import main
from torquerig.cli import prove as command
from torquerig.errors import InputError


def test_without_proof_one_sentence_says_what_to_do(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command, "find_spec", lambda name: None)
    monkeypatch.setattr(command, "CHECKOUT", tmp_path)
    before = list(sys.path)
    with pytest.raises(InputError, match="get a checkout"):
        command.find_proof(tmp_path)
    with pytest.raises(SystemExit) as left:
        main(["prove", "--seed", "1", "--cases", "1", "--out", "x"])
    assert left.value.code == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert "needs the folder proof/" in err
    assert sys.path == before


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--seed", "1"), "--out"),
        (("--out", "x"), "--seed"),
        (("--seed", "1", "--out", "x", "--practice", "nowhere"), "nowhere"),
        (("--seed", "1", "--out", "x", "--real", "nowhere"), "nowhere: there is no such folder"),
        (("--seed", "1", "--out", "x", "--practice", "empty"), "answers.yaml: not found"),
        (("--seed", "1", "--out", "x", "--duration", "1"), "--duration"),
        (("--seed", "1", "--out", "file"), "file"),
    ],
)
def test_bad_input_is_told_in_one_sentence(arguments, told, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    (tmp_path / "file").write_text("kept")
    with pytest.raises(SystemExit) as left:
        main(["prove", *arguments])
    assert left.value.code == 2
    out, err = capsys.readouterr()
    assert told in err
    assert err.count("\n") == 1
    assert out == ""
    assert not (tmp_path / "x").exists()
