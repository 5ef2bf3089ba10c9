"""Condensation: what it keeps exactly, what it says, and that a shaft line of 22 inertias is the same in the band."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import BladePass
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Motor, Probe, SpeedController, TorqueSensor
from torquerig.rig.terms import Friction, Inertia, Spring, Term
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.condensation import lowered_for
from torquerig.simulation.condensation.beforehand import said_beforehand
from torquerig.simulation.condensation.lowered_for import TOLERANCE, lower_for
from torquerig.simulation.condensation.partial_systems import (
    ShaftLine,
    small_masses,
    stiff_springs,
    without_mass,
    without_spring,
)
from torquerig.simulation.condensation.reduction import reduced
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower, lower_terms
from torquerig.simulation.simulator import choice_for, simulate
from torquerig.simulation.twin.linear_twin import twin_of

SHAFT_LINE = Path(__file__).with_name("shaft_line.yaml")
RATE = 1000.0


def shaft_line() -> Rig:
    return read_scenario(read_document(SHAFT_LINE), catalog_for(SHAFT_LINE, ()), seed=1).rig


def line(*terms: Term, nodes: tuple[str, ...] = (), springs: tuple[str, ...] = ()) -> ShaftLine:
    return ShaftLine(terms, frozenset(nodes), frozenset(springs), {}, {})


def chain(*, ratios: tuple[float, float] = (1.0, 1.0), turned: bool = False) -> ShaftLine:
    """Return a - m - b with springs of 300 and 700 N m/rad, a and b read."""
    first = Spring(name="first", a="a", b="m", stiffness=300.0, damping=0.3, ratio=ratios[0])
    second = Spring(name="second", a="m", b="b", stiffness=700.0, damping=0.2, ratio=ratios[1])
    if turned:
        scale = ratios[1] ** 2
        second = Spring(name="second", a="b", b="m", stiffness=700.0 / scale, damping=0.2 / scale, ratio=1 / ratios[1])
    ends = Inertia(node="a", inertia=0.1), Inertia(node="b", inertia=0.2)
    drag = Friction(name="drag", on="m", viscous=0.01)
    return line(first, second, *ends, Inertia(node="m", inertia=1e-6), drag, nodes=("a", "b"))


def static_stiffness(made: ShaftLine) -> np.ndarray:
    """Return the stiffness between the nodes a and b with all others free."""
    system = matrices(lower_terms(made.terms, 0))
    kept = [system.nodes.index(name) for name in ("a", "b")]
    rest = [row for row in range(len(system.nodes)) if row not in kept]
    K = system.stiffness
    if not rest:
        return K[np.ix_(kept, kept)]
    gone = np.linalg.solve(K[np.ix_(rest, rest)], K[np.ix_(rest, kept)])
    return K[np.ix_(kept, kept)] - K[np.ix_(kept, rest)] @ gone


@pytest.mark.parametrize("ratios", [(1.0, 1.0), (5.0, 1.0), (1.0, -3.0), (2.0, 0.5)])
@pytest.mark.parametrize("turned", [False, True])
def test_a_small_mass_leaves_static_stiffness_inertia_and_drag_as_they_were(
    ratios: tuple[float, float], turned: bool
) -> None:
    before = chain(ratios=ratios, turned=turned)
    (step,) = small_masses(before)
    after = without_mass(before, step)
    assert "m" not in {node for term in after.terms for node in term.nodes}
    assert static_stiffness(after) == pytest.approx(static_stiffness(before), rel=1e-12)
    turns = {"a": ratios[0] * ratios[1], "m": ratios[1], "b": 1.0}
    for of in ("inertia", "viscous"):
        totals = [
            sum(getattr(term, of) * turns[term.nodes[0]] ** 2 for term in one.terms if hasattr(term, of))
            for one in (before, after)
        ]
        assert totals[1] == pytest.approx(totals[0], rel=1e-12)


def test_the_spring_that_is_read_keeps_name_and_direction() -> None:
    for read in ("first", "second"):
        before = replace(chain(), read_springs=frozenset({read}))
        (step,) = small_masses(before)
        (spring,) = without_mass(before, step).springs()
        assert (spring.name, spring.a, spring.b) == (read, "a", "b")
    both = replace(chain(), read_springs=frozenset({"first", "second"}))
    after = without_mass(both, next(small_masses(both)))
    assert after.series == {"second": "first"} or after.series == {"first": "second"}


def test_a_geared_spring_that_is_read_is_not_put_in_series() -> None:
    assert not list(small_masses(replace(chain(ratios=(5.0, 1.0)), read_springs=frozenset({"first"}))))


def test_a_stiff_spring_leaves_its_flexibility_to_those_beside_it() -> None:
    """Rivin's shares keep the first mode to 1e-6; the spring left out alone, 0.5 % of its neighbours', costs 5e-4."""
    ends = (("a", 1.0), ("m", 0.1), ("n", 0.15), ("b", 2.0))
    left = Spring(name="left", a="a", b="m", stiffness=500.0, damping=0.0)
    stiff = Spring(name="stiff", a="m", b="n", stiffness=1e5, damping=0.0)
    right = Spring(name="right", a="n", b="b", stiffness=700.0, damping=0.0)
    before = line(*(Inertia(node=node, inertia=inertia) for node, inertia in ends), left, stiff, right)
    after = without_spring(before, next(step for step in stiff_springs(before) if step.spring == "stiff"))
    exact, near = (matrices(lower_terms(one.terms, 0)).undamped_frequencies()[1] for one in (before, after))
    assert near == pytest.approx(exact, rel=1e-6)
    alone = replace(after, terms=tuple(
        replace(term, stiffness={"left": 500.0, "right": 700.0}[term.name]) if isinstance(term, Spring) else term
        for term in after.terms
    ))  # fmt: skip
    assert matrices(lower_terms(alone.terms, 0)).undamped_frequencies()[1] > exact * 1.0005


def test_what_acts_on_a_joined_node_acts_on_the_other() -> None:
    before = line(
        Inertia(node="a", inertia=1.0), Inertia(node="b", inertia=2.0),
        Spring(name="stiff", a="a", b="b", stiffness=1e9, damping=0.0),
        Friction(name="dry", on="a", coulomb_forward=1.0), Friction(name="other", on="b", coulomb_forward=1.0),
    )  # fmt: skip
    after = reduced(before, 1e3)
    ((gone, stays),) = after.joined.items()
    assert {term.on for term in after.terms if isinstance(term, Friction)} == {stays}
    assert lower_terms(after.terms, 0).nodes == (stays,)
    assert gone != stays


def driven(*more: Part, hub_inertia: float = 2e-6) -> Rig:
    motor = Motor(name="motor", inertia=2e-4, torque_limit=5.0)
    hub = Coupling(name="hub", after="motor", stiffness=2e5, damping=1.0, inertia=hub_inertia)
    sensor = TorqueSensor(name="sensor", after="hub", stiffness=4e4, damping=1.0, inertia=5e-5, bandwidth=200.0)
    bar = Coupling(name="bar", after="sensor", stiffness=300.0, damping=0.02, inertia=3e-6)
    wheel = Body(name="wheel", after="bar", inertia=4e-3, viscous=1e-3)
    loop = SpeedController(name="loop", kp=0.02, ki=0.1)
    blades = BladePass(name="blades", at="wheel", order_output=3, amplitude=1.0)
    return Rig((motor, hub, sensor, bar, wheel, loop, blades, *more), Run(speed=40.0), measured="sensor")


def test_the_shipped_rig_is_not_condensed_at_its_rate() -> None:
    path = shipped_scenarios() / "wear_rig.yaml"
    rig = read_scenario(read_document(path), catalog_for(path, ()), seed=1).rig
    assert lower_for(rig, 1, rate=25_000.0).condensation is None
    assert said_beforehand(rig, rate=25_000.0) == ""


def test_what_is_read_and_what_acts_keeps_its_place() -> None:
    made = lower_for(driven(Probe(name="twist", quantity="torque", at="hub"), hub_inertia=1e-7), 0, rate=RATE)
    assert made.condensation is not None
    assert made.nodes == ("motor", "sensor", "bar")
    assert made.spring("sensor") == made.spring("hub")


def test_a_reading_that_would_be_wrong_keeps_its_mass() -> None:
    """The torque in front of a hub of 2e-6 kg m^2 is 4 % more than behind it at 500 Hz; so the hub stays."""
    assert lower_for(driven(Probe(name="twist", quantity="torque", at="hub")), 0, rate=RATE).condensation is None


def test_the_statement_is_what_it_says() -> None:
    """The natural frequencies of the condensed line against those of the whole one, as the sentence states them."""
    rig = shaft_line()
    made = lower_for(rig, 1, rate=RATE)
    assert made.condensation is not None
    before, after = (matrices(one).undamped_frequencies() for one in (lower(rig, 1), made))
    band = before[(before > 0) & (before < RATE / 2)]
    shift = np.abs(after[1 : 1 + band.size] / band - 1).max()
    assert made.condensation.accuracy.shift == pytest.approx(shift, rel=1e-6)
    assert f"at most {100 * shift:.2g} %" in made.condensation.sentence()
    assert made.condensation.accuracy.response <= TOLERANCE
    assert f"22 inertias to {len(made.nodes)}" in said_beforehand(rig, rate=RATE)
    assert choice_for(rig, duration=1.0, seed=1, sample_rate=RATE).steps < 50


@pytest.mark.parametrize("name", ["true_sensor_torque_Nm", "true_motor_speed_rad_s", "true_output_speed_rad_s"])
def test_a_condensed_run_is_the_whole_run_within_its_tolerance(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    rig, settings = driven(), {"duration": 1.0, "seed": 0, "settling": 0.5, "sample_rate": RATE}
    condensed = simulate(rig, **settings)
    assert "condensed: 4 inertias to 3" in condensed.origin["condensed"]
    monkeypatch.setattr(lowered_for, "FAR", np.inf)
    whole = simulate(rig, **settings)
    assert "condensed" not in whole.origin
    one, other = (made.channels[name].values for made in (condensed, whole))
    assert np.std(one - other) <= 2 * TOLERANCE * np.std(other)
    assert np.mean(one) == pytest.approx(np.mean(other), rel=1e-4)


@pytest.mark.long
def test_the_shaft_line_of_22_inertias_is_the_same_condensed(monkeypatch: pytest.MonkeyPatch) -> None:
    """The whole line needs some 3000 steps a sample at 1 kHz."""
    rig, settings = shaft_line(), {"duration": 0.5, "seed": 0, "settling": 0.5, "sample_rate": RATE}
    condensed = simulate(rig, **settings).channels["true_sensor_torque_Nm"].values
    monkeypatch.setattr(lowered_for, "FAR", np.inf)
    assert choice_for(rig, duration=0.5, seed=0, sample_rate=RATE).steps > 1000
    whole = simulate(rig, **settings).channels["true_sensor_torque_Nm"].values
    assert np.std(condensed - whole) <= TOLERANCE * np.std(whole)


def test_modes_are_those_of_the_whole_line() -> None:
    """All 21 elastic modes and one rigid motion; those that only decay have no damped frequency."""
    modes = twin_of(shaft_line(), rate=RATE).modes()
    assert len(modes) == 21
    exact = matrices(lower(shaft_line(), 1)).undamped_frequencies()[1:]
    assert [one.undamped for one in modes] == pytest.approx(exact, rel=1e-9)
    assert all(one.is_overdamped == (one.damped == 0.0) for one in modes)
    assert modes[-1].is_overdamped
    assert modes[0].time_constant == pytest.approx(1 / (2 * pi * modes[0].magnitude * modes[0].damping))


def test_a_rig_that_can_not_be_condensed_says_how_many_steps_it_takes() -> None:
    """A sensor between a motor and a wheel alone: its spring is read, and nothing beside it is free."""
    motor = Motor(name="motor", inertia=2e-6, torque_limit=5.0)
    sensor = TorqueSensor(name="sensor", after="motor", stiffness=4e4, damping=0.01, inertia=5e-6, bandwidth=200.0)
    rig = Rig((motor, sensor, SpeedController(name="loop", kp=1e-5, ki=0.0)), Run(speed=10.0), measured="sensor")
    assert "cannot be condensed within 0.5 %" in said_beforehand(rig, rate=RATE)
    steps = choice_for(rig, duration=0.1, seed=0, sample_rate=RATE).steps
    assert f"some {steps} integration steps a sample" in said_beforehand(rig, rate=RATE)
