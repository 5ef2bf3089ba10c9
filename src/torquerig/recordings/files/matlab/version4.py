"""The variables of a .mat file of v4: a header of five numbers, the name, and the numbers of each matrix."""

from __future__ import annotations

import struct

import numpy as np

from torquerig.recordings.files.matlab.tree import Node, Unread, numbers
from torquerig.recordings.files.matlab.version5 import DamagedError

_KINDS = ("f8", "f4", "i4", "i2", "u2", "u1")
_LONGEST_NAME = 64  # MATLAB allows 63 characters and a zero


def is_v4(data: bytes) -> bool:
    """Return whether the bytes begin as a v4 file does; newer ones begin with a text."""
    return len(data) >= 20 and 0 in data[:4]


def variables_v4(data: bytes) -> dict[str, Node]:
    """Return the variables of the bytes of a file; DamagedError where a size does not fit the file.

    Source: MathWorks, "MAT-File Format", version 4.
    """
    found: dict[str, Node] = {}
    place = 0
    while place < len(data):
        if len(data) - place < 20:
            raise DamagedError("it ends within the header of a variable")
        order = "<" if struct.unpack_from("<I", data, place)[0] < 5000 else ">"
        code, rows, columns, has_imaginary, length = struct.unpack_from(order + "5I", data, place)
        machine, reserved, kind, form = code // 1000, code // 100 % 10, code // 10 % 10, code % 10
        if machine > 1 or reserved or kind >= len(_KINDS) or form > 2 or has_imaginary > 1 or length > _LONGEST_NAME:
            raise DamagedError("the header of a variable is not possible")
        number = np.dtype(order + _KINDS[kind])
        begin = place + 20 + length
        count = rows * columns
        place = begin + count * number.itemsize * (1 + has_imaginary)
        if place > len(data):
            raise DamagedError("it ends within a variable")
        name = data[begin - length : begin].partition(b"\0")[0].decode("latin-1")
        values = np.frombuffer(data, number, count, begin).reshape((rows, columns), order="F")
        if form == 1:
            found[name] = "".join(chr(int(sign) & 0xFFFF) for sign in values.flat[:4096] if np.isfinite(sign))
        elif form == 2 or has_imaginary:
            found[name] = Unread("a sparse matrix" if form == 2 else "complex numbers; save real and imaginary part")
        else:
            found[name] = numbers(values)
    return found
