"""Every writable format gives back what it was given: samples, rate, run, scale, origin; and twice the same bytes."""

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import open_stream, read_recording, write_recording
from torquerig.recordings.files import writing as writing_module
from torquerig.recordings.files.block_writing import write_blocks
from torquerig.recordings.files.blocks import Blocking
from torquerig.recordings.files.parquet import compact
from torquerig.recordings.files.sidecar import read_sidecar
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

ENDINGS = [".parquet", ".csv", ".mat", ".tdms"]
RUN = Run(
    motor="bldc-12n14p",
    gear_ratio=5.0,
    speed=1000 * 2 * pi / 60,
    profile="ramp",
    occupancy_percent=11.0,
    particle_size=0.98e-3,
    others={"operator": "no", "bench": "1e5", "note": "μ, 5 %: #3", "count": 3},
)


def recording(samples: int = 3000) -> Recording:
    rng = np.random.default_rng(7)
    torque = rng.standard_normal(samples) / 3
    torque[:5] = [0.0, -0.0, 1e-300, -1.7976931348623157e308, 0.1]
    return Recording(
        sample_rate=25000.0,
        channels={
            "torque_V": Channel(values=torque, quantity="torque", unit="V", si_per_unit=5.0),
            "encoder_count": Channel(
                values=np.arange(samples) * 11.0 + 411900,
                quantity="motor_angle",
                unit="count",
                si_per_unit=2 * pi / 16384,
            ),
            "load_torque": Channel(values=torque.clip(-1, 1) ** 3, quantity="torque", unit="N*m", truth=True),
        },
        run=RUN,
        origin={"scenario": "wear_rig", "seed": 7, "torquerig": "0.1.0"},
        name="made",
    )


@pytest.mark.parametrize("ending", ENDINGS)
def test_what_is_written_is_read_back(tmp_path: Path, ending: str) -> None:
    made = recording()
    path = tmp_path / f"run1{ending}"
    assert write_recording(made, path) == [path, tmp_path / "run1.yaml"]
    back = read_recording(path)
    assert back.sample_rate == made.sample_rate
    assert back.run == made.run
    assert back.origin == made.origin
    assert back.name == path.name
    assert list(back.channels) == list(made.channels)
    for name, channel in made.channels.items():
        other = back.channels[name]
        assert other.values.dtype == np.float64
        assert np.array_equal(other.values, channel.values), name
        assert replace(other, values=channel.values) == channel
    assert sorted(one.name for one in tmp_path.iterdir()) == sorted([path.name, "run1.yaml"])


