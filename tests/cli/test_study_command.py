"""``torquerig study`` and ``torquerig optimise``: answers first, resumed stores, bad input in one sentence."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from torquerig.catalog.shipped import shipped_folder
from torquerig.cli import group, main

WEAR_RIG = str(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
SMALL = [
    "--set", "study.motors=[bldc-12n14p]", "--set", "study.gearboxes=[reference-5-1]", "--set", "study.duration=0.2 s",
    "--set", "study.filters.names=[none, low_pass_20Hz]", "--set", "study.present.filter=none",
]  # fmt: skip
PINNED = ["--set", "study.gearboxes=[reference-5-1, spur-2.5-1]", "--set", "gearbox.ratio=5"]


@pytest.mark.long
def test_draws_are_answered_and_continued(tmp_path: Path) -> None:
    def run(draws: int) -> str:
        store = str(tmp_path / "store")
        made = CliRunner().invoke(
            group, ["study", WEAR_RIG, "--draws", str(draws), "--store", store, "--workers", "1", *SMALL, *PINNED]
        )
        assert made.exit_code == 0, made.output
        return made.stdout

    first = run(2)
    assert first.startswith("bldc-12n14p 5:1 is the best drive: it is first in 100% of 2 draws (at least ")
    assert "2 cases, 2 of them computed now" in first
    assert "Not compared: spur-2.5-1. --set gearbox.ratio=5" in " ".join(first.split())
    assert "3 cases, 1 of them computed now" in run(3)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["study", WEAR_RIG, "--draws", "0"], "0 is not in the range x>=1"),
        (["study", WEAR_RIG, "--sensitivity", "sobol", "--draws", "3", *SMALL], "needs a power of two; write 2 or 4"),
        (["study", WEAR_RIG, "--cluster", "tcp://127.0.0.1:1", "--workers", "2"], "a cluster has a fixed number"),
        (["optimise", WEAR_RIG, "--crossover", "60..5", *SMALL], "the crossover from 60 to 5 Hz is no range"),
        (["optimise", WEAR_RIG, "--crossover", "5-60", *SMALL], "'5-60' is no range; write both ends, such as 5..60"),
        (["optimise", WEAR_RIG, "--gearbox", "reference-5-2", *SMALL], "did you mean 'reference-5-1'"),
        (
            ["optimise", WEAR_RIG, "--set", "gearbox.ratio=5", "--gearbox", "spur-2.5-1"],
            "leave out this ratio, or --gearbox",
        ),
        (
            ["size", WEAR_RIG, "--set", "gearbox.ratio=5", "--gearbox", "spur-2.5-1"],
            "leave out this ratio, or --gearbox",
        ),
        (["optimise", WEAR_RIG, "--motor", "bldc", *SMALL], "there is no motor 'bldc' in the catalog"),
    ],
)
def test_bad_input_is_one_sentence(
    arguments: list[str], said: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    told = capsys.readouterr()
    assert said in " ".join(told.err.split())
    assert "Traceback" not in told.err
    assert not list(tmp_path.iterdir())
