"""Beside a hum that sounds all along, a harmonic hidden among other lines is its own."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import mains_interference
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency
from torquerig.mechanisms import MainsInterference

FIRST = Peak(frequency(49.99), 150.0, ("run.parquet",), 2)


@pytest.mark.parametrize(("fifth", "its"), [(249.935, True), (250.3, False)])
def test_a_harmonic_at_its_place_belongs_to_the_hum(fifth: float, its: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    case = cast(Case, SimpleNamespace(left=(FIRST, Peak(frequency(fifth), 90.0, ("run.parquet",), 2))))

    def steady(_: Any) -> list[Peak]:
        return [FIRST]

    monkeypatch.setattr(mains_interference, "fixed_lines", steady)
    (candidate,) = mains_interference.propose(case)
    (part,) = candidate.parts
    assert isinstance(part, MainsInterference)
    assert len(part.amplitudes) == (5 if its else 3)
    assert part.frequency == pytest.approx(249.935 / 5 if its else 49.99)
