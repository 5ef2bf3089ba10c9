"""The reader of .mat files against scipy, and files that are made to harm."""

import struct
import time
import zlib
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat, savemat

from tests.recordings.files.matlab.matlab_files import element
from torquerig.errors import RecordingError
from torquerig.recordings.files.mat import read_mat
from torquerig.recordings.files.matlab.version5 import variables_v5

KINDS = ("f8", "f4", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", ">f8", ">i2")


@pytest.mark.parametrize("form", ["4", "5"])
@pytest.mark.parametrize("packed", [False, True])
def test_numbers_equal_those_of_scipy(tmp_path: Path, form: str, packed: bool) -> None:
    random = np.random.default_rng(1)
    kinds = KINDS if form == "5" else ("f8", "i4", "i2", "u2", "u1")
    content = {f"x{index}": (100 * random.random((40, 1 + index % 3))).astype(kind) for index, kind in enumerate(kinds)}
    savemat(tmp_path / "run.mat", content, format=form, do_compression=packed)
    ours, theirs = read_mat(tmp_path / "run.mat").columns, loadmat(tmp_path / "run.mat")
    for name in content:
        for column in range(theirs[name].shape[1]):
            label = name if theirs[name].shape[1] == 1 else f"{name}_{column + 1}"
            assert np.array_equal(ours[label], theirs[name][:, column].astype(float)), label


def test_a_file_of_the_other_byte_order() -> None:
    values = np.arange(5.0)
    tags = [struct.pack(">II", 6, 8) + struct.pack(">II", 6, 0), struct.pack(">IIii", 5, 8, 5, 1),
            struct.pack(">HH4s", 1, 1, b"x"), struct.pack(">II", 9, 40) + values.astype(">f8").tobytes()]  # fmt: skip
    body = b"".join(tags)
    head = b"MATLAB 5.0".ljust(124) + b"\x01\x00MI"
    found = variables_v5(head + struct.pack(">II", 14, len(body)) + body)
    assert found["x"].read(0, 5)[:, 0].tolist() == values.tolist()  # type: ignore[union-attr]


def test_a_small_file_that_unpacks_to_much(tmp_path: Path) -> None:
    count = 2**28
    head = element(6, struct.pack("<II", 9, 0)) + element(5, struct.pack("<ii", count, 1)) + element(1, b"bomb")
    head += struct.pack("<II", 2, count)
    stream = zlib.compressobj(9)
    packed = stream.compress(struct.pack("<II", 14, len(head) + count) + head)
    packed += b"".join(stream.compress(bytes(2**24)) for _ in range(2**4)) + stream.flush()
    savemat(tmp_path / "run.mat", {"time_s": np.arange(9.0), "torque_Nm": np.arange(9.0)})
    with (tmp_path / "run.mat").open("ab") as file:
        file.write(struct.pack("<II", 15, len(packed)) + packed)
    begin = time.process_time()
    table = read_mat(tmp_path / "run.mat")
    assert time.process_time() - begin < 0.3  # unpacking takes a second
    assert list(table.columns) == ["time_s", "torque_Nm"]
    assert "60 times the size of the file" in table.skipped["bomb"]


def test_structs_nested_without_end(tmp_path: Path) -> None:
    inner = element(14, b"")
    for _ in range(60):
        flags = element(6, struct.pack("<II", 2, 0)) + element(5, struct.pack("<ii", 1, 1))
        inner = element(
            14, flags + element(1, b"s") + element(5, struct.pack("<i", 8)) + element(1, b"s".ljust(8, b"\0")) + inner
        )
    (tmp_path / "run.mat").write_bytes(b"MATLAB 5.0".ljust(124) + b"\x00\x01IM" + inner)
    with pytest.raises(RecordingError, match="nested more than 40 deep"):
        read_mat(tmp_path / "run.mat")


def test_a_struct_of_more_elements_than_bytes(tmp_path: Path) -> None:
    flags = element(6, struct.pack("<II", 2, 0)) + element(5, struct.pack("<ii", 2**30, 1)) + element(1, b"s")
    body = flags + element(5, struct.pack("<i", 8)) + element(1, b"s".ljust(8, b"\0"))
    (tmp_path / "run.mat").write_bytes(b"MATLAB 5.0".ljust(124) + b"\x00\x01IM" + element(14, body))
    with pytest.raises(RecordingError, match="more elements than bytes"):
        read_mat(tmp_path / "run.mat")
