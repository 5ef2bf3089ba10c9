"""The variables of a .mat file of v5, v6 or v7: each size is checked against the file before it is used.

scipy reads the same files, but a changed byte in one can end the process with a segmentation fault.
"""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass, replace
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.matlab.tree import Node, Struct, Unread, numbers, object_reason

_HEADER = 128
_MATRIX, _COMPRESSED = 14, 15
_KINDS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
_TEXTS = {1: "latin-1", 2: "latin-1", 4: "utf-16", 16: "utf-8", 17: "utf-16", 18: "utf-32"}
_CELL, _STRUCT, _OBJECT, _CHAR, _SPARSE, _FIRST_NUMBER, _LAST_NUMBER, _FUNCTION, _OPAQUE = 1, 2, 3, 4, 5, 6, 15, 16, 17
# structs within structs; models of a plant nest five to ten deep, and Python's stack holds a thousand
_DEEPEST = 40
# A recording unpacks to 1 to 20 times its file; a constant to 1000 times, so that 1 MB could fill the memory. What
# exceeds 60 times is left out, unless all variables together stay below 64 MB.
_LARGEST_RATIO, _HARMLESS = 60, 2**26


class DamagedError(ValueError):
    """The bytes are no whole .mat file."""


class _Element(NamedTuple):
    kind: int
    data: memoryview


@dataclass
class _Reader:
    """Reads the elements of one stretch of bytes, in order."""

    data: memoryview
    order: str
    depth: int = 0
    place: int = 0

    def more(self) -> bool:
        return self.place < len(self.data)

    def element(self) -> _Element:
        if len(self.data) - self.place < 8:
            raise DamagedError("it ends within the header of a variable")
        first, size = struct.unpack_from(self.order + "II", self.data, self.place)
        if first >> 16:  # at most four bytes stand in the header itself
            size, first, begin, length = first >> 16, first & 0xFFFF, self.place + 4, 8
            if size > 4:
                raise DamagedError("the size of an element is not possible")
        else:
            begin, length = self.place + 8, 8 + size + (0 if first == _COMPRESSED else -size % 8)
        if begin + size > len(self.data):
            raise DamagedError("it ends within a variable")
        self.place += length
        return _Element(first, self.data[begin : begin + size])

    def within(self, data: memoryview) -> _Reader:
        if self.depth >= _DEEPEST:
            raise DamagedError(f"its structs are nested more than {_DEEPEST} deep")
        return replace(self, data=data, depth=self.depth + 1, place=0)


def variables_v5(data: bytes) -> dict[str, Node]:
    """Return the variables of the bytes of a file.

    Raises
    ------
    DamagedError
        A size that does not fit the file, an unknown type, dimensions that do not fit the data, a variable twice.

    Source: MathWorks, "MAT-File Format", version 5: data elements, array subelements, mxOPAQUE as scipy documents it.
    """
    if len(data) < _HEADER:
        raise DamagedError(f"it ends after {len(data)} bytes, within the header")
    order = {b"IM": "<", b"MI": ">"}.get(data[126:128])
    if order is None:
        raise DamagedError("its header states no byte order")
    reader = _Reader(memoryview(data)[_HEADER:], order)
    allowance = max(_HARMLESS, _LARGEST_RATIO * len(data))
    found: dict[str, Node] = {}
    while reader.more():
        element = reader.element()
        if element.kind == _COMPRESSED:
            content, is_whole = _unpacked(element.data, order, most=allowance)
            allowance -= len(content)
        elif element.kind == _MATRIX:
            content, is_whole = element.data, True
        else:
            raise DamagedError(f"an element of the type {element.kind} is no variable")
        name, node = _variable(reader.within(content), is_whole=is_whole)
        if name in found:
            raise DamagedError(f"it holds the variable {name} twice")
        if name:  # the data of MATLAB's objects have no name
            found[name] = node
    return found


def _unpacked(packed: memoryview, order: str, *, most: int) -> tuple[memoryview, bool]:
    """Return the content of a compressed variable, and whether it is whole; the head of one of more than ``most``."""
    stream = zlib.decompressobj()
    try:
        head = stream.decompress(packed, 8)
        if len(head) < 8:
            raise DamagedError("a compressed variable ends early")
        kind, size = struct.unpack(order + "II", head)
        if kind != _MATRIX:
            raise DamagedError(f"a compressed element of the type {kind} is no variable")
        if size > most:
            return memoryview(stream.decompress(stream.unconsumed_tail, 4096)), False
        content = stream.decompress(stream.unconsumed_tail, size + 1)
    except zlib.error as error:
        raise DamagedError(str(error)) from None
    if len(content) != size or not (stream.eof or _ended(stream)):
        raise DamagedError("a compressed variable is shorter or longer than it states")
    return memoryview(content), True


