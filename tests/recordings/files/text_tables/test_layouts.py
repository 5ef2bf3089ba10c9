"""Where names, units and rate stand in files of testers, catman, DIAdem, Excel, numpy and oscilloscopes."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.csv import read_csv

COUNT = 25


def rows(separator: str, *, decimal: str = ".", rate: float = 1000.0, digits: int = 3, first: str = "") -> str:
    """Return rows of time, a torque of 2 +- 0.2 and a speed of 1000."""
    lines = []
    for number in range(COUNT):
        cells = [f"{number / rate:.{digits}f}", f"{2 + 0.2 * np.sin(number):.4f}", "1000.00"]
        lines.append(first + separator.join(cells).replace(".", decimal))
    return "\n".join(lines) + "\n"


def torque_only(text: str) -> str:
    """Return the rows without their last cell."""
    return "".join(line.rpartition(line[-8])[0] + "\n" for line in text.splitlines())


CATMAN = "HBM_CATMAN_EXPORT\nDate: 12.05.2021 10:11:12\nRate: 1000 Hz\n"
NAMED = {"torque_Nm": None, "speed_rpm": None}
MEASURED, LOWER = {"MD": "Nm", "n": "1/min"}, {"torque": "Nm", "speed": "rpm"}
# text, channel names, units, rate
FILES = {
    "catman": (CATMAN + "Time\tMD\tn\ns\tNm\t1/min\n" + rows("\t", decimal=","), MEASURED, 1000),
    "catman, kHz and names of two lines": (
        CATMAN.replace("1000 Hz", "2,4 kHz") + "Dev1\tDev1\tDev1\nTime\tMD\tn\ns\tNm\t1/min\n"
        + rows("\t", decimal=",", rate=2400, digits=6), MEASURED, 2400),
    "catman, units before names": (
        CATMAN + "[s]\t[Nm]\t[1/min]\nTime\tMD\tn\n" + rows("\t", decimal=","), MEASURED, 1000),
    "catman, remarks below the units": (
        CATMAN + "Time\tMD\tn\ns\tNm\t1/min\nclock\tDR2\tHEDS\n" + rows("\t", decimal=","), MEASURED, 1000),
    "units row": ("Time\tTorque\tSpeed\ns\tNm\trpm\n" + rows("\t"), {"Torque": "Nm", "Speed": "rpm"}, 1000),
    "units row between blanks": ("time torque speed\n[s] [Nm] [rpm]\n" + rows(" "), LOWER, 1000),
    "units row in a comment": ("# time torque speed\n# s Nm rpm\n" + rows(" "), LOWER, 1000),
    "names in a comment": ("% time_s torque_Nm speed_rpm\n" + rows(" "), NAMED, 1000),
    "semicolon comment": ("; rig 3\n; rate 1000\ntime_s torque_Nm speed_rpm\n" + rows(" "),
                          NAMED, 1000),
    "commas in names": ("Time, s;Torque, Nm;Speed, rpm\n" + rows(";", decimal=","),
                        {"Torque, Nm": None, "Speed, rpm": None}, 1000),
    "numbers as names": ("Time,1,2\n" + rows(","), {"1": None, "2": None}, 1000),
    "names with blanks": ("Time   Motor torque   Speed\n" + rows("   "), {"Motor torque": None, "Speed": None}, 1000),
    "tester": (
        "Number of samples: 2000\nSamples per second: 960\nUnits: FTLB\n\nTime: Sample\n"
        + torque_only(rows(" ", rate=960, digits=5)), {"Sample": "FTLB"}, 960),
    "tester, tabs": (
        "Samples:\t2000\nSample interval:\t0.5 ms\nUnit:\tNm\n\nTime\tLoad\n"
        + torque_only(rows("\t", rate=2000, digits=4)), {"Load": "Nm"}, 2000),
    "tester, semicolons": (
        "Prüfer;Meier\nAbtastrate;1,2 kHz\nEinheit;Ncm\n\nZeit;Moment\n"
        + torque_only(rows(";", decimal=",", rate=1200, digits=6)), {"Moment": "Ncm"}, 1200),
    "sep=": ("sep=;\ntime_s;torque_Nm;speed_rpm\n" + rows(";", decimal=","), NAMED, 1000),
    "sep=| ": ("sep=|\ntime_s|torque_Nm|speed_rpm\n" + rows("|"), NAMED, 1000),
    "quoted sep": ('"sep=,"\ntime_s,torque_Nm,speed_rpm\n' + rows(","), NAMED, 1000),
    "quoted comment": ('"# started, vbus = 14.9 V"\ntime [s],torque [Nm],speed [rpm]\n' + rows(","),
                       {"torque [Nm]": None, "speed [rpm]": None}, 1000),
    "blank in names": ("Run Name,time_s,torque_Nm,speed_rpm\n" + rows(",", first="run A,"),
                       NAMED, 1000),
    "state": ("state;time_s;torque_Nm;speed_rpm\n" + rows(";", first="S1;"), NAMED, 1000),
}  # fmt: skip


@pytest.mark.parametrize("kind", FILES)
def test_names_units_and_rate(tmp_path: Path, kind: str) -> None:
    text, units, rate = FILES[kind]
    path = tmp_path / "run1.txt"
    path.write_text(text, encoding="utf-8")
    table = read_csv(path)
    assert {name: table.units.get(name) for name in table.signal_names()} == units
    assert all(values.size == COUNT for values in table.columns.values())
    first = table.columns[next(iter(units))]
    assert first == pytest.approx(np.round(2 + 0.2 * np.sin(np.arange(COUNT)), 4))
    assert read_recording(path).sample_rate == pytest.approx(rate, rel=1e-9)


WORDS = "the row holds words in place of numbers"
UNCLEAR = {
    "names again": ("time_s,torque_Nm\n0,1\n1,2\ntime_s,torque_Nm\n2,1\n3,2\n", f"run1.csv:4: {WORDS}"),
    "a second table": ("time_s,torque_Nm\n0,1\n1,2\n2,1\n\nbin,count\n1,5\n2,6\n", f"run1.csv:6: {WORDS}"),
    "four names": ("Time Motor torque Speed\n0.1 1 5\n0.2 1 5\n", "run1.csv:1: the line has 4 names and the rows"),
    "two decimal signs": ("time_s;torque_Nm\n0;1,5\n1;2,5\n2;1,234.5\n", "run1.csv:4: torque_Nm: '1,234.5' is no"),
    "hours or minutes": ("Time;Torque\n10:11;1,5\n10:12;1,6\n", "the sample rate is not stated"),
}


@pytest.mark.parametrize(("text", "told"), UNCLEAR.values(), ids=UNCLEAR)
def test_what_is_not_clear_is_refused(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "run1.csv"
    path.write_text(text)
    with pytest.raises(RecordingError) as caught:
        read_recording(path)
    assert told in str(caught.value)


def test_thousands_that_come_late(tmp_path: Path) -> None:
    speeds = 900 + np.arange(600) / 4
    cells = [f"{one:,.2f}".replace(",", "?").replace(".", ",").replace("?", ".") for one in speeds]
    path = tmp_path / "run1.csv"
    rows = [f"{number // 8},{number % 8 * 125:03d};{cell}\n" for number, cell in enumerate(cells)]
    path.write_text("Time [s];Speed [rpm]\n" + "".join(rows))
    assert read_csv(path).columns["Speed [rpm]"] == pytest.approx(speeds)


def test_entries_above_a_break_are_no_rows(tmp_path: Path) -> None:
    path = tmp_path / "run1.csv"
    keys = '"Model","DL850"\n"TraceName","Torque","Speed"\n"VUnit","Nm","rpm"\n"HResolution",1.0e-3,1.0e-3\n\n'
    path.write_text(keys + "".join(f",{number}.5,1000\n" for number in range(6)))
    columns = list(read_csv(path).columns.values())
    assert [values.tolist() for values in columns] == [[0.5, 1.5, 2.5, 3.5, 4.5, 5.5], [1000.0] * 6]


def test_days_and_months(tmp_path: Path) -> None:
    # 2 to 3 December, or February to March: a day apart is nearer than a month
    path = tmp_path / "run1.csv"
    stamps = ("02/12/2021 23:59:58", "02/12/2021 23:59:59", "03/12/2021 00:00:00", "03/12/2021 00:00:01")
    path.write_text("Time,torque_Nm\n" + "".join(f"{stamp},1.5\n" for stamp in stamps))
    assert read_csv(path).columns["Time"].tolist() == [0, 1, 2, 3]


def test_the_clock_goes_over_midnight_in_pieces(tmp_path: Path) -> None:
    from torquerig.recordings.files.csv import csv_pieces

    moments = [(86_390 + number / 10) % 86_400 for number in range(300)]
    lines = [f"{int(one // 3600):02d}:{int(one // 60 % 60):02d}:{one % 60:06.3f},1.5" for one in moments]
    path = tmp_path / "run1.csv"
    path.write_text("Time,torque_Nm\n" + "\n".join(lines) + "\n")
    pieces = csv_pieces(path, step=1000)
    times = np.concatenate([piece["Time"] for piece in pieces.pieces(["Time"])])
    assert times == pytest.approx(np.arange(300) / 10, abs=1e-9)
