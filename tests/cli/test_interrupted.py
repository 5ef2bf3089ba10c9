"""Ctrl-C in a study says what is kept."""

from __future__ import annotations

import click
import pytest

from torquerig.cases import StudyStopped
from torquerig.cli import run


@pytest.mark.parametrize(
    ("stop", "sentence"),
    [
        (
            StudyStopped("interrupted; 3 of 9 cases are stored in store"),
            "interrupted; 3 of 9 cases are stored in store",
        ),
        (KeyboardInterrupt(), "interrupted; no file is incomplete"),
        (click.Abort(), "interrupted; no file is incomplete"),
    ],
)
def test_the_sentence_of_what_stopped_a_command_is_printed(
    stop: BaseException, sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    @click.command()
    def command() -> None:
        raise stop

    with pytest.raises(SystemExit) as ended:
        run(command, [], name="torquerig")
    assert ended.value.code == 130
    assert capsys.readouterr().err.strip() == f"torquerig: {sentence}"
