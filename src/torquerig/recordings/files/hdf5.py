"""HDF5 files of plain datasets: vectors, columns of matrices, fields of compound datasets, with attributes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.matlab.channels import Channels, channels_of
from torquerig.recordings.files.matlab.leaves import Leaf, is_time_name
from torquerig.recordings.files.matlab.stated_rate import rate_of
from torquerig.recordings.files.matlab.tree import Numbers, Unread
from torquerig.recordings.files.matlab.version73 import stretch
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces

_UNITS = ("unit", "units", "unit_string", "einheit")
# scales that no convention defines; they are named and not applied
_OTHER_SCALES = ("gain", "scale", "scaling", "offset", "sensitivity", "conversion", "calibration")
_COLUMNS = ("columns", "column_names", "channels", "channel_names", "labels", "names")
_DEEPEST, _MOST = 40, 10_000  # groups within groups, and datasets; a logger writes tens of each
# what h5py raises for damaged files
_BROKEN = (ValueError, TypeError, OSError, EOFError, LookupError, NotImplementedError, RuntimeError, AttributeError)


def read_hdf5(path: Path) -> Table:
    """Read the 1-D datasets and the columns of 2-D and compound ones.

    The unit is an attribute ``unit`` or ``units`` of the dataset; the rate an attribute such as ``sample_rate``, ``fs``
    or ``dt`` [s] of the dataset or of a group around it. A dataset of times applies to its group. Names and times
    follow the same rules as the structs of a .mat file. Packed
    numbers (``scale_factor``, ``add_offset``) are unpacked.

    Raises
    ------
    RecordingError
        When the file is damaged, holds no vector of numbers, or states a rate and a step that contradict each other.
    """
    found = _channels(path)
    try:
        columns = {name: channel.read(0, channel.numbers.samples) for name, channel in found.channels.items()}
    except _BROKEN as error:
        raise _not_whole(path, error) from None
    return Table(
        columns=columns,
        rates=found.rates,
        units=found.units,
        skipped=found.skipped,
        notes=found.notes,
        starts=found.starts,
    )


def hdf5_pieces(path: Path) -> TablePieces:
    """Return the channels of an HDF5 file in pieces; RecordingError as :func:`read_hdf5`."""
    found = _channels(path)

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        channels = {name: found.channels[name] for name in names}
        for first in range(0, max((one.numbers.samples for one in channels.values()), default=0), PIECE):
            try:
                piece = {name: one.read(first, first + PIECE) for name, one in channels.items()}
            except _BROKEN as error:
                raise _not_whole(path, error) from None
            yield piece

    return TablePieces(
        names=tuple(found.channels),
        lengths={name: channel.numbers.samples for name, channel in found.channels.items()},
        pieces=pieces,
        rates=found.rates,
        units=found.units,
        skipped=found.skipped,
        notes=found.notes,
        starts=found.starts,
    )


def _channels(path: Path) -> Channels:
    import h5py

    try:
        with h5py.File(path, "r") as file:
            leaves = list(_leaves(path, file, (), (), rate=0.0, seen=set()))
    except RecordingError:
        raise
    except _BROKEN as error:
        raise _not_whole(path, error) from None
    try:
        return channels_of(leaves, where=str(path), remedy="save each channel as a 1-D dataset of numbers")
    except _BROKEN as error:
        raise _not_whole(path, error) from None


def _leaves(
    path: Path, group: Any, place: tuple[str, ...], scope: tuple[str, ...], *, rate: float, seen: set[Any]
) -> Iterator[Leaf]:
    """Yield the datasets of a group and of the groups in it; ``seen``, because links can lead in a circle."""
    import h5py

    if group in seen or len(place) > _DEEPEST:
        return
    seen.add(group)
    rate = _rate(group.attrs, f"{path}: {group.name}") or rate
    own = place if any(is_time_name(name) for name in group) else scope
    for name in group:
        item = group.get(name)
        if len(seen) > _MOST:
            raise RecordingError(f"{path}: it has more than {_MOST} datasets; save the channels of one run to a file")
        if isinstance(item, h5py.Group):
            yield from _leaves(path, item, (*place, name), own, rate=rate, seen=seen)
        elif isinstance(item, h5py.Dataset) and item not in seen:
            seen.add(item)
            yield from _dataset(path, item, (*place, name), own, rate)


def _dataset(path: Path, item: Any, place: tuple[str, ...], scope: tuple[str, ...], rate: float) -> Iterator[Leaf]:
    rate = _rate(item.attrs, f"{path}: {item.name}") or rate
    fields = item.dtype.names or (None,)
    along = int(np.argmax(item.shape)) if item.ndim else 0
    packing = _packing(item.attrs, f"{path}: {item.name}")
    for field in fields:
        kind = item.dtype if field is None else item.dtype[field]
        own = place if field is None else (*place, field)
        is_time = is_time_name(own[-1])
        if kind.kind not in "fiub" or kind.shape:
            yield Leaf(path=own, node=Unread(_reason(kind)), scope=scope)
            continue
        numbers = Numbers(
            shape=tuple(item.shape),
            read=partial(packing.read, partial(stretch, path, str(item.name), along, field=field)),
            is_logical=kind.kind == "b",
        )
        yield Leaf(
            path=own,
            node=numbers,
            unit=_text(item.attrs, _UNITS) if field is None else "",
            is_time=is_time,
            scope=place if len(fields) > 1 and any(is_time_name(str(one)) for one in fields) else scope,
            rate=0.0 if is_time else rate,
            columns=_texts(item.attrs, _COLUMNS) if field is None else (),
            note=_note(item.attrs, packing),
        )


def _reason(kind: Any) -> str:
    names = {"S": "texts", "O": "texts or references", "c": "complex numbers", "V": "a compound of other kinds"}
    return names.get(kind.kind, f"values of the type {kind}")


def _rate(attributes: Any, where: str) -> float:
    """Return the rate that attributes state, as a rate or as a step [Hz]; 0 where they do not."""
    return rate_of({str(name): value for name, value in attributes.items()}, where=where)


@dataclass(frozen=True)
class _Packing:
    """How stored numbers become values: ``number * factor + offset``; those equal to ``fill`` are missing."""

    factor: float = 1.0
    offset: float = 0.0
    fill: tuple[float, ...] = ()

    def read(self, stored: Callable[[int, int], NDArray[np.float64]], first: int, last: int) -> NDArray[np.float64]:
        """Return the values ``[first, last)``, shape (samples, columns)."""
        numbers = stored(first, last)
        if self.fill:
            numbers = np.where(np.isin(numbers, self.fill), np.nan, numbers)
        return numbers if (self.factor, self.offset) == (1.0, 0.0) else numbers * self.factor + self.offset


def _packing(attributes: Any, where: str) -> _Packing:
    """Return the packing that a dataset states.

    Raises
    ------
    RecordingError
        Where one of its attributes is no single number.

    Source: NetCDF Climate and Forecast (CF) Metadata Conventions 1.11, sections 2.5.1 (missing data) and 8.1 (packed
    data): the attributes ``scale_factor``, ``add_offset``, ``_FillValue``, ``missing_value``.
    """
    found = {key: attributes[key] for key in ("scale_factor", "add_offset") if key in attributes}
    for key, value in found.items():
        array = np.asarray(value)
        if array.size != 1 or array.dtype.kind not in "fiu" or not np.isfinite(array.flat[0]):
            raise RecordingError(f"{where}: its attribute {key} is no single number; correct it, or save scaled values")
    fill = [np.asarray(attributes[key]) for key in ("_FillValue", "missing_value") if key in attributes]
    numbers = {key: float(np.asarray(value).flat[0]) for key, value in found.items()}
    return _Packing(
        factor=numbers.get("scale_factor", 1.0),
        offset=numbers.get("add_offset", 0.0),
        fill=tuple(float(one) for array in fill if array.dtype.kind in "fiu" for one in array.flat),
    )


def _note(attributes: Any, packing: _Packing) -> str:
    """Return a sentence about what becomes of the scales that a dataset states; empty where it states none."""
    is_plain = (packing.factor, packing.offset) == (1.0, 0.0)
    notes = [] if is_plain else [f"its numbers are scaled: {packing.factor:.10g} * number + {packing.offset:.10g}"]
    for name, value in attributes.items():
        array = np.asarray(value)
        is_number = array.size == 1 and array.dtype.kind in "fiu"
        # a gain of 1 and an offset of 0 change nothing
        if str(name).lower() in _OTHER_SCALES and is_number and float(array.flat[0]) != (name.lower() != "offset"):
            notes.append(f"its attribute {name} = {float(array.flat[0]):.6g} is not applied; save scaled values")
    return "; ".join(notes)


def _text(attributes: Any, names: Sequence[str]) -> str:
    found = _texts(attributes, names)
    return found[0] if len(found) == 1 else ""


def _texts(attributes: Mapping[str, Any], names: Sequence[str]) -> tuple[str, ...]:
    lowered = {str(name).lower(): name for name in attributes}
    value = next((attributes[lowered[key]] for key in names if key in lowered), ())
    texts = [value] if isinstance(value, str | bytes) else list(np.asarray(value).flat)
    return tuple(
        (text.decode("utf-8", errors="replace") if isinstance(text, bytes) else text).strip()
        for text in texts
        if isinstance(text, str | bytes)
    )


def _not_whole(path: Path, error: Exception) -> RecordingError:
    return RecordingError(f"{path}: not a whole HDF5 file ({' '.join(str(error).split())}); copy it again")
