"""Which of several columns of times belongs to which column: by name, by number, by place, by length."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

from torquerig.recordings.names.time_column import words_without_time


def paired_times(names: Sequence[str], times: Sequence[str], lengths: Mapping[str, int]) -> dict[str, str]:
    """Return the column of times of each other column, as far as names, places and lengths determine it.

    Names come first (``t_torque`` and ``torque``), then equal numbers (``Time 1`` and ``Torque 1``), then the place:
    the times are in front of their columns. A column whose length only one column of times has belongs to that one.

    Parameters
    ----------
    names : sequence of str
        All columns in the order of the file, with the times.
    times : sequence of str
        The columns of times, two or more.
    lengths : mapping of str to int
        Samples of the columns, where they are known.
    """
    signals = [name for name in names if name not in times]
    found = _by_name(signals, times)
    plain = [one for one in times if not words_without_time(one)]
    if found:
        found |= {name: plain[0] for name in signals if name not in found and len(plain) == 1}
    else:
        found = _by_number(signals, times) or _by_place(names, times)
    fitting = {name: one for name, one in found.items() if _fits(name, one, lengths)}
    for name in signals:
        alike = [one for one in times if name in lengths and lengths.get(one) == lengths[name]]
        if name not in fitting and len(alike) == 1:
            fitting[name] = alike[0]
    return fitting


def named_pairs(names: Sequence[str], times: Sequence[str]) -> dict[str, str]:
    """Return the columns that have the same words as their column of times."""
    return _by_name([name for name in names if name not in times], times)


def _by_name(signals: Sequence[str], times: Sequence[str]) -> dict[str, str]:
    counts = Counter(words_without_time(one) for one in times)
    own = {words_without_time(one): one for one in times}
    words = {name: words_without_time(name) for name in signals}
    # numbers alone are no name
    return {
        name: own[key] for name, key in words.items()
        if counts[key] == 1 and not all(word.isdigit() for word in key)
    }  # fmt: skip


def _by_number(signals: Sequence[str], times: Sequence[str]) -> dict[str, str]:
    """Return the times of equal number where each column and each column of times has one."""
    own = {words_without_time(one): one for one in times}
    last = {name: (words_without_time(name) or ("",))[-1:] for name in signals}
    all_numbered = all(len(key) == 1 and key[0].isdigit() for key in own) and len(own) == len(times)
    if not all_numbered or any(key not in own for key in last.values()):
        return {}
    return {name: own[key] for name, key in last.items()}


def _by_place(names: Sequence[str], times: Sequence[str]) -> dict[str, str]:
    """Return the times in front of each column; nothing where the order shows no pairs."""
    is_time = [name in times for name in names]
    last = max((index for index, one in enumerate(is_time) if not one), default=-1)
    together = any(is_time[index] and is_time[index + 1] for index in range(last))
    # a first column without times and a last one of times may also be times behind their columns
    if together or not any(is_time[: last + 1]) or (not is_time[0] and is_time[-1]):
        return {}
    found: dict[str, str] = {}
    current = times[0]
    for name in names[: last + 1]:
        if name in times:
            current = name
        else:
            found[name] = current
    return found


def _fits(name: str, time: str, lengths: Mapping[str, int]) -> bool:
    return name not in lengths or time not in lengths or lengths[name] == lengths[time]
