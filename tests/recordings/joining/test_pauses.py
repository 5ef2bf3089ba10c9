"""Files with pauses: what info says of their rate and length, and how they become recordings."""

import json
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.errors import RecordingError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.gaps import Gap
from torquerig.recordings.inspection.pauses import pauses_of, time_span
from torquerig.recordings.joining.join import join_recordings, split_recording

RATE, PLACES, PER_PLACE, PAUSE = 80.0, 40, 60, 2.5


def standstill_map(path: Path, *, pause: float = PAUSE) -> None:
    """Place by place: 60 samples at 80 Hz at standstill, then a pause in which the axis moves on."""
    rows, start = [], 0.0
    for place in range(PLACES):
        times = start + np.arange(PER_PLACE) / RATE
        rows += [f"{one:.6f},{place},{20 + place % 7}\n" for one in times]
        start = times[-1] + pause
    path.write_text("time [s],position [mm],force [N]\n" + "".join(rows))


def refused(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    with pytest.raises(SystemExit) as left:
        main(tuple(map(str, arguments)))
    assert left.value.code == 2
    return capsys.readouterr().err


def test_pauses_and_the_time_from_the_first_to_the_last_sample() -> None:
    gaps = [Gap(sample=99, time=1.0, step=3.0), Gap(sample=149, time=4.5, step=0.03), Gap(299, 6.0, 1.0)]
    found = pauses_of(gaps, rate=100.0, samples=400)
    assert found is not None
    assert (found.count, found.shortest, found.longest, found.total) == (2, 1.0, 3.0, 4.0)
    assert found.stretches == (1.0, 2.0)
    assert time_span(gaps, rate=100.0, samples=400) == pytest.approx(4.0 + 2.99 + 0.02 + 0.99)
    assert pauses_of(gaps[1:2], rate=100.0, samples=400) is None


def test_info_says_the_rate_between_pauses_their_number_and_the_whole_time(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    standstill_map(tmp_path / "map.csv")
    main(("info", str(tmp_path / "map.csv")))
    told = " ".join(capsys.readouterr().out.split())
    seconds = PLACES * (PER_PLACE - 1) / RATE + (PLACES - 1) * PAUSE + 1 / RATE
    assert "2400 samples at 80 Hz between pauses, 30 s of them; 127.01" in told
    assert "39 pauses of 2.5 s" in told or "39 pauses of 2.5 to 2.5 s" in told
    main(("info", "--json", str(tmp_path / "map.csv")))
    (found,) = json.loads(capsys.readouterr().out)["recordings"]
    assert found["span_s"] == pytest.approx(seconds, rel=1e-6)
    assert found["pauses"]["count"] == PLACES - 1
    assert found["sample_rate_Hz"] == RATE


def test_a_standstill_map_becomes_one_recording_where_its_pauses_are_bridged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    standstill_map(tmp_path / "map.csv")
    out = tmp_path / "joined.parquet"
    said = refused(capsys, "join", tmp_path / "map.csv", "--out", out)
    assert "--bridge '2.5 s'" in said
    assert "--split" in said
    main(("join", str(tmp_path / "map.csv"), "--out", str(out), "--bridge", "2.5 s"))
    joined = read_recording(out)
    assert joined.duration == pytest.approx(PLACES * (PER_PLACE - 1) / RATE + (PLACES - 1) * PAUSE, abs=2 / RATE)
    assert joined.channels["position"].values[0] == 0
    assert joined.channels["position"].values[-1] == pytest.approx(PLACES - 1)


def test_each_stretch_becomes_a_recording(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    standstill_map(tmp_path / "map.csv")
    arguments = ("join", str(tmp_path / "map.csv"), "--out", str(tmp_path / "part.parquet"), "--split")
    main(arguments)
    assert f"wrote {PLACES} recordings" in " ".join(capsys.readouterr().out.split())
    written = sorted(tmp_path.glob("part-*.parquet"))
    assert len(written) == PLACES
    assert written[0].name == "part-001.parquet"
    for number in (0, 17, PLACES - 1):
        part = read_recording(written[number])
        assert part.samples in (PER_PLACE - 1, PER_PLACE)
        assert part.sample_rate == RATE
        assert set(part.channels["position"].values) == {number}
    assert "part-001.parquet" in refused(capsys, *arguments)  # nothing is overwritten


def test_uneven_times_without_pauses_are_bridged(tmp_path: Path) -> None:
    times = np.cumsum(np.random.default_rng(2).uniform(0.2, 1.6, 300))
    rows = "".join(f"{one:.4f},{2 * one:.4f},1\n" for one in times)
    (tmp_path / "map.csv").write_text("time [s],position [mm],force [N]\n" + rows)
    with pytest.raises(RecordingError, match=r"--bridge '1\.6 s'"):
        join_recordings([tmp_path / "map.csv"])
    joined = join_recordings([tmp_path / "map.csv"], longest_gap=1.6).recording
    expected = 2 * (times[0] + joined.time())[:-1]  # the last grid point may lie half a step beyond the last time
    assert joined.channels["position"].values[:-1] == pytest.approx(expected, abs=1e-3)


def test_short_stretches_are_left_out_and_counted(tmp_path: Path) -> None:
    times = [*np.arange(50) / 100, *(5 + np.arange(2) / 100), *(9 + np.arange(80) / 100)]
    (tmp_path / "run.csv").write_text("time [s],torque [Nm]\n" + "".join(f"{one:.3f},{one:.3f}\n" for one in times))
    parts = split_recording(tmp_path / "run.csv")
    assert len(parts) == 2
    assert any("1 stretches of fewer than 4 samples" in note for note in parts[0].notes)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--bridge", "0 s"), "write for example '2 s'"),
        (("--bridge", "2"), "--bridge"),
        (("other.csv", "--split"), "cuts one recording"),
    ],
)
def test_what_cannot_be_done_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...],
    said: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    standstill_map(tmp_path / "map.csv")
    assert said in refused(capsys, "join", "map.csv", *arguments, "--out", "out.parquet")


