"""Writers of .mat files that scipy and h5py do not write by themselves: objects, structs of v7.3."""

import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from scipy.io import savemat


def element(kind: int, data: bytes) -> bytes:
    return struct.pack("<II", kind, len(data)) + data + b"\0" * (-len(data) % 8)


def matlab_object(name: str, kind: str) -> bytes:
    """Return the bytes of a variable that is an object of the class ``kind``, as MATLAB stores it in a v7 file."""
    marks = np.array([[0xDD000000], [2], [1], [1], [1], [1]], dtype="<u4")
    inner = element(6, struct.pack("<II", 13, 0)) + element(5, struct.pack("<ii", 6, 1)) + element(1, b"")
    head = element(6, struct.pack("<II", 17, 0)) + element(1, name.encode()) + element(1, b"MCOS")
    return element(14, head + element(1, kind.encode()) + element(14, inner + element(6, marks.tobytes())))


def function_handle(name: str) -> bytes:
    head = element(6, struct.pack("<II", 16, 0)) + element(5, struct.pack("<ii", 1, 1)) + element(1, name.encode())
    return element(14, head + element(14, b""))


def struct_array(*elements: Mapping[str, Any]) -> np.ndarray:
    """Return a struct array for savemat."""
    array = np.empty((1, len(elements)), dtype=[(name, object) for name in elements[0]])
    for index, one in enumerate(elements):
        for name, value in one.items():
            array[name][0, index] = value
    return array


def write_v73(path: Path, content: Mapping[str, Any]) -> None:
    """Write variables as MATLAB does with -v7.3; dict: a struct, list of dict: a struct array."""
    with h5py.File(path, "w", userblock_size=512) as file:
        references = file.create_group("#refs#")
        for name, value in content.items():
            _put(file, name, value, references)
    with path.open("r+b") as raw:
        raw.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\x00\x02IM")


def _put(group: Any, name: str, value: Any, references: Any) -> None:
    if isinstance(value, dict):
        made = group.create_group(name)
        made.attrs["MATLAB_class"] = np.bytes_("struct")
        for field, one in value.items():
            _put(made, field, one, references)
    elif isinstance(value, list):
        made = group.create_group(name)
        made.attrs["MATLAB_class"] = np.bytes_("struct")
        for field in value[0]:
            links = np.empty((len(value), 1), dtype=h5py.ref_dtype)
            for index, one in enumerate(value):
                key = f"{len(references):x}_{field}"
                _put(references, key, one[field], references)
                links[index, 0] = references[key].ref
            made.create_dataset(field, data=links, dtype=h5py.ref_dtype)
    elif isinstance(value, str):
        dataset = group.create_dataset(name, data=np.array([[ord(sign)] for sign in value], dtype=np.uint16))
        dataset.attrs["MATLAB_class"] = np.bytes_("char")
    else:
        array = np.atleast_2d(np.asarray(value))
        if array.dtype.kind == "c":
            pair = np.empty(array.shape, dtype=[("real", "f8"), ("imag", "f8")])
            pair["real"], pair["imag"] = array.real, array.imag
            array = pair
        is_logical = array.dtype.kind == "b"
        dataset = group.create_dataset(name, data=(array.astype(np.uint8) if is_logical else array).T)
        dataset.attrs["MATLAB_class"] = np.bytes_("logical" if is_logical else "double")


def write(path: Path, content: Mapping[str, Any], version: str) -> Path:
    """Write as v6 (plain), v7 (compressed) or v7.3; a list of dict is a struct array."""
    if version == "7.3":
        write_v73(path, content)
    else:
        savemat(path, _for_scipy(content), do_compression=version == "7", oned_as="column")
    return path


def _for_scipy(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _for_scipy(one) for name, one in value.items()}
    if isinstance(value, list):
        return struct_array(*(_for_scipy(one) for one in value))
    return value
