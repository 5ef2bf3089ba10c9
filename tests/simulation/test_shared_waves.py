"""Waves of one structure for rigs with other lines: each moves as it does with its own waves, whoever is with it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.mechanisms import BladePass, CommutationRipple, GearMesh, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear, Motor, SpeedController, TorqueSensor
from torquerig.simulation import kernel
from torquerig.simulation.batch_parts import BatchRun
from torquerig.simulation.inputs import Span
from torquerig.simulation.kernel.side_by_side import integrate_together
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.shared_waves import can_share_waves, with_shared_waves
from torquerig.simulation.term_kinds import Terms
from torquerig.simulation.waves import orders_of

SPAN = Span.of(duration=0.1, settling=0.02, rate=25_000.0, seed=3, wander=0.0)


def machine(*more: Part) -> Rig:
    parts = (
        Motor(name="motor", inertia=1e-3, torque_limit=2.0, current_loop_bandwidth=500.0),
        Gear(name="gear", after="motor", ratio=2.5, stiffness=900.0, damping=0.5, output_inertia=1e-3),
        TorqueSensor(name="sensor", after="gear", stiffness=1100, damping=0.05, inertia=1e-3, bandwidth=5000),
        Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02),
        SpeedController(name="controller", kp=0.05, ki=0.1),
    )
    return Rig((*parts, *more), Run(speed=50.0), measured="sensor")


def lines(*orders: float, at: str = "motor") -> TorqueRipple:
    return TorqueRipple(name=f"lines at {at}", at=at, group="cogging", amplitudes=dict.fromkeys(orders, 0.05))


RIGS = (
    machine(lines(6)),
    machine(lines(1, 2, 3, 4, 12, 60, 180), lines(2, 5, at="wheel")),
    machine(lines(7, 84, 3.572), GearMesh(name="mesh", gear="gear", order_output=17, transmission_error=(1e-3, 2e-4))),
    machine(CommutationRipple(name="steps", order_motor=24, depth=0.1, harmonics=(0.03,))),
    machine(),
)
ORDERS = ({6}, {1, 2, 3, 4, 5, 12, 60, 180}, {7, 84, 3.572, 17, 34}, {24, 48}, set())


def moved(run: Ready) -> NDArray[np.float64]:
    kept = np.empty((len(run.outputs), SPAN.samples))
    failed = kernel.integrate(*run.start(), run.terms, as_arrays(run.outputs), SPAN.rate, SPAN.settling, 2, kept)
    assert failed == (-1, -1)
    return kept


def moved_together(runs: list[Ready]) -> NDArray[np.float64]:
    starts, terms = [run.start() for run in runs], with_shared_waves([run.terms for run in runs])
    kept, finished, _ = integrate_together(
        [theta for theta, _ in starts], [omega for _, omega in starts], terms, as_arrays(runs[0].outputs),
        SPAN.rate, SPAN.settling, 2, SPAN.samples,
    )  # fmt: skip
    assert finished
    return kept


def amplitudes(terms: Terms) -> dict[float, float]:
    """Return the summed amplitudes of each order, of torques [N m], errors [rad] and ripple [1]."""
    found: dict[float, float] = {}
    places = orders_of(terms.waves)
    for slots, cosines, sines in (
        (terms.harmonics.slot, terms.harmonics.c, terms.harmonics.s),
        (terms.springs.e_slot, terms.springs.e_cos, terms.springs.e_sin),
        (terms.drives.r_slot, terms.drives.r_c, terms.drives.r_s),
    ):
        for slot, c, s in zip(slots, cosines, sines, strict=True):
            order = round(places[int(slot)][1], 9)
            found[order] = found.get(order, 0.0) + float(np.hypot(c, s))
    return {order: size for order, size in found.items() if size}


@pytest.mark.long
def test_each_moves_as_with_its_own_waves() -> None:
    """To 1e-9 of the largest value: the same cosines by other products, each exact to 1e-15, over 6000 steps."""
    runs = [ready(rig, SPAN) for rig in RIGS]
    for together, run in zip(moved_together(runs), runs, strict=True):
        alone = moved(run)
        assert (np.abs(together - alone).max(axis=1) <= 1e-9 * np.abs(alone).max(axis=1)).all()


@pytest.mark.long
def test_to_the_bit_it_does_not_matter_which_others_are_there() -> None:
    runs = [ready(rig, SPAN) for rig in RIGS]
    together = moved_together(runs)
    for row, run in enumerate(runs):
        np.testing.assert_array_equal(moved_together([run, run])[0], together[row])
    np.testing.assert_array_equal(moved_together(runs[::-1])[::-1], together)


def test_each_keeps_its_orders_and_their_sizes_in_one_structure() -> None:
    given = [ready(rig, SPAN).terms for rig in RIGS]
    shared = with_shared_waves(given)
    for before, after, orders in zip(given, shared, ORDERS, strict=True):
        for name in ("base_node", "ladder", "first", "second"):
            np.testing.assert_array_equal(getattr(after.waves, name), getattr(shared[0].waves, name))
        for one, other in ((after.harmonics, shared[0].harmonics), (after.drives, shared[0].drives)):
            for field in set(one._fields) & {"on", "against", "first", "slot", "r_first", "r_slot"}:
                np.testing.assert_array_equal(getattr(one, field), getattr(other, field))
        assert set(amplitudes(after)) == {float(order) for order in orders}
        assert amplitudes(after) == pytest.approx(amplitudes(before), rel=1e-12)


def test_the_slope_of_a_gear_s_error_has_its_orders() -> None:
    terms = with_shared_waves([ready(rig, SPAN).terms for rig in RIGS])[2]
    places = orders_of(terms.waves)
    for slot, order, c in zip(terms.springs.e_slot, terms.springs.e_order, terms.springs.e_cos, strict=True):
        if c:
            assert order == pytest.approx(places[int(slot)][1])


def test_rigs_with_blades_keep_their_waves() -> None:
    blades = BladePass(name="blades", at="wheel", order_output=4, amplitude=0.1)
    rig = machine(lines(6), blades)
    assert can_share_waves(ready(RIGS[0], SPAN).terms)
    assert not can_share_waves(ready(rig, SPAN).terms)
    run = BatchRun.of(rig, SPAN)
    assert run.likeness_but_for_waves == run.likeness


def test_rigs_that_differ_in_their_lines_alone_are_alike() -> None:
    few, many = BatchRun.of(RIGS[0], SPAN), BatchRun.of(RIGS[1], SPAN)
    assert few.likeness != many.likeness
    assert few.likeness_but_for_waves == many.likeness_but_for_waves
    loaded = BatchRun.of(machine(lines(6), BladePass(name="blades", at="wheel", order_output=4, amplitude=0.1)), SPAN)
    assert loaded.likeness_but_for_waves != few.likeness_but_for_waves