def test_a_folder_lists_texts_that_are_no_recordings(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    standstill_map(tmp_path / "map.csv", pause=0.5)
    (tmp_path / "LICENSE.txt").write_text("Permission is hereby granted\n")
    main(("info", str(tmp_path)))
    told = capsys.readouterr().out
    assert "LICENSE.txt: not a recording: " in told
    assert "2400 samples" in told
    main(("info", "--json", str(tmp_path)))
    assert len(json.loads(capsys.readouterr().out)["recordings"]) == 2
    assert "no row of numbers" in refused(capsys, "info", tmp_path / "LICENSE.txt")
    (tmp_path / "map.csv").unlink()
    assert "none of the 1 files is a recording" in refused(capsys, "info", tmp_path)


def test_a_damaged_recording_in_a_folder_still_fails(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    standstill_map(tmp_path / "map.csv", pause=0.5)
    (tmp_path / "run.parquet").write_bytes(b"PAR1 nothing")
    assert "1 of 2 files cannot be read" in refused(capsys, "info", tmp_path)


def test_a_channel_that_is_kept_and_not_used_needs_no_unit(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "run.csv").write_text("flag,torque\n1,2\n0,3\n1,4\n")
    sidecar = tmp_path / "run.yaml"
    sidecar.write_text(
        "sample_rate_Hz: 10\nchannels:\n  flag: {quantity: other}\n  torque: {quantity: torque, unit: N*m}\n"
    )
    read = read_recording(tmp_path / "run.csv")
    assert (read.channels["flag"].quantity, read.channels["flag"].unit) == ("other", "1")
    sidecar.write_text("sample_rate_Hz: 10\nchannels:\n  torque: {quantity: torque}\n")
    assert "channels.torque: the key 'unit' is missing" in refused(capsys, "filter", tmp_path / "run.csv")
