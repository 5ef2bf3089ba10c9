"""Reads many damaged copies of small recordings: ``python damaged_files.py FORMAT COUNT``.

A copy has some changed bytes, a stretch of other bytes, or is cut short. Each must be read, or refused with one
sentence within 10 s. The process ends with 1 where that fails; a crash or a hang ends it with another number.
"""

import faulthandler
import resource
import struct
import sys
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
from nptdms import ChannelObject, TdmsWriter
from pyarrow import parquet
from scipy.io import savemat, wavfile

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.reading import readers
from torquerig.recordings.files.stream import STREAMS

LIMIT = 2**30  # bytes that reading may add
SECONDS = 10

TIME = np.arange(300) / 1000
TORQUE = np.round(np.sin(TIME * 90), 4)
COLUMNS = {"time_s": TIME, "torque_V": TORQUE, "count": np.arange(300, dtype=np.int32)}


def _mat5(path: Path) -> None:
    signals = np.empty((1, 2), dtype=[("values", object), ("label", object)])
    signals["values"][0, :] = [TORQUE, TIME]
    signals["label"][0, :] = ["a", "b"]
    content = {**COLUMNS, "scope": {"time": TIME, "signals": signals}, "on": TIME > 0.1, "note": "hello"}
    savemat(path, content, do_compression=False)


def _mat7(path: Path) -> None:
    savemat(path, {**COLUMNS, "rig": {"data": TORQUE, "fs": 1000.0}}, do_compression=True)


def _mat4(path: Path) -> None:
    savemat(path, COLUMNS, format="4")


def _hdf5(path: Path) -> None:
    with h5py.File(path, "w", userblock_size=512 if path.suffix == ".mat" else 0) as file:
        for name, values in COLUMNS.items():
            file.create_dataset(name, data=values[None, :] if path.suffix == ".mat" else values, compression="gzip")
        group = file.create_group("rig")
        group["data"] = TORQUE
        group["data"].attrs["unit"] = "Nm"


def _tdms(path: Path) -> None:
    scale = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Linear", "NI_Scale[0]_Linear_Slope": 0.5,
             "NI_Scale[0]_Linear_Y_Intercept": 1.0, "NI_Scale[0]_Linear_Input_Source": 0xFFFFFFFF}  # fmt: skip
    with TdmsWriter(path) as writer:
        for part in (slice(0, 150), slice(150, 300)):
            writer.write_segment(
                [
                    ChannelObject("rig", "torque", TORQUE[part], {"wf_increment": 1e-3, "unit_string": "Nm"}),
                    ChannelObject("rig", "raw", COLUMNS["count"][part].astype(np.int16), scale),
                    ChannelObject("rig", "note", ["a", "b"]),
                ]
            )


def _wav(path: Path) -> None:
    wavfile.write(path, 1000, np.stack([TORQUE, TIME], axis=1).astype(np.float32))


def _wav24(path: Path) -> None:
    data = np.random.default_rng(1).integers(0, 256, 900, dtype=np.uint8).tobytes()
    form = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, 1000, 3000, 3, 24)
    path.write_bytes(
        struct.pack("<4sI4s", b"RIFF", 36 + 900, b"WAVE") + form + struct.pack("<4sI", b"data", 900) + data
    )


def _parquet(path: Path) -> None:
    parquet.write_table(pa.table({**COLUMNS, "word": ["x"] * 300}), path, row_group_size=100)


def _mdf(path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from asammdf import MDF, Signal
    with MDF(version="4.10") as file:
        file.append([Signal(values, TIME, name=name, unit="Nm") for name, values in COLUMNS.items()])
        file.append([Signal(TORQUE[::10], TIME[::10], name="slow")])
        file.save(path, overwrite=True)


def _lvm(path: Path) -> None:
    head = "LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t.\nX_Columns\tMulti\n***End_of_Header***\n\n"
    segment = "Channels\t2\nSamples\t60\t\t60\nY_Unit_Label\tNm\t\trpm\nX_Dimension\tTime\t\tTime\nX0\t0\t\t0\n"
    segment += "Delta_X\t0.001\t\t0.001\n***End_of_Header***\nX_Value\ttorque\tX_Value\tspeed\tComment\n"
    rows = "".join(f"{x:.6f}\t{y:.6f}\t{x:.6f}\t{y * 9:.6f}\n" for x, y in zip(TIME[:60], TORQUE, strict=False))
    path.write_text(head + segment + rows + "\n" + segment + rows)


FORMATS: dict[str, tuple[str, Callable[[Path], None]]] = {
    "mat5": (".mat", _mat5), "mat7": (".mat", _mat7), "mat4": (".mat", _mat4), "mat73": (".mat", _hdf5),
    "hdf5": (".h5", _hdf5), "tdms": (".tdms", _tdms), "wav": (".wav", _wav), "wav24": (".wav", _wav24),
    "parquet": (".parquet", _parquet), "lvm": (".lvm", _lvm),
    "mdf": (".mf4", _mdf),
}  # fmt: skip


def damaged(data: bytes, random: np.random.Generator) -> bytes:
    """Return a damaged copy: changed bytes (half of them near the beginning or the end), a stretch, or a cut."""
    copy = bytearray(data)
    kind = random.integers(4)
    if kind == 0:
        return bytes(copy[: random.integers(len(copy))])
    if kind == 1:
        first = int(random.integers(len(copy)))
        stretch = random.integers(0, 256, random.integers(1, 64), dtype=np.uint8).tobytes()
        copy[first : first + len(stretch)] = stretch
        return bytes(copy)
    for _ in range(random.integers(1, 6)):
        near = min(len(copy), 600)
        where = (random.integers(len(copy)), random.integers(near), len(copy) - 1 - random.integers(near))
        copy[int(where[random.integers(3)])] = int(random.choice([0, 1, 0x7F, 0x80, 0xFF, random.integers(256)]))
    return bytes(copy)


def read(path: Path) -> None:
    """Read a file at once and in pieces; a refusal in one sentence is well."""
    for way in (_at_once, _in_pieces):
        try:
            way(path)
        except (RecordingError, InputError) as error:
            if "\n" in str(error):
                raise ValueError("the refusal has several lines") from error


def _at_once(path: Path) -> None:
    readers()[path.suffix](path)


def _in_pieces(path: Path) -> None:
    if path.suffix not in STREAMS:
        return
    pieces = STREAMS[path.suffix](path)
    for _ in pieces.pieces(pieces.names):
        pass


def main(form: str, count: str, seed: str = "1") -> None:
    """Read ``count`` damaged copies and print what fails."""
    ending, write = FORMATS[form]
    random = np.random.default_rng(int(seed))
    failed = False
    resource.setrlimit(resource.RLIMIT_AS, (8 * LIMIT, 8 * LIMIT))
    warnings.simplefilter("error")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"run{ending}"
        write(path)
        read(path)
        whole, before = path.read_bytes(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for number in range(int(count)):
            path.write_bytes(damaged(whole, random))
            faulthandler.dump_traceback_later(SECONDS, exit=True)
            try:
                read(path)
            except Exception as error:
                failed = True
                sys.stdout.write(f"{form} copy {number}: {type(error).__name__}: {str(error)[:200]}\n")
            faulthandler.cancel_dump_traceback_later()
        added = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024
    if added > LIMIT:
        failed = True
        sys.stdout.write(f"{form}: reading added {added / 2**20:.0f} MiB\n")
    sys.exit(int(failed))


if __name__ == "__main__":
    main(*sys.argv[1:])
