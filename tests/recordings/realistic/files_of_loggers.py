"""Recordings as loggers write them: one torque of 16.7 and 280 Hz at 1000 rpm, in many formats and dialects.

Each entry of :data:`FILES` writes one file and says what is right: rate, quantities, units, mean levels, and the edits
(at most two) that its drafted sidecar needs because the file does not say it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Column = tuple[str, str, NDArray[np.float64]]  # name, unit, values
FOOT_POUND = 1.3558179483314004


@dataclass(frozen=True, kw_only=True)
class Right:
    """What is right for one file: ``levels`` maps a channel to quantity, unit and mean in that unit."""

    rate: float
    torque: str
    mean_Nm: float = 2.0
    levels: Mapping[str, tuple[str, str, float]] = field(default_factory=dict)
    edits: tuple[tuple[str, str], ...] = ()


def signals(rate: float, seconds: float = 4.0) -> dict[str, NDArray[np.float64]]:
    """Return time [s], torque [N m], speed [rpm], angle [deg], a temperature [degC] and an acceleration [m/s^2]."""
    rng = np.random.default_rng(11)
    times = np.arange(round(rate * seconds)) / rate
    torque = 2 + 0.3 * np.sin(2 * np.pi * 1000 / 60 * times) + 0.5 * np.sin(2 * np.pi * 280 * times)
    return {
        "time": times,
        "torque": torque + 0.01 * rng.standard_normal(times.size),
        "speed": 1000 + 0.5 * rng.standard_normal(times.size),
        "angle": 6000 * times,
        "temperature": 25 + times / 100,
        "acceleration": 9.80665 * 0.2 * rng.standard_normal(times.size),
    }


def table(
    rows: list[NDArray[np.float64]], *, separator: str = ",", decimal: str = ".", digits: int = 6, end: str = "\n"
) -> str:
    """Return columns as lines of text."""
    lines = []
    for row in zip(*rows, strict=True):
        cells = [f"{value:.{digits}f}" for value in row]
        lines.append(separator.join(cells if decimal == "." else [cell.replace(".", ",") for cell in cells]))
    return end.join(lines) + end


def _text(
    path: Path, head: str, names: tuple[str, ...], *, rate: float = 5000.0, encoding: str = "utf-8", tail: str = "",
    scale: Mapping[str, float] | None = None, **dialect: str,
) -> None:  # fmt: skip
    data = signals(rate)
    rows = [data[name] * (scale or {}).get(name, 1.0) for name in names]
    path.write_bytes((head + table(rows, **dialect) + tail).encode(encoding))  # type: ignore[arg-type]


def _bracketed(path: Path) -> Right:
    _text(path, "Time [s],Torque [Nm],Speed [rpm]\n", ("time", "torque", "speed"))
    return Right(rate=5000, torque="Torque", levels={"Speed": ("speed", "rpm", 1000)})


def _round(path: Path) -> Right:
    _text(path, "Time (ms),Torque (N·m),Temp (°C)\n", ("time", "torque", "temperature"), scale={"time": 1e3})
    return Right(rate=5000, torque="Torque", levels={"Temp": ("temperature", "degC", 25.02)})


def _german(path: Path) -> Right:
    head = "Zeit [s];Drehmoment [Nm];Drehzahl [U/min];Winkel [°]\n"
    _text(path, head, ("time", "torque", "speed", "angle"), separator=";", decimal=",", encoding="latin-1")
    return Right(rate=5000, torque="Drehmoment",
                 levels={"Drehzahl": ("speed", "rev/min", 1000), "Winkel": ("angle", "deg", 11999.4)})  # fmt: skip


def _units_row(path: Path) -> Right:
    head = "Time\tTorque\tSpeed\ns\tNm\trpm\n"
    _text(path, head, ("time", "torque", "speed"), separator="\t")
    return Right(rate=5000, torque="Torque", levels={"Speed": ("speed", "rpm", 1000)})


def _catman(path: Path) -> Right:
    head = "CATMAN EXPORT\nDate: 12.05.2021 10:11:12\nRate: 5000 Hz\nTime\tMD\tn\ns\tNm\t1/min\n"
    _text(path, head, ("time", "torque", "speed"), separator="\t", decimal=",")
    return Right(rate=5000, torque="MD", levels={"n": ("speed", "1/min", 1000)})


def _excel_sep(path: Path) -> Right:
    head = "sep=;\nTime, s;Torque, Nm;Speed, rpm\n"
    _text(path, head, ("time", "torque", "speed"), separator=";", end="\r\n")
    return Right(rate=5000, torque="Torque", levels={"Speed": ("speed", "rpm", 1000)})


def _utf16(path: Path) -> Right:
    _text(path, "Time [s]\tTorque [Nm]\n", ("time", "torque"), separator="\t", encoding="utf-16")
    return Right(rate=5000, torque="Torque")


def _mac(path: Path) -> Right:
    _text(path, "Time [s],Torque [Nm]\r", ("time", "torque"), end="\r")
    return Right(rate=5000, torque="Torque")


def _comments(path: Path) -> Right:
    head = '# logger 7\n"# operator: A, B"\n% run 3\nt,torque_Nm,speed_rpm\n'
    _text(path, head, ("time", "torque", "speed"))
    return Right(rate=5000, torque="torque_Nm", levels={"speed_rpm": ("speed", "rpm", 1000)})


def _footer(path: Path) -> Right:
    _text(path, "Time [s],Torque [Nm]\n", ("time", "torque"), tail="\nMaximum,2.84\nEnd of file\n")
    return Right(rate=5000, torque="Torque")


def _trailing(path: Path) -> Right:
    data = signals(5000)
    rows = "".join(f"{t:.4f};{v:.5f};\n" for t, v in zip(data["time"], data["torque"], strict=True))
    path.write_text("Time [s];Torque [Nm];\n" + rows)
    return Right(rate=5000, torque="Torque")


def _quoted(path: Path) -> Right:
    data = signals(5000)
    rows = "".join(
        f'"{t:.4f}","{v:.5f}"\n'.replace(".", ",") for t, v in zip(data["time"], data["torque"], strict=True)
    )
    path.write_text('"Zeit (s)","Moment (Nm)"\n' + rows)
    return Right(rate=5000, torque="Moment")


def _iso_stamps(path: Path) -> Right:
    data = signals(1000)
    stamps = (np.datetime64("2021-05-12T10:11:12.000") + (data["time"] * 1e3).round().astype("timedelta64[ms]")).astype(
        str
    )
    rows = "".join(f"{t},{v:.5f},run\n" for t, v in zip(stamps, data["torque"], strict=True))
    path.write_text("timestamp,Torque [Nm],state\n" + rows)
    return Right(rate=1000, torque="Torque")


def _day_first(path: Path) -> Right:
    data = signals(1000)
    rows = "".join(
        f"12.05.2021 10:11:{12 + int(t):02d},{round(t * 1e3) % 1000:03d};{v:.5f}\n"
        for t, v in zip(data["time"], data["torque"], strict=True)
    )
    path.write_text("Datum Uhrzeit;Torque [Nm]\n" + rows)
    return Right(rate=1000, torque="Torque")


def _coarse(path: Path) -> Right:
    data = signals(2500)
    rows = "".join(f"{t * 1e3:.0f},{v:.5f}\n" for t, v in zip(data["time"], data["torque"], strict=True))
    path.write_text("Time [ms],Torque [Nm]\n" + rows)
    return Right(rate=2500, torque="Torque")


def _foot_pounds(path: Path) -> Right:
    data = signals(960)
    rows = "".join(f"{t:.5f} {v / FOOT_POUND:.5f}\n" for t, v in zip(data["time"], data["torque"], strict=True))
    path.write_text("Number of samples: 3840\nSamples per second: 960\nUnits: FTLB\n\nTime: Sample\n" + rows)
    return Right(rate=960, torque="Sample")


def _no_rate(path: Path) -> Right:
    _text(path, "Torque [Nm],Speed [rpm]\n", ("torque", "speed"))
    return Right(rate=5000, torque="Torque", edits=(("# EDIT: sample_rate_Hz: NUMBER", "sample_rate_Hz: 5000"),),
                 levels={"Speed": ("speed", "rpm", 1000)})  # fmt: skip


def _no_unit(path: Path) -> Right:
    _text(path, "Time [s],Torque\n", ("time", "torque"))
    edits = (("  Torque: {quantity: other, unit: \"\"}", "  # Torque:"),
             ("# EDIT: Torque: {quantity: torque, unit: UNIT}", "Torque: {quantity: torque, unit: Nm}"))  # fmt: skip
    return Right(rate=5000, torque="Torque", edits=edits)


def _volts(path: Path) -> Right:
    _text(path, "Time [s],Dev1/ai0\n", ("time", "torque"), scale={"torque": 0.1})
    edits = (("  Dev1/ai0: {quantity: voltage, unit: V}", "  # Dev1/ai0:"),
             ("# EDIT: Dev1/ai0: {quantity: torque, unit: V, Nm_per_V: NUMBER}",
              "Dev1/ai0: {quantity: torque, unit: V, Nm_per_V: 10}"))  # fmt: skip
    return Right(rate=5000, torque="Dev1/ai0", edits=edits)


def _unknown_units(path: Path) -> Right:
    head = "Time [s],Torque [Nm],Weight [stone],acc [g]\n"
    _text(path, head, ("time", "torque", "temperature", "acceleration"), scale={"acceleration": 1 / 9.80665})
    return Right(rate=5000, torque="Torque",
                 levels={"Weight": ("other", "stone", 25.02), "acc": ("acceleration", "g0", 0.0)})  # fmt: skip


def _newton_meters(path: Path) -> Right:
    _text(path, "Time [s],Torque [Newton-meters],Motor speed [RPM]\n", ("time", "torque", "speed"))
    return Right(rate=5000, torque="Torque", levels={"Motor speed": ("motor_speed", "rpm", 1000)})


def _inch_pounds(path: Path) -> Right:
    _text(path, "Time [s];Torque [in-lb]\n", ("time", "torque"), separator=";", scale={"torque": 12 / FOOT_POUND})
    return Right(rate=5000, torque="Torque")


def _epoch(path: Path) -> Right:
    data = signals(1000)
    stamps = 1620814272000 + (data["time"] * 1e3).round().astype(np.int64)
    rows = "".join(f"{t};{v:.5f}\n" for t, v in zip(stamps, data["torque"], strict=True))
    path.write_text("Timestamp;Torque [Nm]\n" + rows)
    return Right(rate=1000, torque="Torque")


def _oscilloscope(path: Path) -> Right:
    head = "Time,Channel A\n(ms),(V)\n\n"
    _text(path, head, ("time", "torque"), scale={"time": 1e3, "torque": 0.1})
    edits = (("  Channel A: {quantity: voltage, unit: V}", "  # Channel A:"),
             ("# EDIT, if it is the torque: Channel A: {quantity: torque, unit: V, Nm_per_V: NUMBER}",
              "Channel A: {quantity: torque, unit: V, Nm_per_V: 10}"))  # fmt: skip
    return Right(rate=5000, torque="Channel A", edits=edits)


def _overload(path: Path) -> Right:
    data = signals(5000)
    rows = "".join(f"{t:.4f},{v:.5f},OVLD\n" for t, v in zip(data["time"], data["torque"], strict=True))
    path.write_text("Time [s],Torque [Nm],Spare\n" + rows)
    return Right(rate=5000, torque="Torque")


TEXTS: dict[str, tuple[str, Callable[[Path], Right]]] = {
    "bracketed": (".csv", _bracketed), "round": (".csv", _round), "german": (".csv", _german),
    "units row": (".txt", _units_row), "catman": (".txt", _catman), "excel sep": (".csv", _excel_sep),
    "utf16": (".txt", _utf16), "mac": (".csv", _mac), "comments": (".csv", _comments), "footer": (".csv", _footer),
    "trailing": (".csv", _trailing), "quoted": (".csv", _quoted), "iso stamps": (".csv", _iso_stamps),
    "day first": (".csv", _day_first), "coarse": (".csv", _coarse), "foot pounds": (".txt", _foot_pounds),
    "no rate": (".csv", _no_rate), "no unit": (".csv", _no_unit), "volts": (".csv", _volts),
    "unknown units": (".csv", _unknown_units), "newton meters": (".dat", _newton_meters),
    "inch pounds": (".tsv", _inch_pounds), "overload": (".csv", _overload),
    "epoch": (".csv", _epoch), "oscilloscope": (".csv", _oscilloscope),
}  # fmt: skip
"""The text files: ending and maker of each."""
