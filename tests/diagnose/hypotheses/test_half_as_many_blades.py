"""Half as many blades are another hypothesis, whose first line the rig's own may hide."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

from torquerig.diagnose.case import Case
from torquerig.diagnose.choosing.screening import finalists
from torquerig.diagnose.choosing.trial import Trial
from torquerig.diagnose.hypotheses import blade_pass


def test_half_as_many_are_fitted_beside_those_of_the_line_that_shows(with_lines_left: Callable[..., Case]) -> None:
    """Of 4 blades behind 5:1 the first line is the rig's own order 4, and the second, order 8, is left."""
    candidates = list(blade_pass.propose(with_lines_left(1.6)))
    assert [cast(Any, each.parts[0]).order_output for each in candidates] == [8.0, 4.0]
    fitted = finalists([Trial(each, cast(Any, None), 631.0 - row) for row, each in enumerate(candidates)])
    assert [one.candidate for one in fitted] == candidates
