"""How much of what was missed goes at the places that an effect changes for the better."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.judging.share_explained import share_explained

BEFORE = np.array([50.0, 31.0, 1.0, 9.0])


@pytest.mark.parametrize(
    ("after", "share"),
    [
        ([1.0, 1.0, 1.0, 9.0], 1.0),
        ([1.0, 31.0, 1.0, 9.0], 1.0),  # of its own places, whatever is wrong elsewhere
        ([25.5, 16.0, 1.0, 9.0], 0.5),
        ([50.0, 31.0, 1.0, 8.0], 0.0),  # no place that it changes clearly
        ([25.5, 16.0, 900.0, 9.0], 0.5),  # what it makes worse is asked for otherwise
    ],
)
def test_only_places_that_change_for_the_better_count(after: list[float], share: float) -> None:
    assert share_explained(BEFORE, np.array(after)) == pytest.approx(share)


def test_what_no_feature_holds_counts_too() -> None:
    after = np.array([1.0, 1.0, 1.0, 9.0])
    assert share_explained(BEFORE, after, beside=(79.0, 79.0)) == pytest.approx(0.5)
