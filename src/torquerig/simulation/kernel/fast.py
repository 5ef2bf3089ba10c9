"""Compiler flags: permitted rearrangements of floating-point operations."""

from __future__ import annotations

from typing import Any

FAST = {"contract", "arcp", "nsz", "afn"}
# not nnan and ninf: a run that blows up must be seen; not reassoc: vector sums over a handful of terms cost 4 %
# numba counts the users of every array that it takes out of a tuple; in a loop of this size it no longer sees that it
# need not, which costs ten times the run; without counting nothing may be allocated inside
UNCOUNTED: dict[str, Any] = {"_nrt": False}
