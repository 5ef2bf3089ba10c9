"""The same table in every dialect reads to the same numbers, names, units and rate."""

from pathlib import Path

import numpy as np
import pytest

from tests.recordings.files.text_tables.made_tables import ROWS, SPEED, TORQUE, dialects
from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.blocks import Blocking, sound_blocks
from torquerig.recordings.files.csv import csv_pieces, read_csv

DIALECTS = dialects()


@pytest.mark.parametrize("kind", DIALECTS)
def test_one_table_in_many_dialects(tmp_path: Path, kind: str) -> None:
    ending, content = DIALECTS[kind]
    path = tmp_path / f"run1{ending}"
    path.write_bytes(content)
    recording = read_recording(path)
    by_quantity = {one.quantity: one for one in recording.channels.values()}
    assert set(by_quantity) == {"torque", "speed"}
    assert recording.sample_rate == pytest.approx(1000, rel=1e-9)
    assert recording.samples == ROWS
    assert by_quantity["torque"].values == pytest.approx(TORQUE, abs=1e-12)
    assert by_quantity["speed"].values == pytest.approx(SPEED, abs=1e-9)
    assert (by_quantity["torque"].unit, by_quantity["speed"].unit) in {("N*m", "rpm"), ("Nm", "rpm")}
    assert {name.partition("_")[0] for name in recording.channels} == {"Torque", "Speed"}


# the first piece must reach behind the preamble; in a file it has 32 MiB
IN_PIECES = [kind for kind, (ending, _) in DIALECTS.items() if ending in (".csv", ".txt", ".asc")]
IN_PIECES.remove("long preamble")


