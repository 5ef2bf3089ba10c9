"""``torquerig synth fault`` as a user meets it: by name, from a file, into any recording, and bad input."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import yaml

from torquerig.cli import main
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.synthetic.faults.registry import BY_NAME

SHORT = ("--duration", "4 s", "--rate", "2 kHz")


def run(*arguments: str) -> int:
    """Run the command line in this process and return its exit code."""
    try:
        main(arguments)
    except SystemExit as stopped:
        return int(stopped.code or 0)
    return 0


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_the_list_names_all_faults_with_their_parameters(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("synth", "fault", "--list") == 0
    told = capsys.readouterr().out
    for name, fault in BY_NAME.items():
        assert f"{name}: " in told
        assert all(parameter in told for parameter in fault.parameters())
    assert "100 per minute" in told
    assert told.count("no command names it: ") == sum(not one.named_by for one in BY_NAME.values())


def test_the_defaults_in_the_list_can_be_written_as_they_are() -> None:
    from torquerig.synthetic.description import named_fault
    from torquerig.synthetic.faults.parameter_table import parameter_rows

    for name, fault in BY_NAME.items():
        settings = [f"{parameter}={default}" for parameter, default, _ in parameter_rows(fault)]
        read = named_fault(name, settings)
        for parameter, (_, default) in fault.parameters().items():
            value = getattr(read, parameter)
            assert value == (pytest.approx(default, rel=1e-5) if isinstance(default, float) else default)


@pytest.mark.parametrize("ending", [".parquet", ".csv", ".mat", ".tdms"])
def test_a_fault_in_every_format_and_twice_the_same(ending: str) -> None:
    for name in ("a", "b"):
        Path(name).mkdir()
        assert run("synth", "fault", "spikes", *SHORT, "--set", "rate=60 per minute", "--out", f"{name}/x{ending}") == 0
    assert Path(f"a/x{ending}").read_bytes() == Path(f"b/x{ending}").read_bytes()
    made = read_recording(Path(f"a/x{ending}"))
    off = made.torque() - made.channels["undisturbed_torque_V"].in_si()
    assert np.count_nonzero(off) == 4
    assert np.array_equal(off != 0, made.channels["affected_by_spikes"].values == 1)
    assert np.abs(off[off != 0]) == pytest.approx(0.5)
    assert made.channels["affected_by_spikes"].truth


def test_the_origin_holds_the_parameters_and_the_seed() -> None:
    assert run("synth", "fault", "spikes", *SHORT, "--set", "height=20 mN*m", "--seed", "7") == 0
    origin = yaml.safe_load(Path("synthetic.yaml").read_text())["origin"]
    assert origin["faults"] == [{"type": "spikes", "height": pytest.approx(0.02), "rate": pytest.approx(1 / 3)}]
    assert origin["faults_seed"] == 7


def test_faults_of_a_file_in_any_recording() -> None:
    values = 100 + np.random.default_rng(1).standard_normal(4000)
    channels = {"Kraft": Channel(values=values, quantity="force", unit="N")}
    write_recording(Recording(sample_rate=1e3, channels=channels), Path("mine.csv"))
    Path("faults.yaml").write_text("faults:\n  - {type: drift, span: 3 N}\n  - {type: held_samples, every: 2}\n")
    assert run("synth", "fault", "faults.yaml", "--from", "mine.csv", "--out", "made.parquet") == 0
    made = read_recording(Path("made.parquet"))
    assert np.array_equal(made.channels["undisturbed_Kraft"].values, values)
    assert made.torque()[-2:] == pytest.approx(values[-2] + 3, abs=0.01)


def test_a_mixture_may_have_faults() -> None:
    Path("m.yaml").write_text(
        "duration: 2 s\nsample_rate: 1 kHz\ncomponents:\n  mean: {type: constant, part: load, torque: 1 N*m}\n"
        "faults:\n  - {type: mean_steps, height: 0.2 N*m, rate: 30 per minute}\n"
    )
    assert run("synth", "mixture", "m.yaml", "--out", "made.parquet") == 0
    made = read_recording(Path("made.parquet"))
    assert made.torque()[-1] == pytest.approx(1.2)
    assert np.all(made.channels["true_load_Nm"].values == 1)


@pytest.mark.parametrize(("name", "states"), [("late_stamps", False), ("coarse_stamps", False), ("wrong_rate", True)])
def test_a_csv_holds_the_stamps_and_the_sidecar_does_not_tell_the_rate(name: str, *, states: bool) -> None:
    assert run("synth", "fault", name, "--out", "x.csv") == 0
    assert ("sample_rate_Hz" in yaml.safe_load(Path("x.yaml").read_text())) == states
    times = np.loadtxt("x.csv", delimiter=",", skiprows=1, usecols=0)
    assert times[-1] == pytest.approx(12, abs=0.01)
    assert np.all(np.diff(times) >= 0)
    if not states:
        assert read_recording(Path("x.csv")).sample_rate == pytest.approx(5000)


def test_missing_rows_keep_the_time_and_the_truth_of_the_others() -> None:
    assert run("synth", "fault", "missing_samples", *SHORT, "--set", "length=3", "--out", "x.csv") == 0
    names = Path("x.csv").read_text().partition("\n")[0].split(",")
    table = np.loadtxt("x.csv", delimiter=",", skiprows=1)
    numbers = table[:, names.index("true_sample_number")]
    assert table.shape[0] == 8000 - 3
    assert table[:, 0] == pytest.approx(numbers / 2000)
    assert table[:, names.index("affected_by_missing_samples")].sum() == 1


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("spike",), "there is no fault 'spike'; did you mean 'spikes'?"),
        (("spikes", "--set", "height=3"), "--set height=3: height: 3 has no unit; write '3 N*m'"),
        (("spikes", "--set", "hight=3 N*m"), "hight: unknown key; did you mean 'height'?"),
        (("spikes", "--set", "height"), "--set height: not of the form parameter=value"),
        (("spikes", "--set", "rate=20 1/min"), "rate"),
        (("held_samples", "--set", "every=1.5"), "every: 1.5 is no whole number"),
        (("wrapped_angle", "--set", "unit=degree"), "'degree' is unknown; did you mean 'deg'?"),
        (("late_stamps",), "which synth writes to .csv alone; write --out synthetic.csv"),
        (("spikes", "--from", "nope.csv"), "nope.csv: there is no such file"),
        (("spikes", "--from", "."), "."),
        (("spikes", "--from", "m.csv", "--rate", "1 kHz"), "remove --duration and --rate"),
        (("nope.yaml",), "nope.yaml: there is no such file"),
        (("f.yaml", "--set", "height=1 N*m"), "f.yaml states the parameters of its faults"),
        (("f.yaml",), "f.yaml:1: faults.0: the fault has no known type ('spike'); did you mean 'spikes'"),
        (("lists.yaml",), "the fault has no known type ('[1]')"),
        (("number.yaml",), "number.yaml:1: faults.0: 3 is no fault; write for example {type: spikes"),
        (("empty.yaml",), "empty.yaml:1: lists no faults; write faults: with one entry each"),
        (("mixture.yaml",), "describes a mixture; use torquerig synth mixture mixture.yaml"),
        (("spikes", "--duration", "0 s"), "--duration: 0 is not possible; write more than 0"),
    ],
)
def test_bad_input_is_one_sentence(words: tuple[str, ...], told: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("f.yaml").write_text("faults: [{type: spike}]\n")
    Path("lists.yaml").write_text("faults: [{type: [1]}]\n")
    Path("number.yaml").write_text("faults: [3]\n")
    Path("empty.yaml").write_text("faults: []\n")
    Path("mixture.yaml").write_text("components: {}\nfaults: [{type: spikes}]\n")
    before = set(Path().iterdir())
    assert run("synth", "fault", *words) == 2
    said = capsys.readouterr()
    assert told in said.err
    assert said.err.count("\n") == 1
    assert said.out == ""
    assert set(Path().iterdir()) == before
