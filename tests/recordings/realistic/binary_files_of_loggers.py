"""The recordings of :mod:`files_of_loggers` in binary formats and in LabVIEW's text."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import openpyxl
import pandas as pd
from nptdms import ChannelObject, RootObject, TdmsWriter
from scipy.io import savemat, wavfile

from tests.recordings.realistic.files_of_loggers import FOOT_POUND, Right, signals, table


def _tdms(path: Path) -> Right:
    data = signals(5000)
    with TdmsWriter(path) as file:
        for name, key, unit in (("Drehmoment", "torque", "Nm"), ("Speed ", "speed", "1/min"), ("Note", "", "")):
            values = data[key] if key else np.array(["a", "b"])
            properties = {"wf_increment": 2e-4, "unit_string": unit} if key else {}
            file.write_segment([RootObject(), ChannelObject("Log", name, values, properties)])
    return Right(rate=5000, torque="Drehmoment", levels={"Speed": ("speed", "1/min", 1000)})


def _tdms_volts(path: Path) -> Right:
    data = signals(5000)
    with TdmsWriter(path) as file:
        properties = {"wf_increment": 2e-4, "unit_string": "Volts"}
        file.write_segment([ChannelObject("Untitled", "Voltage_0", 0.1 * data["torque"], properties)])
    edits = (("  Voltage_0: {quantity: voltage, unit: V}", "  # Voltage_0:"),
             ("# EDIT: Voltage_0: {quantity: torque, unit: V, Nm_per_V: NUMBER}",
              "Voltage_0: {quantity: torque, unit: V, Nm_per_V: 10}"))  # fmt: skip
    return Right(rate=5000, torque="Voltage_0", edits=edits)


def _lvm(path: Path, *, x_columns: str, notes: str = "", delta: float = 2e-4, decimal: str = ".") -> None:
    data = signals(5000)
    head = (
        f"LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t{decimal}\n"
        f"Multi_Headings\tYes\nX_Columns\t{x_columns}\nTime_Pref\tRelative\n***End_of_Header***\t\n\t\n"
    )
    blank = "\t" if x_columns == "Multi" else ""
    segment = (
        f"{notes}Channels\t2\t\t\nSamples\t20000\t{blank}20000\t\nY_Unit_Label\tNm\t{blank}rpm\t\n"
        f"X_Dimension\tTime\t{blank}Time\t\nX0\t0.0\t{blank}0.0\t\nDelta_X\t{delta:.6f}\t{blank}{delta:.6f}\t\n"
        "***End_of_Header***\t\n"
    ).replace(".", decimal)
    columns = {
        "No": [data["torque"], data["speed"]],
        "One": [data["time"], data["torque"], data["speed"]],
        "Multi": [data["time"], data["torque"], data["time"], data["speed"]],
    }[x_columns]
    labels = "X_Value\tTorque\tX_Value\tSpeed\tComment\n" if blank else "X_Value\tTorque\tSpeed\tComment\n"
    body = table(columns, separator="\t", decimal=decimal)
    if x_columns == "No":
        body = "".join(f"\t{line}\n" for line in body.splitlines())
    path.write_text(head + segment + labels + body)


_LVM_RIGHT = Right(rate=5000, torque="Torque", levels={"Speed": ("speed", "rpm", 1000)})


def _lvm_one(path: Path) -> Right:
    _lvm(path, x_columns="One")
    return _LVM_RIGHT


def _lvm_no(path: Path) -> Right:
    _lvm(path, x_columns="No", notes="Notes\trun of\tMay\n")
    return _LVM_RIGHT


def _lvm_multi(path: Path) -> Right:
    _lvm(path, x_columns="Multi")
    return _LVM_RIGHT


def _lvm_comma(path: Path) -> Right:
    _lvm(path, x_columns="One", decimal=",")
    return _LVM_RIGHT


def _lvm_default_delta(path: Path) -> Right:
    _lvm(path, x_columns="One", delta=1.0)
    return _LVM_RIGHT


def _mat_vectors(path: Path) -> Right:
    data = signals(5000)
    content = {"time_s": data["time"], "torque_Nm": data["torque"], "note": "run 3", "fs": 5000.0}
    savemat(path, content, oned_as="column")
    return Right(rate=5000, torque="torque_Nm")


def _mat_structs(path: Path) -> Right:
    data = signals(5000)
    content = {name: {"time": data["time"], "data": data[name]} for name in ("torque", "speed")}
    savemat(path, content, oned_as="column")
    before = "# EDIT: torque.data: {quantity: torque, unit: UNIT}"
    edits = (
        ('  torque.data: {quantity: other, unit: ""}', "  # torque.data:"),
        (before, "torque.data: {quantity: torque, unit: Nm}"),
    )
    return Right(rate=5000, torque="torque.data", edits=edits)


def _mat_73(path: Path) -> Right:
    data = signals(5000)
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, key in (("time_s", "time"), ("torque_Nm", "torque"), ("speed_rpm", "speed")):
            file.create_dataset(name, data=data[key].reshape(1, -1)).attrs["MATLAB_class"] = np.bytes_("double")
    return Right(rate=5000, torque="torque_Nm", levels={"speed_rpm": ("speed", "rpm", 1000)})


def _parquet(path: Path) -> Right:
    data = signals(5000)
    pd.DataFrame({"Time [s]": data["time"], "Torque [mNm]": 1e3 * data["torque"], "State": "run"}).to_parquet(path)
    return Right(rate=5000, torque="Torque")


def _wav(path: Path) -> Right:
    wavfile.write(path, 5000, (signals(5000)["torque"] / 4).astype(np.float32))
    edits = (("  channel_1: {quantity: other, unit: FS}", "  # channel_1:"),
             ("# EDIT: channel_1: {quantity: QUANTITY, unit: FS}",
              "channel_1: {quantity: torque, unit: FS, Nm_per_FS: 4}"))  # fmt: skip
    return Right(rate=5000, torque="channel_1", edits=edits)


def _hdf5(path: Path) -> Right:
    data = signals(5000)
    with h5py.File(path, "w") as file:
        group = file.create_group("run")
        for name, unit in (("torque", "Nm"), ("speed", "rpm")):
            one = group.create_dataset(name, data=data[name])
            one.attrs["unit"], one.attrs["sample_rate"] = unit, 5000.0
    return Right(rate=5000, torque="torque", levels={"speed": ("speed", "rpm", 1000)})


def _xlsx(path: Path) -> Right:
    data = signals(1000)
    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("Messung")
    for row in (["Prüfstand 3"], [], ["Zeit", "Drehmoment", "Drehzahl"], ["s", "Nm", "U/min"]):
        sheet.append(row)
    for row in zip(data["time"], data["torque"], data["speed"], strict=True):
        sheet.append([float(value) for value in row])
    book.save(path)
    return Right(rate=1000, torque="Drehmoment", levels={"Drehzahl": ("speed", "rev/min", 1000)})


def _gz(path: Path) -> Right:
    data = signals(5000)
    text = "Time [s],Torque [lb-ft]\n" + table([data["time"], data["torque"] / FOOT_POUND])
    path.write_bytes(gzip.compress(text.encode()))
    return Right(rate=5000, torque="Torque")


BINARIES: dict[str, tuple[str, Callable[[Path], Right]]] = {
    "tdms": (".tdms", _tdms), "tdms volts": (".tdms", _tdms_volts), "lvm one": (".lvm", _lvm_one),
    "lvm no": (".lvm", _lvm_no), "lvm multi": (".lvm", _lvm_multi), "lvm comma": (".lvm", _lvm_comma),
    "lvm default delta": (".lvm", _lvm_default_delta), "mat vectors": (".mat", _mat_vectors),
    "mat structs": (".mat", _mat_structs), "mat 7.3": (".mat", _mat_73), "parquet": (".parquet", _parquet),
    "wav": (".wav", _wav), "hdf5": (".h5", _hdf5), "xlsx": (".xlsx", _xlsx), "gz": (".csv.gz", _gz),
}  # fmt: skip
"""The other files: ending and maker of each."""
