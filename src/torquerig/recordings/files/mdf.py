"""MDF4 and MDF3, the measurement format of vehicle tests (CANape, INCA, Dewesoft), through asammdf.

A damaged file can keep asammdf busy without end; it runs in a process of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.child_reading import ChildError, read_in_child, run_child
from torquerig.recordings.files.matlab.channels import channels_of
from torquerig.recordings.files.matlab.leaves import Leaf
from torquerig.recordings.files.matlab.tree import Unread, numbers
from torquerig.recordings.files.number_table import Table, distinct

_MODULE = "torquerig.recordings.files.mdf"


def read_mdf(path: Path) -> Table:
    """Read the channels of numbers of all groups, each with the rate of its group's times.

    A sample that the file marks as invalid becomes NaN. Names that two groups share become ``group.name``. Where the
    times of one group alone are uneven, they are kept as its times.

    Raises
    ------
    InputError
        When asammdf is not installed.
    RecordingError
        When the file is damaged, or holds no channel of numbers.
    """
    if find_spec("asammdf") is None:
        raise InputError(
            f"{path}: MDF files are read by asammdf, which is not installed; pip install 'torquerig[mdf]', or export "
            "the run as .mat, TDMS or CSV"
        )
    try:
        index, arrays = read_in_child(_MODULE, path)
    except ChildError as error:
        raise RecordingError(f"{path}: not a whole MDF file ({error}); copy it again from its source") from None
    leaves = [_leaf(description, array) for description, array in zip(index, arrays, strict=True)]
    found = channels_of(leaves, where=str(path), remedy="export the channels as .mat, TDMS or CSV")
    columns = {name: channel.read(0, channel.numbers.samples) for name, channel in found.channels.items()}
    return Table(
        columns=columns, rates=found.rates, units=found.units, skipped=found.skipped, notes=found.notes,
        starts=found.starts,
    )  # fmt: skip


def _leaf(description: Mapping[str, Any], array: NDArray[Any]) -> Leaf:
    path, reason = tuple(description["path"]), description["reason"]
    node = Unread(reason) if reason else numbers(array, is_logical=description["is_logical"])
    unit = "s" if description["is_time"] else description["unit"]
    return Leaf(path=path, node=node, unit=unit, is_time=description["is_time"], scope=path[:1])


def _read(path: str) -> list[tuple[dict[str, Any], NDArray[Any]]]:
    """Return the channels of all groups, each with its path, unit and kind, in the child process."""
    from asammdf import MDF

    with MDF(path) as file:
        return list(_arrays(file))


def _arrays(file: Any) -> Iterator[tuple[dict[str, Any], NDArray[Any]]]:
    stated = [str(getattr(group.channel_group, "acq_name", "") or "").strip() for group in file.groups]
    labels = distinct(label or f"group {order + 1}" for order, label in enumerate(stated))
    for order, (label, group) in enumerate(zip(labels, file.groups, strict=True)):
        master, has_time = file.masters_db.get(order), False
        for index, channel in enumerate(group.channels):
            if index == master:
                continue
            signal = file.get(group=order, index=index, ignore_invalidation_bits=True)
            samples = np.asarray(signal.samples)
            reason = _reason(samples)
            if not reason and not has_time and len(signal.timestamps) and master is not None:
                yield _described((label, "time"), is_time=True), np.asarray(signal.timestamps, dtype=np.float64)
                has_time = True
            about = _described(
                (label, str(channel.name)), unit=str(signal.unit or "").strip(), reason=reason,
                is_logical=samples.dtype.kind == "b",
            )  # fmt: skip
            yield about, np.empty(0) if reason else _valid(samples, signal.invalidation_bits)


def _described(
    path: tuple[str, str], *, unit: str = "", reason: str = "", is_time: bool = False, is_logical: bool = False
) -> dict[str, Any]:
    return {"path": path, "unit": unit, "reason": reason, "is_time": is_time, "is_logical": is_logical}


def _valid(samples: NDArray[Any], invalid: Any) -> NDArray[np.float64]:
    values = samples.astype(np.float64)
    if invalid is not None:
        values[np.asarray(invalid, dtype=bool)] = np.nan
    return values


def _reason(samples: NDArray[Any]) -> str:
    """Return why a channel is not read, or nothing."""
    if samples.ndim != 1 or samples.dtype.names:
        return "an array or a structure in each sample"
    return "" if samples.dtype.kind in "fiub" else "texts" if samples.dtype.kind in "SUO" else "no numbers"


if __name__ == "__main__":
    run_child(_read)
