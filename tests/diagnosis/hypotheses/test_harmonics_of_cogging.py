"""Cogging whose second harmonic smears for want of an encoder is proposed with it, as a mesh is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import cogging


def orders_of(case: Case) -> list[list[int]]:
    parts = [cast(Any, each.parts[0]) for each in cogging.propose(case)]
    return [sorted(at for at, size in part.amplitudes().items() if size) for part in parts]


@pytest.mark.parametrize(
    ("excess", "measured", "proposed"),
    [(300.0, False, [[56], [56, 112]]), (300.0, True, [[56]]), (50.0, False, [[56]])],
)
def test_a_strong_line_may_have_a_harmonic_that_shows_in_bands(
    excess: float, measured: bool, proposed: list[list[int]], with_lines_left: Callable[..., Case]
) -> None:
    case = cast(Any, with_lines_left(56.0))
    case.left = tuple(replace(peak, excess=excess) for peak in case.left)
    case.runs = (SimpleNamespace(steady=True, angle_measured=measured),)
    assert orders_of(cast(Case, case)) == proposed


def test_a_harmonic_that_shows_is_told_by_its_own_line(with_lines_left: Callable[..., Case]) -> None:
    case = cast(Any, with_lines_left(56.0, 112.0))
    case.left = tuple(replace(peak, excess=300.0) for peak in case.left)
    case.runs = (SimpleNamespace(steady=True, angle_measured=False),)
    assert all(112 in orders for orders in orders_of(cast(Case, case)))
