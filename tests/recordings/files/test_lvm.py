"""LVM files as LabVIEW writes them: rates from X_Value and Delta_X, units over the right column, segments, remarks."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.lvm import read_lvm
from torquerig.recordings.files.number_table import Table

Channel = tuple[str, str, float, list[float]]  # name, unit, Delta_X, samples


def text(
    channels: list[Channel], *, x_columns: str = "One", steps: list[float] | None = None, decimal: str = ".",
    gaps: bool = True, before: str = "", times: list[float] | None = None, moment: str = "", remarks: str = "",
) -> str:  # fmt: skip
    """Return one segment; ``steps`` are the true steps of the X values, else Delta_X."""
    multi = x_columns == "Multi"
    gap = "\t\t" if multi and gaps else "\t"
    tags = [
        ("Channels", [str(len(channels)), *[""] * (len(channels) - 1)]),
        ("Samples", [str(len(c[3])) for c in channels]),
    ]
    tags += [(tag, [cell] * len(channels)) for tag, cell in zip(("Date", "Time"), moment.split(), strict=False)]
    tags += [("Y_Unit_Label", [c[1] for c in channels]), ("X_Dimension", ["Time"] * len(channels))]
    tags += [("Delta_X", [f"{c[2]:.6f}" for c in channels])]
    header = [before] * bool(before) + [f"{tag}\t" + gap.join(cells) + "\t" for tag, cells in tags]
    names = [c[0] for c in channels]
    labels = "X_Value\t" + ("\tX_Value\t" if multi else "\t").join(names) + "\tComment"
    rows = []
    for row in range(max(len(c[3]) for c in channels)):
        cells: list[str] = []
        for order, (_, _, delta, samples) in enumerate(channels):
            x = times[row] if times else row * (steps[order] if steps else delta)
            there = row < len(samples)
            if multi or order == 0:
                cells.append(f"{x:.6f}" if there and x_columns != "No" else "")
            cells.append(f"{samples[row]:.6f}" if there else "")
        rows.append("\t".join([*cells, remarks] if remarks and row % 3 == 0 else cells))
    body = "\n".join([*header, "***End_of_Header***\t", labels, *rows])
    return body.replace(".", decimal) + "\n"


def written(folder: Path, *segments: str, x_columns: str = "One", decimal: str = ".", separator: str = "\t") -> Path:
    head = (
        f"LabVIEW Measurement\t\nSeparator\t{'Tab' if separator == chr(9) else 'Comma'}\nDecimal_Separator\t{decimal}\n"
    )
    head += f"X_Columns\t{x_columns}\n***End_of_Header***\t\n\t\n"
    path = folder / "run.lvm"
    whole = (head + "\n".join(segments)).replace("\t", separator)
    path.write_text(whole, encoding="utf-8", newline="\r\n")
    return path


def sine(samples: int = 40) -> list[float]:
    return [round(2 + 0.5 * float(np.sin(0.19 * index)), 6) for index in range(samples)]


@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize(("delta", "step", "rate"), [(1.0, 0.01, 100), (1.0, 0.0005, 2000), (0.001, 0.002, 500)])
def test_x_values_that_contradict_delta_x_are_used(
    tmp_path: Path, delta: float, step: float, rate: float, decimal: str
) -> None:
    segment = text([("torque", "N*m", delta, sine())], steps=[step], decimal=decimal)
    table = read_lvm(written(tmp_path, segment, decimal=decimal))
    assert table.rates == {"torque": rate}
    assert table.columns["torque"].tolist() == sine()
    assert "X_Value is used" in table.notes[0]
    assert read_recording(tmp_path / "run.lvm").sample_rate == rate


def test_printed_digits_do_not_contradict_delta_x(tmp_path: Path) -> None:
    # 12.8 kHz with six decimals, and a rate whose steps are printed as 0 and 1 us
    for delta in (1 / 12800, 4e-7):
        segment = text([("torque", "N*m", delta, sine())]).replace(f"Delta_X\t{delta:.6f}", f"Delta_X\t{delta:.9f}")
        table = read_lvm(written(tmp_path, segment))
        assert table.rates["torque"] == pytest.approx(1 / delta, rel=1e-9)
        assert table.notes == ()


def test_uneven_x_values_become_times(tmp_path: Path) -> None:
    times = [0.0, 0.328878, 1.208397, 1.533401, 1.927769]
    table = read_lvm(written(tmp_path, text([("p", "MPa", 1.0, sine(5))], times=times)))
    assert table.columns["time_s"].tolist() == times
    assert table.rates == {}
    assert "Delta_X = 1 s is not used" in table.notes[0]
    lost = [0.0, 0.001, 0.002, 0.004, 0.005]
    table = read_lvm(written(tmp_path, text([("p", "MPa", 0.001, sine(5))], times=lost)))
    assert table.columns["time_s"].tolist() == lost
    assert table.rates == {"p": 1000}


@pytest.mark.parametrize("gaps", [True, False])
@pytest.mark.parametrize("units", [("Nm", "deg", "rev"), ("", "rpm", "deg"), ("Nm", "", "rad")])
def test_units_stand_over_their_column(tmp_path: Path, units: tuple[str, ...], gaps: bool) -> None:
    channels = [(f"c{index}", unit, 0.001, sine(9)) for index, unit in enumerate(units)]
    table = read_lvm(written(tmp_path, text(channels, x_columns="Multi", gaps=gaps), x_columns="Multi"))
    assert table.units == {f"c{index}": unit for index, unit in enumerate(units) if unit}
    assert list(table.columns) == ["c0", "c1", "c2"]


@pytest.mark.parametrize(
    ("deltas", "counts"), [((0.001, 0.01), (40, 40)), ((0.001, 0.01), (40, 4)), ((0.01, 0.001), (4, 40))]
)
def test_two_rates_in_one_file(tmp_path: Path, deltas: tuple[float, float], counts: tuple[int, int]) -> None:
    channels = [("torque_Nm", "Nm", deltas[0], sine(counts[0])), ("speed_rpm", "rpm", deltas[1], sine(counts[1]))]
    path = written(tmp_path, text(channels, x_columns="Multi"), x_columns="Multi")
    table = read_lvm(path)
    assert table.rates == pytest.approx({"torque_Nm": 1 / deltas[0], "speed_rpm": 1 / deltas[1]})
    assert [values.size for values in table.columns.values()] == list(counts)
    with pytest.raises(
        RecordingError, match=rf"torque_Nm has {1 / deltas[0]:g} .* and speed_rpm has {1 / deltas[1]:g}; .*join"
    ):
        read_recording(path)


@pytest.mark.parametrize(
    ("deltas", "counts"), [((0.001, 0.01), (40, 4)), ((0.001, 1.0), (40, 40)), ((1.0, 0.5), (40, 40))]
)
def test_one_x_column_holds_the_times_of_the_first_channel(
    tmp_path: Path, deltas: tuple[float, float], counts: tuple[int, int]
) -> None:
    channels = [("torque", "Nm", deltas[0], sine(counts[0])), ("speed", "rpm", deltas[1], sine(counts[1]))]
    table = read_lvm(written(tmp_path, text(channels, steps=[0.001, 0.001])))
    assert table.rates == pytest.approx({"torque": 1000, "speed": 1 / deltas[1]})


def test_a_channel_that_starts_later_is_noted(tmp_path: Path) -> None:
    channels = [("torque", "Nm", 0.001, sine(9)), ("speed", "rpm", 0.001, sine(9))]
    segment = text(channels, x_columns="No").replace("X_Dimension", "X0\t0.0\t0.5\nX_Dimension")
    table = read_lvm(written(tmp_path, segment, x_columns="No"))
    assert "speed starts 0.5 s after torque" in table.notes[0]


@pytest.mark.parametrize("before", ["Notes\tbearing changed", "Test_Name\tDauer 3\nOperator\tme", "Notes\t"])
def test_tags_before_the_channels(tmp_path: Path, before: str) -> None:
    channels = [("Dev1/ai0", "V", 0.001, sine(7)), ("Untitled", "V", 1.0, [])]
    table = read_lvm(written(tmp_path, text(channels, before=before), text(channels, before=before)))
    assert table.columns["Dev1/ai0"].tolist() == sine(7) * 2
    assert table.skipped == {"Untitled": "it has no samples"}


@pytest.mark.parametrize("moments", [("2024/05/01 10:00:00.5", "2024/05/01 10:00:00.540000"), ("", "")])
def test_segments_that_begin_anew(tmp_path: Path, moments: tuple[str, str]) -> None:
    parts = [text([("torque", "Nm", 0.001, sine(40))], moment=moment) for moment in moments]
    table = read_lvm(written(tmp_path, *parts))
    assert table.columns["torque"].size == 80
    if moments[0]:
        np.testing.assert_allclose(table.columns["time_s"], np.arange(80) / 1000, atol=1e-9)
        assert table.rates == {"torque": 1000}
    else:
        with pytest.raises(RecordingError, match="does not rise at sample 40"):
            read_recording(tmp_path / "run.lvm")


def test_segments_of_other_units_or_steps_are_refused(tmp_path: Path) -> None:
    parts = [text([("torque", unit, 0.001, sine(4))]) for unit in ("Nm", "lbf.in")]
    with pytest.raises(RecordingError, match=r"torque: its segments state different Y_Unit_Label \(Nm and lbf.in\)"):
        read_lvm(written(tmp_path, *parts))
    parts = [text([("torque", "Nm", delta, sine(4))], x_columns="No") for delta in (0.001, 0.002)]
    with pytest.raises(RecordingError, match="different Delta_X"):
        read_lvm(written(tmp_path, *parts, x_columns="No"))


def test_remarks_and_short_columns(tmp_path: Path) -> None:
    channels = [("torque", "Nm", 0.001, sine(30)), ("flow", "gpm", 1.0, sine(4))]
    table = read_lvm(written(tmp_path, text(channels, remarks="valve, open")))
    assert table.columns["torque"].tolist() == sine(30)
    assert table.columns["flow"].tolist() == sine(4)
    assert table.skipped == {"Comment": "remarks"}


def test_a_column_with_values_in_some_rows_is_skipped(tmp_path: Path) -> None:
    # one heading, two calls of the writer: the second channel has one sample a call
    rows = text([("torque", "Nm", 0.001, sine(3)), ("flow", "gpm", 1.0, sine(1))])
    again = "0.003000\t1.000000\t7.000000\n0.004000\t1.000000\t\n0.005000\t1.000000\t\n"
    table = read_lvm(written(tmp_path, rows + again))
    assert list(table.columns) == ["torque"]
    assert "in only 2 of 6 rows" in table.skipped["flow"]


def test_other_axes_than_time(tmp_path: Path) -> None:
    spectrum = text([("spectrum", "Nm", 0.5, sine(9))]).replace("X_Dimension\tTime", "X_Dimension\tFrequency")
    assert read_lvm(written(tmp_path, spectrum)).skipped == {"spectrum": "its X dimension is Frequency, not time"}
    slow = text([("torque", "Nm", 0.5, sine(9))]).replace("X_Dimension", "X_Unit_Label\tms\nX_Dimension")
    assert read_lvm(written(tmp_path, slow)).rates == {"torque": 2000}


def test_a_special_block_keeps_the_line_numbers(tmp_path: Path) -> None:
    segment = text([("torque", "Nm", 0.001, sine(9))]).replace("2.000000", "2.00x000")
    special = "***Start_Special***\tx\n1\t2\n***End_Special***\n"
    path = written(tmp_path, special + segment)
    line = path.read_text().splitlines().index("0.000000\t2.00x000") + 1
    with pytest.raises(RecordingError, match=rf"run.lvm:{line}: torque: '2.00x000' is no number"):
        read_lvm(path)


def test_commas_between_cells_and_in_numbers(tmp_path: Path) -> None:
    table = read_lvm(written(tmp_path, text([("torque", "Nm", 0.001, sine(9))]), separator=","))
    assert table.columns["torque"].tolist() == sine(9)
    path = written(tmp_path, text([("torque", "Nm", 0.001, sine(9))], decimal=","), separator=",", decimal=",")
    with pytest.raises(RecordingError, match="cannot be told apart"):
        read_lvm(path)


@pytest.mark.parametrize("encoding", ["utf-8", "cp1252"])
def test_unit_signs_of_windows(tmp_path: Path, encoding: str) -> None:
    path = written(tmp_path, text([("Öl", "°C", 0.001, sine(9))]))
    path.write_bytes(path.read_text(encoding="utf-8").encode(encoding))
    assert read_lvm(path).units == {"Öl": "°C"}


@pytest.mark.parametrize("x_columns", ["One", "No", "Multi"])
def test_numbers_equal_those_of_lvm_read(tmp_path: Path, x_columns: str) -> None:
    lvm_read = pytest.importorskip("lvm_read", reason="lvm_read is not installed")
    channels = [("a", "V", 0.001, sine(30)), ("b", "V", 0.001, sine(30)[::-1])]
    path = written(tmp_path, text(channels, x_columns=x_columns, decimal=","), x_columns=x_columns, decimal=",")
    ours: Table = read_lvm(path)
    theirs = lvm_read.read(str(path), read_from_pickle=False, dump_file=False)[0]
    for name in "ab":
        column = theirs["Channel names"].index(name)
        assert theirs["data"][:, column].tolist() == ours.columns[name].tolist()


@pytest.mark.parametrize("cut", [1, 3, 8, 200])
@pytest.mark.parametrize("x_columns", ["One", "No"])
def test_a_file_that_is_cut_short_is_noted(tmp_path: Path, cut: int, x_columns: str) -> None:
    speed = [1000.0 + index for index in range(40)]
    path = written(tmp_path, text([("speed_rpm", "rpm", 0.001, speed)], x_columns=x_columns), x_columns=x_columns)
    whole = path.read_bytes().rstrip(b"\r\n")
    assert not any("cut short" in note for note in read_lvm(path).notes)
    path.write_bytes(whole[:-cut])
    rows = whole[:-cut].count(b"\n") - whole[: whole.index(b"X_Value")].count(b"\n")
    table = read_lvm(path)
    notes = " ".join(table.notes)
    assert "the last row has no line end and its last number may be cut off" in notes
    assert (f"the header states 40 samples and the file has {rows} rows: it is cut short" in notes) == (rows < 40)
    assert table.columns["speed_rpm"].tolist() == speed[: rows - 1]


def test_a_last_row_without_a_line_end_is_whole(tmp_path: Path) -> None:
    path = written(tmp_path, text([("torque_Nm", "Nm", 0.001, sine())]))
    path.write_bytes(path.read_bytes().rstrip(b"\r\n"))
    assert read_lvm(path).columns["torque_Nm"].size == 40
