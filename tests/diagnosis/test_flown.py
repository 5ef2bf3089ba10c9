"""Flights tell of a gap in several runs, or in the only one whose torque comes near zero."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from torquerig.diagnosis import believed
from torquerig.inference.answer.mismatch import Mismatch


def missed(*runs: str, axis: str = "V") -> Mismatch:
    return Mismatch(
        domain="distribution", axis=axis, at=0.0, width=0.03, recordings=runs, excess_dB=40.0,
        share_of_misfit=0.0, p_value=1e-50,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("may", "mismatch", "flown"),
    [
        (("run4",), missed("run4"), True),
        (("run3", "run4"), missed("run4"), False),
        (("run2", "run3", "run4"), missed("run3", "run4"), True),
        ((), missed("run4"), False),
        (("run4",), missed("run4", axis="Nm"), False),
    ],
    ids=["the only one that may", "one of two", "two of three", "none may", "no flights"],
)
def test_flights_in_one_run_tell_where_no_other_could_show_them(
    may: tuple[str, ...], mismatch: Mismatch, flown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(believed, "flanks_may_part", lambda seen: seen in may)
    case: Any = SimpleNamespace(from_zero=("run1", "run2", "run3", "run4"))
    assert believed._flown(case, (mismatch,)) is flown