@pytest.mark.parametrize("ending", ENDINGS)
def test_the_same_recording_gives_the_same_bytes(tmp_path: Path, ending: str) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        write_recording(recording(), tmp_path / folder / f"run1{ending}")
    for name in (f"run1{ending}", "run1.yaml"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_mat_holds_no_date(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run1.mat")
    assert b"Created on" not in (tmp_path / "run1.mat").read_bytes()[:128]


@pytest.mark.parametrize("speed", [1000 * 2 * pi / 60, 104.72, 0.0, -250 * 2 * pi / 60, 1 / 3])
def test_speed_survives_the_sheets_rpm(tmp_path: Path, speed: float) -> None:
    write_recording(replace(recording(), run=Run(speed=speed)), tmp_path / "r.parquet")
    assert read_recording(tmp_path / "r.parquet").run.speed == pytest.approx(speed, rel=3e-16)


def test_round_set_points_stand_round_in_the_sidecar(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "r.parquet")
    text = (tmp_path / "r.yaml").read_text(encoding="utf-8")
    for line in ("sample_rate_Hz: 25000\n", "speed_rpm: 1000\n", "particle_size_mm: 0.98\n", "counts_per_rev: 16384\n"):
        assert line in text
    assert "Nm_per_V: 5\n" in text


@pytest.mark.parametrize(
    ("quantity", "unit", "si_per_unit"),
    [
        ("torque", "V", 0.1),
        ("torque", "N*m", 1.0),
        ("torque", "mNm", 1e-3),
        ("torque", "N*m", 0.97),
        ("force", "V", 35.15),
        ("motor_angle", "count", 1e-3),
        ("motor_angle", "count", -2 * pi / 4096),
        ("speed", "rad/s", 1.0),
        ("motor_speed", "V", 31.4),
        ("velocity", "m/s", 1.0),
        ("tacho", "V", 1.0),
        ("tacho", "V", 5.0),
        ("temperature", "degC", 1.0),
    ],
)
def test_every_scale_survives_the_sidecar(tmp_path: Path, quantity: str, unit: str, si_per_unit: float) -> None:
    channel = Channel(values=np.arange(4.0), quantity=quantity, unit=unit, si_per_unit=si_per_unit)
    path = tmp_path / "r.parquet"
    write_recording(Recording(sample_rate=1000.0, channels={"x": channel}), path)
    assert read_recording(path).channels["x"].si_per_unit == si_per_unit


@pytest.mark.parametrize(
    ("values", "kind"),
    [
        ([1.0, -5.0, 2.0**31 - 1], np.int32),
        ([0.5, 0.25, 3.0], np.float32),
        ([0.1, 0.5], np.float64),
        ([2.0**31, 1.0], np.float32),
        ([2.0**31 + 1, 1.0], np.float64),
        ([-0.0, 1.0], np.float32),
        ([1e300, 1.0], np.float64),
    ],
)
def test_parquet_takes_the_smallest_exact_type(values: list[float], kind: type) -> None:
    packed = compact(np.array(values))
    assert packed.dtype == kind
    assert np.array_equal(packed.astype(np.float64), values)


def test_nothing_is_overwritten_unasked(tmp_path: Path) -> None:
    path = tmp_path / "run1.parquet"
    write_recording(recording(), path)
    before = path.read_bytes(), (tmp_path / "run1.yaml").read_bytes()
    with pytest.raises(InputError, match=r"run1\.parquet: is there already; choose another name"):
        write_recording(recording(100), path)
    written = write_recording(recording(100), tmp_path / "run1.csv")
    assert [one.name for one in written] == ["run1.csv", "run1.csv.yaml"]
    assert before == (path.read_bytes(), (tmp_path / "run1.yaml").read_bytes())
    write_recording(recording(100), path, overwrite=True)
    assert read_recording(path).samples == 100


def test_a_scenario_of_that_name_is_never_overwritten(tmp_path: Path) -> None:
    (tmp_path / "wear_rig.yaml").write_text("rig: {parts: []}\n")
    with pytest.raises(InputError, match=r"wear_rig\.yaml: is there already and is no sidecar"):
        write_recording(recording(), tmp_path / "wear_rig.parquet", overwrite=True)
    assert (tmp_path / "wear_rig.yaml").read_text() == "rig: {parts: []}\n"


def test_a_break_leaves_the_old_files_and_no_half_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "run1.csv"
    write_recording(recording(50), path)
    before = path.read_bytes()

    def broken(_: Recording, partial: Path) -> None:
        partial.write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(writing_module, "WRITERS", {".csv": broken})
    with pytest.raises(KeyboardInterrupt):
        write_recording(recording(60), path, overwrite=True)
    assert path.read_bytes() == before
    assert sorted(one.name for one in tmp_path.iterdir()) == ["run1.csv", "run1.yaml"]


def test_what_could_not_be_read_back_is_not_written(tmp_path: Path) -> None:
    made = recording(20)
    bad = made.with_values("torque_V", np.full(20, np.nan))
    with pytest.raises(RecordingError, match=r"torque_V has 20 samples not a finite number"):
        write_recording(bad, tmp_path / "r.parquet")
    with pytest.raises(RecordingError, match=r"unequal numbers of samples"):
        write_recording(made.with_values("torque_V", np.zeros(19)), tmp_path / "r.parquet")
    with pytest.raises(InputError, match=r"'.wav' cannot be written; use .parquet, .csv, .mat, .tdms"):
        write_recording(made, tmp_path / "r.wav")
    with pytest.raises(InputError, match=r"there is no folder .*missing; make it first"):
        write_recording(made, tmp_path / "missing" / "r.csv")
    named = replace(made, channels={"motor torque": made.channels["torque_V"]})
    with pytest.raises(InputError, match=r"'motor torque' cannot name a MATLAB variable"):
        write_recording(named, tmp_path / "r.mat")
    assert list(tmp_path.iterdir()) == []


def test_reserved_time_column_is_refused(tmp_path: Path) -> None:
    made = replace(recording(20), channels={"time_s": recording(20).channels["torque_V"]})
    with pytest.raises(InputError, match=r"'time_s' names the time"):
        write_recording(made, tmp_path / "r.csv")


def test_csv_quotes_names_with_separators(tmp_path: Path) -> None:
    made = recording(20)
    named = replace(made, channels={"a, b; c": made.channels["torque_V"], 'd "e" f': made.channels["load_torque"]})
    write_recording(named, tmp_path / "r.csv")
    back = read_recording(tmp_path / "r.csv")
    for name, channel in named.channels.items():
        assert np.array_equal(back.channels[name].values, channel.values)


def test_csv_tells_its_rate_without_the_sidecar(tmp_path: Path) -> None:
    made = recording()
    write_recording(replace(made, channels={"torque_Nm": made.channels["load_torque"]}), tmp_path / "r.csv")
    (tmp_path / "r.yaml").unlink()
    assert read_recording(tmp_path / "r.csv").sample_rate == 25000.0


def test_mat_and_tdms_tell_their_rate_without_the_sidecar(tmp_path: Path) -> None:
    made = replace(recording(), sample_rate=12800.0)
    for ending in (".mat", ".tdms"):
        write_recording(replace(made, channels={"torque_Nm": made.channels["load_torque"]}), tmp_path / f"r{ending}")
        assert read_sidecar(tmp_path / "r.yaml").sample_rate == 12800.0
        (tmp_path / "r.yaml").unlink()
        assert read_recording(tmp_path / f"r{ending}").sample_rate == 12800.0


@pytest.mark.parametrize("ending", ["parquet", "tdms", "mat"])
def test_a_file_that_is_mailed_alone_opens_with_its_sidecar(ending: str, tmp_path: Path) -> None:
    whole = recording()
    for name in ("whole", "blocks"):
        path = tmp_path / f"{name}.{ending}"
        if name == "whole":
            write_recording(whole, path)
        else:
            write_blocks([whole], path)
        path.with_suffix(".yaml").unlink()
        for back in (read_recording(path), next(Blocking(samples=whole.samples).cut(open_stream(path))).recording):
            assert back.run == whole.run
            assert back.sample_rate == whole.sample_rate
            assert {
                key: (one.quantity, one.unit, one.si_per_unit, one.truth) for key, one in back.channels.items()
            } == {key: (one.quantity, one.unit, one.si_per_unit, one.truth) for key, one in whole.channels.items()}
