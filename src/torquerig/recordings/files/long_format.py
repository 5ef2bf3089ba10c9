"""Tables in long format: one row for each channel and time, with the number of the channel in a column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.names.words import words_of

# more channels than this are no channels [1], and rows from which the pattern is judged
_MOST, _JUDGED = 64, 6
# names of a column that numbers channels
_CHANNEL = ("channel", "chan", "ch", "kanal", "sensor", "signal", "variable", "tag", "quantity", "id", "node")


def refuse_long_format(
    times: NDArray[np.float64], columns: Mapping[str, NDArray[np.float64]], *, skipped: Iterable[str], name: str,
    where: str,
) -> None:  # fmt: skip
    """Raise RecordingError where several channels alternate, or follow one another, in the rows of one column.

    Parameters
    ----------
    times : ndarray, shape (samples,)
    columns : mapping of str to ndarray, shape (samples,)
        The columns of numbers without the times.
    skipped : iterable of str
        The columns of words.
    name, where : str
        Of the column of times and of the file.
    """
    if times.size < _JUDGED or not np.isfinite(times).all():
        return
    count = _times_repeated(times)
    if count > 1:
        column = next((one for one, values in columns.items() if _numbers_rows(one, values, count)), None)
        column = column or next((one for one in skipped if _is_channel(one)), None)
        if column is not None:
            raise RecordingError(
                f"{where}: each time of {name} stands {count} times, and the column {column} numbers the rows: the "
                f"samples of {count} channels are mixed; save one column for each channel"
            )
    falls = np.flatnonzero(np.diff(times) < 0) + 1
    if not 0 < falls.size < _MOST:
        return
    for one, values in columns.items():
        # where times begin again, the number of the channel changes, and nowhere else
        if values.size == times.size and np.array_equal(np.flatnonzero(np.diff(values)) + 1, falls):
            raise RecordingError(
                f"{where}: {name} begins again where the column {one} changes: the samples of {falls.size + 1} "
                "channels follow one another; save one column for each channel"
            )


def _times_repeated(times: NDArray[np.float64]) -> int:
    """Return how often each time stands in succession; 1 where they do not stand equally often."""
    places = np.flatnonzero(np.diff(times)) + 1
    count = int(places[0]) if places.size else 1
    whole = times.size // count * count
    groups = times[:whole].reshape(-1, count)
    is_regular = count <= _MOST and groups.shape[0] > 1 and bool(np.all(groups == groups[:, :1]))
    return count if is_regular and bool(np.all(np.diff(groups[:, 0]) != 0)) else 1


def _numbers_rows(name: str, values: NDArray[np.float64], count: int) -> bool:
    """Return whether the column holds the same ``count`` different whole numbers for each time."""
    groups = values[: values.size // count * count].reshape(-1, count)
    first = groups[0]
    if not np.all(groups == first) or np.unique(first).size < count or not np.all(first == np.round(first)):
        return False
    # two values that alternate may also be a state
    return _is_channel(name) or (count > 2 and np.ptp(first) == count - 1)


def _is_channel(name: str) -> bool:
    return any(word in _CHANNEL for word in words_of(name))
