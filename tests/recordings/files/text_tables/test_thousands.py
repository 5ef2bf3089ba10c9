"""Numbers that may have thousands are refused with both readings; what is cut off or below the rows is left out."""

from pathlib import Path

import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.joining.join import join_recordings

HEAD = "Zeit [ms];Drehmoment [mNm];Drehzahl [1/min]\n"


def grouped(number: int) -> str:
    return f"{number:,}".replace(",", ".")


def written(path: Path, text: str) -> Path:
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    ("torque", "step"), [(2003, 5), (1502, 1), (998, 5)], ids=["all grouped", "times too", "mixed with integers"]
)
def test_whole_numbers_with_points_are_refused(tmp_path: Path, torque: int, step: int) -> None:
    rows = "".join(f"{grouped(step * k)};{grouped(torque + k % 7)};{grouped(1500 + k % 3)}\n" for k in range(300))
    path = written(tmp_path / "run1.csv", HEAD + rows)
    for read in (read_recording, lambda one: next(open_stream(one).columns())):
        with pytest.raises(RecordingError, match=r"may be (\d+) or \d\.\d{3}; write numbers without"):
            read(path)


def test_points_that_begin_far_below_are_refused(tmp_path: Path) -> None:
    rows = "".join(f"{k};{grouped(999 + (k > 600))};{500 + k % 3}\n" for k in range(900))
    with pytest.raises(RecordingError, match=r"run1.csv:603: '1.000' may be 1000 or 1.000"):
        read_recording(written(tmp_path / "run1.csv", HEAD + rows))


def test_the_remedies_work(tmp_path: Path) -> None:
    rows = [(5 * k, 2003 + k % 7, 1500 + k % 3) for k in range(300)]
    path = written(tmp_path / "run1.csv", HEAD + "".join(f"{a};{b};{c}\n" for a, b, c in rows))
    assert read_recording(path).channels["Drehmoment"].values.max() == pytest.approx(2009)
    text = HEAD.replace(";", "\t") + "".join(f"{a}\t{b / 1000:.3f}\t{c / 1000:.3f}\n" for a, b, c in rows)
    assert read_recording(written(path, text)).channels["Drehmoment"].values.max() == pytest.approx(2.009)


@pytest.mark.parametrize("other", ["0.5", "12.25", "1502.125", "1502"])
def test_another_number_shows_the_decimal_point(tmp_path: Path, other: str) -> None:
    rows = "".join(f"{k};1.{500 + k % 3};{other if k % 9 else '1.125'}\n" for k in range(100))
    recording = read_recording(written(tmp_path / "run1.csv", HEAD + rows))
    assert recording.channels["Drehmoment"].values.max() == pytest.approx(1.502)


def test_points_above_decimal_commas_are_thousands(tmp_path: Path) -> None:
    rows = "".join(f"{k},0;{grouped(998 + k % 7)};1500,{k % 3}\n" for k in range(100))
    recording = read_recording(written(tmp_path / "run1.csv", HEAD + rows))
    assert recording.channels["Drehmoment"].values.max() == 1004
    alone = "".join(f"{k},0;{grouped(2000 + k % 7)};1500,{k % 3}\n" for k in range(100))
    with pytest.raises(RecordingError, match=r"'2.000' may be 2000 or 2.000"):
        read_recording(written(tmp_path / "run1.csv", HEAD + alone))


@pytest.mark.parametrize(
    ("cell", "stated", "rate"),
    [("2,5", "2.000 Hz", 2000), ("2.5", "2.000 kHz", 2000), ("2", "2.000 Hz", None), ("2.5", "1,000 Hz", 1000)],
)
def test_a_rate_above_the_table(tmp_path: Path, cell: str, stated: str, rate: float | None) -> None:
    rows = "".join(f"{cell}{k % 9 or 1};{k}\n" for k in range(100))
    path = written(tmp_path / "run1.csv", f"Abtastrate: {stated}\n\nDrehmoment [Nm];Drehzahl [1/min]\n{rows}")
    if rate is None:
        with pytest.raises(RecordingError, match="sample rate is not stated"):
            read_recording(path)
    else:
        assert read_recording(path).sample_rate == rate


ROWS = "Time [s],Torque [Nm],Speed [rpm]\n" + "".join(f"{k / 2000:.4f},2.{k % 9},{998 + k % 9}\n" for k in range(300))


@pytest.mark.parametrize("end", ["\n,2.000,1002\n,1.6,990\n", ",2.000,1002\n", "0.1500,2.1,10", "0.1500,2.1,9"])
def test_what_is_no_row_is_left_out(tmp_path: Path, end: str) -> None:
    path = written(tmp_path / "run1.csv", ROWS + end)
    assert read_recording(path).samples == 300
    assert any("not read" in note for note in open_stream(path).table.notes)
    assert join_recordings([path]).recording.channels["Speed"].values.min() >= 997.9


def test_a_whole_last_row_is_kept(tmp_path: Path) -> None:
    assert read_recording(written(tmp_path / "run1.csv", ROWS + "0.1500,2.1,997")).samples == 301


def test_a_missing_time_is_named_by_join(tmp_path: Path) -> None:
    lines = ROWS.splitlines()
    lines[40] = ",2.0,1000"
    with pytest.raises(RecordingError, match="has no time for sample 39"):
        join_recordings([written(tmp_path / "run1.csv", "\n".join(lines) + "\n")])


@pytest.mark.parametrize("missing", ["", "nan"])
@pytest.mark.parametrize(("time", "other"), [(".", ","), (",", ".")])
def test_a_column_with_the_other_decimal_sign(tmp_path: Path, time: str, other: str, missing: str) -> None:
    def cell(value: float, sign: str, digits: int) -> str:
        return f"{value:.{digits}f}".replace(".", sign)

    rows = [
        f"{cell(k / 2000, time, 4)};{missing if k == 40 else cell(2 + k % 7 / 10, other, 1)};{cell(15.25, other, 2)}\n"
        for k in range(2600)
    ]
    path = written(tmp_path / "run1.csv", "Time [s];Torque [Nm];Speed [rpm]\n" + "".join(rows))
    columns = next(iter(open_stream(path).columns()))
    assert columns["Time"] == pytest.approx([k / 2000 for k in range(2600)])
    assert columns["Torque"][1:7] == pytest.approx([2.1, 2.2, 2.3, 2.4, 2.5, 2.6])
    assert any("is the decimal sign of Time" in note for note in open_stream(path).table.notes)


def test_a_faulty_time_has_no_remedy_in_a_sidecar(tmp_path: Path) -> None:
    lines = ROWS.splitlines()
    lines[40] = "0.0.195,2.0,1000"
    with pytest.raises(RecordingError, match=r"correct the cell or delete the row$"):
        read_recording(written(tmp_path / "run1.csv", "\n".join(lines) + "\n"))
