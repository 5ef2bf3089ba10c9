"""A ripple or cogging whose line drowns: what an unsteady run makes of it beside the line is asked for."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pytest

from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.diagnosis.hypotheses import cogging
from torquerig.diagnosis.hypotheses.commutation_ripple import _by_its_skirts, propose
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import Place, order
from torquerig.mechanisms import Cogging, CommutationRipple
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor
from torquerig.scenario.model import Scenario


@dataclass(frozen=True)
class Seen:
    places: tuple[Place, ...]
    unknown: tuple[Place, ...] = ()
    turning: None = None


@dataclass(frozen=True)
class Fits:
    """A model that misses no line of its own."""

    misfits: tuple[Misfit, ...]


@dataclass(frozen=True)
class Bare:
    """Of a case what proposals without a left line ask for."""

    nominal: Rig
    seen: tuple[Seen, ...]
    left: tuple[Peak, ...] = field(default=())

    @property
    def model(self) -> Fits:
        """The model as fitted."""
        none = np.zeros(0)
        return Fits(tuple(Misfit(none, np.zeros(len(seen.places)), none) for seen in self.seen))


@pytest.mark.parametrize(("shown", "asked"), [((7.0,), [42.0, 84.0]), ((7.0, 42.0), [84.0]), ((42.0, 84.0), [])])
def test_field_orders_without_a_line_are_asked_for(
    shown: tuple[float, ...], asked: list[float], wear_rig: Scenario
) -> None:
    case = Bare(wear_rig.rig, (Seen(tuple(order(at) for at in shown)),))
    found = [candidate.parts[0] for candidate in propose(case)]  # type: ignore[arg-type]
    ripples = [part for part in found if isinstance(part, CommutationRipple)]
    assert [part.order_motor for part in ripples if not part.harmonics] == asked
    assert [part.order_motor for part in ripples if part.harmonics] == asked, "the same with a second harmonic"


def test_an_order_is_asked_for_again_when_its_line_is_left_no_more(wear_rig: Scenario) -> None:
    """A small line that a strong effect beside it took along leaves the noise around it unexplained."""
    places = (order(7.0), order(42.0))
    found = {}
    for left in ((Peak(order(42.0), 90.0, ("run.parquet",), 2),), ()):
        case = Bare(wear_rig.rig, (Seen(places, unknown=(order(42.0),)),), left)
        by_skirts = _by_its_skirts(case, wear_rig.rig.parts_of(Motor)[0])  # type: ignore[arg-type]
        found[left] = list(dict.fromkeys(candidate.place for candidate in by_skirts))
    assert list(found.values()) == [[order(84.0)], [order(42.0), order(84.0)]]


def test_the_twelfth_order_alone_pays_for_the_sixth_that_is_not_there(wear_rig: Scenario) -> None:
    """At one load cogging of order 84 makes the same line, and needs no excuse."""
    case = Bare(wear_rig.rig, (Seen((order(7.0),)),))
    prices = {candidate.place: candidate.price for candidate in propose(case)}  # type: ignore[arg-type]
    (native,) = cogging.propose(case)  # type: ignore[arg-type]
    assert native.price == prices[order(42.0)] < prices[order(84.0)] < native.price + 10.0


@pytest.mark.parametrize(("shown", "asked"), [((7.0, 42.0), [84]), ((84.0,), [])])
def test_cogging_without_a_line_is_asked_for_at_its_native_order(
    shown: tuple[float, ...], asked: list[int], wear_rig: Scenario
) -> None:
    case = Bare(wear_rig.rig, (Seen(tuple(order(at) for at in shown)),))
    found = [candidate.parts[0] for candidate in cogging.propose(case)]  # type: ignore[arg-type]
    orders = [at for part in found if isinstance(part, Cogging) for at, size in part.amplitudes().items() if size > 0]
    assert orders == asked
