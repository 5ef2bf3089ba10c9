"""``torquerig synth`` as a user meets it: every subcommand once, the same bytes, one sentence for bad input."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main
from torquerig.recordings.files import read_recording

EXAMPLE = str(shipped_scenarios() / "mixture_example.yaml")
WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")


def run(*arguments: str) -> int:
    """Run the command line in this process and return its exit code."""
    try:
        main(("synth", *arguments))
    except SystemExit as stopped:
        return int(stopped.code or 0)
    return 0


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("ending", [".parquet", ".csv", ".mat", ".tdms"])
@pytest.mark.parametrize("words", [("control",), ("sweep", "--to", "400 Hz")], ids=lambda words: words[0])
def test_shortcuts_in_every_format_and_twice_the_same(words: tuple[str, ...], ending: str) -> None:
    for name in ("a", "b"):
        Path(name).mkdir()
        options = ("--duration", "1 s", "--rate", "1 kHz", "--speed", "600 rpm", "--ratio", "5", "--motor", "REF")
        assert run(*words, *options, "--seed", "2", "--out", f"{name}/x{ending}") == 0
    assert Path(f"a/x{ending}").read_bytes() == Path(f"b/x{ending}").read_bytes()
    made = read_recording(Path(f"a/x{ending}"))
    assert (made.samples, made.run.gear_ratio, made.run.motor) == (1000, 5.0, "REF")
    assert made.run.speed_rpm == pytest.approx(600)
    assert made.origin["seed"] == 2


def test_a_pair_adds_up_to_its_mixture(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("pair", EXAMPLE, "--out", "m.parquet", "--seed", "9") == 0
    assert capsys.readouterr().out.count("wrote ") == 3
    whole, load, noise = (read_recording(Path(f"m{word}.parquet")) for word in ("", "_load", "_noise"))
    assert np.array_equal(load.torque() + noise.torque(), whole.torque())
    assert whole.origin["seed"] == 9


def test_a_pair_is_written_only_where_all_three_can_be(capsys: pytest.CaptureFixture[str]) -> None:
    Path("m_noise.parquet").write_text("kept")
    assert run("pair", EXAMPLE, "--out", "m.parquet") == 2
    assert "m_noise.parquet: is there already" in capsys.readouterr().err
    assert [path.name for path in Path().iterdir()] == ["m_noise.parquet"]


def test_a_reading_is_taken_apart(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("effects", WEAR_RIG, "--duration", "0.2 s", "--out", "e.mat") == 0
    told = capsys.readouterr().out
    assert "difference of runs" in told
    assert "stage of the sensor" in told
    assert "component_load_Nm" in read_recording(Path("e.mat")).channels


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("control", "--duration", "5"), "--duration: '5' has no unit; write '5 s'"),
        (("control", "--amplitude", "0 N*m"), "--amplitude: 0 is not possible; write more than 0"),
        (("control", "--ratio", "-1"), "--ratio -1 is not possible"),
        (("control", "--out", "x.wav"), "the ending '.wav' cannot be written"),
        (("sweep", "--to", "20 kHz"), "sweep: 20000 Hz is not below half the sample rate"),
        (("mixture", WEAR_RIG), "is no mixture; write synthetic: NAME"),
        (("mixture", "nope.yaml"), "nope.yaml: there is no such file"),
        (("effects", EXAMPLE), "a scenario needs a mapping named rig"),
    ],
)
def test_bad_input_is_one_sentence(words: tuple[str, ...], told: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(*words) == 2
    said = capsys.readouterr()
    assert told in said.err
    assert said.err.count("\n") == 1
    assert said.out == ""
    assert not list(Path().iterdir())