def _ended(stream: zlib._Decompress) -> bool:
    """Read the checksum at the end of a stream and return whether nothing else was there."""
    return not stream.decompress(stream.unconsumed_tail, 1) and stream.eof


def _variable(reader: _Reader, *, is_whole: bool = True) -> tuple[str, Node]:
    """Return name and content of one array."""
    flags = reader.element()
    if flags.kind != 6 or len(flags.data) != 8:
        raise DamagedError("a variable has no flags")
    word = struct.unpack_from(reader.order + "I", flags.data)[0]
    kind = word & 0xFF
    if kind == _OPAQUE:
        name, _, group = (_text(reader.element()) for _ in range(3))
        return name, Unread(object_reason(group), kind=group)
    shape = tuple(int(size) for size in _plain(reader.element(), reader.order, kinds=(5,)))
    if len(shape) < 2 or any(size < 0 for size in shape):
        raise DamagedError("the dimensions of a variable are not possible")
    name = _text(reader.element())
    if not is_whole:
        return name, Unread("it unpacks to more than 60 times the size of the file, as a constant does")
    return name, _content(reader, kind, shape, is_complex=bool(word & 0x800), is_logical=bool(word & 0x200))


def _content(reader: _Reader, kind: int, shape: tuple[int, ...], *, is_complex: bool, is_logical: bool) -> Node:
    if kind in (_STRUCT, _OBJECT):
        label = _text(reader.element()) if kind == _OBJECT else ""
        fields = _struct(reader, prod(shape))
        return Unread(object_reason(label), kind=label) if kind == _OBJECT else fields
    if kind == _CHAR:
        return _chars(reader.element(), reader.order, shape)
    if kind in (_CELL, _SPARSE, _FUNCTION):
        return Unread({_CELL: "a cell array", _SPARSE: "a sparse matrix", _FUNCTION: "a function handle"}[kind])
    if not _FIRST_NUMBER <= kind <= _LAST_NUMBER:
        raise DamagedError(f"a variable of the class {kind} is not known")
    values = _plain(reader.element(), reader.order, kinds=tuple(_KINDS))
    if values.size != prod(shape):
        raise DamagedError(f"a variable has {values.size} numbers and dimensions for {prod(shape)}")
    if is_complex:
        return Unread("complex numbers; save real and imaginary part, or abs, as vectors")
    return numbers(values.reshape(shape, order="F"), is_logical=is_logical)


def _struct(reader: _Reader, elements: int) -> Struct:
    length = _plain(reader.element(), reader.order, kinds=(5,))
    names = bytes(reader.element().data)
    width = int(length[0]) if length.size == 1 else 0
    if width < 1 or len(names) % width:
        raise DamagedError("the names of a struct's fields are not whole")
    fields = [
        names[first : first + width].partition(b"\0")[0].decode("latin-1") for first in range(0, len(names), width)
    ]
    if elements * max(len(fields), 1) * 8 > len(reader.data):
        raise DamagedError("a struct has more elements than bytes")
    found: Struct = []
    for _ in range(elements):
        found.append({})
        for field in fields:
            element = reader.element()
            if element.kind != _MATRIX:
                raise DamagedError("a field of a struct is no array")
            found[-1][field] = _variable(reader.within(element.data))[1] if len(element.data) else Unread("empty")
    return found


def _plain(element: _Element, order: str, *, kinds: tuple[int, ...]) -> NDArray[np.generic]:
    if element.kind not in kinds:
        raise DamagedError(f"numbers of the type {element.kind} are not known here")
    kind = np.dtype(order + _KINDS[element.kind])
    if len(element.data) % kind.itemsize:
        raise DamagedError("a variable ends within a number")
    return np.frombuffer(element.data, kind)


def _text(element: _Element) -> str:
    if element.kind not in (1, 2, 16):
        raise DamagedError(f"a name of the type {element.kind} is not known")
    return bytes(element.data).decode("utf-8", errors="replace").rstrip("\0")


def _chars(element: _Element, order: str, shape: tuple[int, ...]) -> Node:
    """Return a text of one row; a matrix of characters, whose columns are stored first, is not read."""
    if element.kind not in _TEXTS:
        raise DamagedError(f"a text of the type {element.kind} is not known")
    if shape[0] > 1:
        return Unread("a list of texts")
    coding = _TEXTS[element.kind]
    end = {"<": "-le", ">": "-be"}[order] if coding.startswith("utf-") and coding != "utf-8" else ""
    return bytes(element.data).decode(coding + end, errors="replace")
