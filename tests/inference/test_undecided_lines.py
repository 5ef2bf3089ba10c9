"""A line at one speed is an order and a frequency; hypotheses about it compete, others do not."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data
from torquerig.inference.knobs import Knob
from torquerig.inference.places import frequency, order
from torquerig.inference.search import FITTED, competes, is_instead, most_promising, wins
from torquerig.inference.undecided_lines import column_of, in_both_domains

LINE = FoundLine(order(3.0), -60.0, -50.0)
SPEEDS = {"one": [steady(1000), steady(1000)], "two": [steady(1000), steady(1100)], "ramp": [ramp(1000)],
          "both": [steady(1000), ramp(1000)]}  # fmt: skip


@pytest.mark.parametrize("speeds", SPEEDS)
def test_a_line_is_in_both_domains_where_all_runs_have_one_speed(speeds):
    seen = [run_features(drawn_run(1, speed=speed, orders={3.0: 0.5}), []) for speed in SPEEDS[speeds]]
    found = in_both_domains([LINE, FoundLine(frequency(7.0), -60.0, 0.0)], seen)
    assert found[0] == LINE
    others = {line.place.domain: line.place.at for line in found[2:]}
    assert others == pytest.approx({"frequency": 50.0, "order": 0.42} if speeds == "one" else {})


def test_a_tone_keeps_the_frequency_that_was_found():
    seen = [run_features(drawn_run(1, speed=steady(1000), orders={3.0: 0.5}), [])]
    found = in_both_domains([FoundLine(order(3.0), -60.0, -50.0, frequency(50.004))], seen)
    assert [line.place for line in found] == [order(3.0), frequency(50.004)]
    assert found[1].other_place == order(3.0)


def test_numbers_leave_room_for_parts_that_promise_less():
    numbers = [
        Addition(kind="parameter", knobs=(Knob("shaft", name, 1.0),)) for name in ("stiffness", "damping", "inertia")
    ]
    low_pass, drag = (Addition(mechanism=name, parts=(name,)) for name in ("sensor_bandwidth", "quadratic_drag"))
    data = Data.of([run_features(drawn_run(1, speed=steady(1000), orders={3.0: 0.5}), [])])
    chosen = most_promising([*numbers, low_pass, drag], data)
    assert [id(each) for each in chosen] == [id(each) for each in (*numbers[:2], low_pass, drag, numbers[2])]


def test_additions_compete_for_a_line_in_whichever_domain_they_have_it():
    places = [order(3.0), order(5.0), frequency(50.0)]
    seen = run_features(drawn_run(1, speed=steady(1000), orders={3.0: 0.5, 5.0: 0.3}), places)
    assert [column_of(seen, place) for place in places] == [0, 1, 0]
    data, hum = Data.of([seen]), Addition(mechanism="mains_interference", places=(frequency(50.0),))
    assert competes(Addition(kind="line_family", places=(order(3.0), order(5.0))), hum, data)
    assert not competes(Addition(kind="line_family", places=(order(5.0),)), hum, data)
    assert competes(Addition(mechanism="quadratic_drag"), hum, data)  # a level has no place


@pytest.mark.parametrize(
    ("odds", "held_out", "named", "nameless"),
    [(8.5, 3.5, True, True), (4.0, 8.0, True, True), (4.0, 5.0, False, True), (2.0, 30.0, False, True),
     (30.0, 2.0, False, True)],
)  # fmt: skip
def test_a_name_needs_eleven_nats_of_all_data(odds, held_out, named, nameless):
    hum = Addition(mechanism="mains_interference", parts=(object(),))
    tone = Addition(kind="tone", parts=(object(),))
    number = Addition(kind="parameter")
    assert wins(number, odds=odds, held_out=held_out) == (odds > 3 and held_out > 3)
    assert (wins(hum, odds=odds, held_out=held_out), wins(tone, odds=odds, held_out=held_out)) == (named, nameless)


def test_what_wins_a_round_has_been_compared_with_what_it_may_be_instead():
    places = [order(3.0), order(5.0), frequency(50.0)]
    data = Data.of([run_features(drawn_run(1, speed=steady(1000), orders={3.0: 0.5, 5.0: 0.3}), places)])
    first = Addition(kind="tone", places=(frequency(50.0),))
    others = [Addition(mechanism=name, places=(order(5.0),)) for name in ("cogging", "imbalance", "gear_mesh")]
    same = [Addition(mechanism="blade_pass", places=(order(3.0),)), Addition(kind="line_family", places=(order(3.0),))]
    drag = Addition(mechanism="quadratic_drag")
    chosen = most_promising([first, drag, *others, *same], data)
    assert chosen == [first, *same, drag, others[0]]
    assert len(chosen) == FITTED
    assert most_promising([], data) == []


def test_names_of_the_same_line_are_fitted_before_nameless_effects_and_with_a_poor_start():
    """Of a depth and its second harmonic the start can be poor: what a mechanism promises there is no verdict."""
    place = (order(3.0),)
    first, *torques = (Addition(kind="line_family", places=place, parts=(SimpleNamespace(at=f"shaft {at}"),), label=at,
                                variant=at) for at in "abcd")  # fmt: skip
    ripple = Addition(mechanism="commutation_ripple", places=place, parts=(SimpleNamespace(at="motor"),))
    seen = run_features(drawn_run(1, speed=steady(1000), orders={3.0: 0.5}), [order(3.0)])
    data = Data.of([seen])
    assert ripple in most_promising([first, *torques, ripple], data)[:2]
    assert is_instead(ripple, [(first, ())], data)
    assert not is_instead(torques[0], [(first, ())], data)
    assert not is_instead(ripple, [], data)
