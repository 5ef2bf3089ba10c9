"""Drawn combinations of separator, decimals, stamps, units, preamble, footer, encoding and line ends read right."""

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

from torquerig.recordings.files import read_recording

SEPARATORS = {",": ".", ";": ".,", "\t": ".,", "|": ".,", "  ": "."}
PREAMBLES = (
    "", "Recorder 5, version 3.1\n", "Date: 12.05.2021 10:11:12\nOperator: Smith\n\n", "# rig 3\n# no load, 20 degC\n",
    "Channels;3\nRange;20;Nm\nFilter;500;Hz\n", "Test\t17\n\n\n", '"File","run 3.csv"\n"Size",1024\n',
)  # fmt: skip
FOOTERS = ("", "End of file\n", "\nSamples: 60\n", "# stopped by hand\n", "\n\n")
STAMPS = ("%Y-%m-%dT%H:%M:%S.%f", "%d.%m.%Y %H:%M:%S.%f", "%H:%M:%S.%f")
ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "latin-1")


def drawn(rng: np.random.Generator) -> tuple[bytes, dict[str, np.ndarray], float]:
    """Return a file, its torque and speed, and its rate."""
    pick = lambda options: options[int(rng.integers(len(options)))]  # noqa: E731
    separator = pick(list(SEPARATORS))
    decimal = pick(SEPARATORS[separator])
    rate = pick((10.0, 100.0, 1000.0, 2500.0))
    count = int(rng.integers(12, 120))
    torque = np.round(rng.normal(pick((0.0, 2.0, -15.0)), 0.5, count), 4)
    speed = np.round(rng.normal(pick((100.0, 1500.0)), 3, count), 2)
    blanks = separator == "  "
    names = ["Time", pick(("Torque", "Drehmoment")), pick(("Speed", "Drehzahl"))]
    units = ["s", pick(("Nm", "N*m")), pick(("rpm", "1/min"))]
    start = datetime(2021, 5, 12, 23, 59, 59)
    times = [f"{number / rate:.6f}" for number in range(count)]
    if not blanks and rng.random() < 0.4:
        form = pick(STAMPS)
        times = [(start + timedelta(seconds=number / rate)).strftime(form) for number in range(count)]
        units[0] = ""
    columns = [times, [f"{one:.4f}".replace(".", decimal) for one in torque], [f"{one:.2f}" for one in speed]]
    columns[2] = [cell.replace(".", decimal) for cell in columns[2]]
    if units[0]:
        columns[0] = [cell.replace(".", decimal) for cell in times]
    header = [names, units] if units[0] and rng.random() < 0.5 else []
    header = header or [[f"{name} [{unit}]" if unit else name for name, unit in zip(names, units, strict=True)]]
    if blanks and len(header) == 1:
        header = [["Time_s", "Torque_Nm", "Speed_rpm"]]
    rows = [list(row) for row in zip(*columns, strict=True)]
    extra = "" if blanks else pick(("", "", "state", "remark", "nothing"))
    if extra:
        place = int(rng.integers(len(names) + 1))
        for number, row in enumerate([*header, *rows]):
            cell = {"state": f"S{number % 4}", "remark": "knock" if number == 7 else "", "nothing": ""}[extra]
            row.insert(place, (extra if number == 0 else "") if number < len(header) else cell)
    end = pick(("\n", "\r\n", "\r"))
    lines = [separator.join(row) for row in (*header, *rows)]
    trailing = separator if not blanks and rng.random() < 0.15 else ""
    sign = f"sep={separator}\n" if not blanks and rng.random() < 0.15 else ""
    text = sign + pick(PREAMBLES) + "".join(f"{line}{trailing}\n" for line in lines) + pick(FOOTERS)
    return text.replace("\n", end).encode(pick(ENCODINGS)), {"torque": torque, "speed": speed}, rate


def check(folder: Path, seeds: range) -> None:
    for seed in seeds:
        content, values, rate = drawn(np.random.default_rng(seed))
        path = folder / f"run{seed}.csv"
        path.write_bytes(content)
        recording = read_recording(path)
        found = {one.quantity: one for one in recording.channels.values()}
        assert set(found) == set(values), seed
        assert recording.sample_rate == pytest.approx(rate, rel=1e-9), seed
        for quantity, numbers in values.items():
            assert found[quantity].values == pytest.approx(numbers, abs=1e-9), seed
        path.unlink()


def test_drawn_dialects(tmp_path: Path) -> None:
    check(tmp_path, range(100))


@pytest.mark.long
def test_some_hundred_drawn_dialects(tmp_path: Path) -> None:
    check(tmp_path, range(1000, 1400))


@pytest.mark.full
def test_thousands_of_drawn_dialects(tmp_path: Path) -> None:
    check(tmp_path, range(1400, 4000))
