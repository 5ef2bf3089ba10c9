"""``python -m proof`` with bad input."""

import pytest

from proof.__main__ import main


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--seed", "1"), "--out"),
        (("--out", "x"), "--seed"),
        (("--seed", "1", "--out", "x", "--practice", "nowhere"), "nowhere"),
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
        main(arguments)
    assert left.value.code == 2
    out, err = capsys.readouterr()
    assert told in err
    assert err.count("\n") == 1
    assert out == ""
    assert not (tmp_path / "x").exists()
