"""Which trials are begun a second time, from where the model stands apart from lines it lacks."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from torquerig.diagnosis.choosing import search

FEATURES = 100


def trial(cost: float) -> Any:
    model = SimpleNamespace(cost=cost, misfits=[SimpleNamespace(seen=FEATURES)])
    return SimpleNamespace(gain=1000.0 - cost, model=model)


@pytest.mark.parametrize(
    ("costs", "near", "again"),
    [
        ([300.0, 600.0, 900.0], np.inf, [300.0, 600.0]),
        ([110.0, 300.0], np.inf, [300.0]),
        ([300.0, 600.0], 2 * 250.0, [300.0]),
        ([300.0, 600.0], 2 * 100.0, []),
    ],
    ids=["of half the best gain", "not right yet", "near what is to be beaten", "none comes near"],
)
def test_those_are_that_come_near_and_are_not_right_yet(
    costs: list[float], near: float, again: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    begun = list[float]()

    def from_apart(case: object, one: Any) -> Any:
        begun.append(one.model.cost)
        return trial(one.model.cost - 5.0)

    monkeypatch.setattr(search, "_from_here", lambda case, one: one)
    monkeypatch.setattr(search, "_from_apart", from_apart)
    fitted = search._fitted(SimpleNamespace(), [trial(cost) for cost in costs], near=near)  # type: ignore[arg-type]
    assert begun == again
    assert [one.model.cost for one in fitted] == [cost - 5.0 * (cost in again) for cost in costs]