@pytest.mark.parametrize("kind", IN_PIECES)
def test_pieces_are_the_whole(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "run1.csv"
    path.write_bytes(DIALECTS[kind][1])
    whole = read_csv(path)
    pieces = csv_pieces(path, step=max(len(DIALECTS[kind][1]) * 3 // 4, 300))
    parts = list(pieces.pieces(pieces.names))
    assert pieces.names == tuple(whole.columns)
    assert (pieces.units, pieces.skipped, pieces.rates) == (whole.units, whole.skipped, whole.rates)
    for name, values in whole.columns.items():
        assert np.array_equal(np.concatenate([part[name] for part in parts]), values)


def test_what_was_understood_is_noted(tmp_path: Path) -> None:
    path = tmp_path / "run1.csv"
    path.write_bytes(DIALECTS["units row"][1])
    table = open_stream(path).table
    assert "names in line 1, units in line 2, the comma is the decimal sign" in table.notes
    path.write_bytes(DIALECTS["ISO stamps"][1])
    assert any("time stamps of the column Timestamp (ISO 8601)" in note for note in open_stream(path).table.notes)
    path.write_bytes(DIALECTS["states"][1])
    assert open_stream(path).table.skipped == {"state": "words, for example 'S0'"}


@pytest.mark.parametrize(
    ("written", "readings"),
    [("time_s;speed_rpm\n1;1,234\n2;1,235\n", "'1,234' may be 1234 or 1.234"),
     ("time_s;torque_Nm;speed_rpm\n0.1;1.5;1,234\n0.2;1.6;1,235\n", "'1,234' may be 1234 or 1.234")],
)  # fmt: skip
def test_two_readings_of_a_number_are_named(tmp_path: Path, written: str, readings: str) -> None:
    path = tmp_path / "run1.csv"
    path.write_text(written)
    with pytest.raises(RecordingError, match=rf"run1\.csv:2: {readings}"):
        read_csv(path)


def test_a_sidecar_reads_its_columns_alone(tmp_path: Path) -> None:
    path = tmp_path / "run1.csv"
    path.write_text("time_s,torque_Nm,code\n0,1.5,7\n0.1,1.6,8\n0.2,1.7,E9\n")
    with pytest.raises(RecordingError, match="code: 'E9' is no number"):
        read_recording(path)
    path.with_suffix(".yaml").write_text("channels: {torque_Nm: {quantity: torque, unit: Nm}}\n")
    assert read_recording(path).torque() == pytest.approx([1.5, 1.6, 1.7])
    (block,) = sound_blocks(open_stream(path), Blocking(samples=9))
    assert block.recording.torque() == pytest.approx([1.5, 1.6, 1.7])


@pytest.mark.parametrize("word", ["OVLD", "1.#INF", "----", "-1.#IND", "#DIV/0!", "OL", "over range", "lost"])
def test_words_among_numbers_are_missing_samples(tmp_path: Path, word: str) -> None:
    path = tmp_path / "run1.csv"
    path.write_text(f"time_s;torque_Nm\n0;1,5\n0,1;{word}\n0,2;1,7\n0,3;1,5\n")
    table = read_csv(path)
    assert table.columns["torque_Nm"] == pytest.approx([1.5, np.nan, 1.7, 1.5], nan_ok=True)
    assert any("are missing samples: 1 of torque_Nm" in note for note in table.notes)
    with pytest.raises(RecordingError, match="torque_Nm has 1 sample not a finite number, the first at sample 1"):
        read_recording(path)


@pytest.mark.parametrize(
    ("line", "rate"),
    [("Rate: 1000 Hz", 1000), ("Samples per second: 960", 960), ("Sample interval: 0.5 ms", 2000),
     ("# fs = 25 kHz", 25e3), ("Sample rate [Hz];2.500,5", 2500.5),
     ("Abtastrate\t1000", 1000), ("Delta_X (s): 0,001", 1000),
     ("Sampling Frequency,51.2 kS/s", 51200)],
)  # fmt: skip
def test_a_rate_above_the_table(tmp_path: Path, line: str, rate: float) -> None:
    path = tmp_path / "run1.txt"
    path.write_text(f"Rig 5\n{line}\n\nTorque;Speed\nNm;rpm\n1,5;1000\n1,6;1000\n1,7;1000\n")
    recording = read_recording(path)
    assert recording.sample_rate == pytest.approx(rate, rel=1e-9)
    assert any(f"line 2 states {rate:g} samples per second" in note for note in open_stream(path).table.notes)


@pytest.mark.parametrize(
    "line", ["Baud rate: 9600", "Frequency: 50 Hz", "Sample rate: 1,000 Hz", "Interval: 5", "Rate: 3"]
)
def test_what_is_no_clear_rate_is_not_used(tmp_path: Path, line: str) -> None:
    path = tmp_path / "run1.txt"
    path.write_text(f"{line}\n\nTorque;Speed\nNm;rpm\n1,5;1000\n1,6;1000\n1,7;1000\n")
    with pytest.raises(RecordingError, match="the sample rate is not stated"):
        read_recording(path)


def test_units_above_the_table(tmp_path: Path) -> None:
    path = tmp_path / "run1.txt"
    path.write_text("Units: FTLB\n\nTime: Sample\n0.0 2.014\n0.1 2.02\n0.2 2.06\n")
    table = read_csv(path)
    assert table.units["Sample"] == "FTLB"


def test_a_faulty_row_keeps_its_line(tmp_path: Path) -> None:
    rows = [f"{number / 10:.1f};1,5" for number in range(30)]
    rows[17] = "1.7;1,5;3"
    path = tmp_path / "run1.csv"
    path.write_text("# rig\n\nTime;Torque\ns;Nm\n" + "\n".join(rows).replace(".", ",") + "\nEnd\n")
    with pytest.raises(RecordingError, match=r"run1\.csv:22: the row has 3 cells and the table 2 columns"):
        read_csv(path)


@pytest.mark.parametrize(
    "line",
    [
        "Messrate = 2000/s", "Sample rate;2000;Hz", "Sample rate\t2000\tHz", "Sample rate,2000,Hz", "Sample rate: 2k",
        "Abtastzeit 500 us", "Abtastzeit: 500 µs", "Sample interval;0.5;ms", "Sampling rate 2 kHz", "Rate: 2000 1/s",
    ],
)  # fmt: skip
def test_rates_as_loggers_write_them(tmp_path: Path, line: str) -> None:
    path = tmp_path / "run1.txt"
    path.write_text(f"Tester\n{line}\n\nTorque;Speed\nNm;rpm\n" + "1.5;1000\n1.6;1001\n" * 20)
    assert read_recording(path).sample_rate == 2000


def test_exponents_of_fortran(tmp_path: Path) -> None:
    path = tmp_path / "run1.txt"
    path.write_text(
        "time_s torque_Nm\n" + "".join(f"{k / 1000:.4e} {-2 - k:.3e}\n" for k in range(60)).replace("e", "D")
    )
    recording = read_recording(path)
    assert recording.sample_rate == 1000
    assert recording.channels["torque_Nm"].values == pytest.approx(-2 - np.arange(60))
