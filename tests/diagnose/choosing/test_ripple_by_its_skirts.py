"""A ripple whose line drowns: what an unsteady load makes of it beside the line is asked for at the field's orders."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from torquerig.diagnose.hypotheses.commutation_ripple import propose
from torquerig.diagnose.looking.peaks import Peak
from torquerig.diagnose.looking.places import Place, order
from torquerig.mechanisms import CommutationRipple
from torquerig.rig.rig import Rig
from torquerig.scenario.reading import Scenario


@dataclass(frozen=True)
class Seen:
    places: tuple[Place, ...]


@dataclass(frozen=True)
class Bare:
    """Of a case what proposals without a left line ask for."""

    nominal: Rig
    seen: tuple[Seen, ...]
    left: tuple[Peak, ...] = field(default=())


@pytest.mark.parametrize(("shown", "asked"), [((7.0,), [42.0, 84.0]), ((7.0, 42.0), [84.0]), ((42.0, 84.0), [])])
def test_field_orders_without_a_line_are_asked_for(
    shown: tuple[float, ...], asked: list[float], wear_rig: Scenario
) -> None:
    case = Bare(wear_rig.rig, (Seen(tuple(order(at) for at in shown)),))
    found = [candidate.parts[0] for candidate in propose(case)]  # type: ignore[arg-type]
    assert [part.order_motor for part in found if isinstance(part, CommutationRipple)] == asked
