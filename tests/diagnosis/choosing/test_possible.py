"""A number that fits tell loosely is impossible only where chance does not put it there."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.choosing.possible import can_be, price_of_odd_numbers
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.inference.knobs import Knob
from torquerig.mechanisms import BearingDefect, CommutationRipple, StribeckFriction, TorsionalMode
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario


def fitted(wear_rig: Scenario, part: Part, knob: Knob, *, spread: float) -> Calibrated:
    own = Knob("wear_part", "inertia", 0.1)
    covariance = np.diag([1.0, spread**2])
    return Calibrated(wear_rig.rig + part, (own, knob), np.zeros(2), covariance, (), 0.0)


@pytest.mark.parametrize(("depth", "spread", "possible"), [(1.35, 0.19, True), (1.35, 0.1, False), (0.6, 0.01, True)])
def test_a_depth_is_judged_by_the_low_end_of_its_interval(
    depth: float, spread: float, possible: bool, wear_rig: Scenario
) -> None:
    """No drive turns its torque round: 1.35 exp(-1.96 0.19) is 0.93 of it, 1.35 exp(-1.96 0.1) is 1.11."""
    part, knob = CommutationRipple(name="ripple", order_motor=84.0, depth=depth), Knob("ripple", "depth", 1.0)
    candidate = Candidate(mechanism="commutation_ripple", parts=(part,), knobs=(knob,))
    assert can_be(candidate, fitted(wear_rig, part, knob, spread=spread)) is possible


@pytest.mark.parametrize(
    ("damping", "spread", "possible"),
    [(0.0005, 0.78, True), (0.0005, 0.1, False), (0.004, 0.1, True), (0.15, 0.78, True), (0.4, 0.78, False)],
)
def test_a_damping_that_nothing_tells_is_not_too_small(
    damping: float, spread: float, possible: bool, wear_rig: Scenario
) -> None:
    """Bands are wider than a line of little damping; what rings too little is still a damper and no mode."""
    part = TorsionalMode(name="mode", after="wear_part", frequency=90.0, inertia=1e-3, damping_ratio=damping)
    knob = Knob("mode", "damping_ratio", 1.0)
    candidate = Candidate(mechanism="torsional_mode", parts=(part,), knobs=(knob,))
    assert can_be(candidate, fitted(wear_rig, part, knob, spread=spread)) is possible


def test_other_numbers_are_judged_as_they_are(wear_rig: Scenario) -> None:
    part = TorsionalMode(name="mode", after="wear_part", frequency=90.0, inertia=1e-3, damping_ratio=0.4)
    knob = Knob("mode", "damping_ratio", 1.0)
    candidate = Candidate(mechanism="torsional_mode", parts=(part,), knobs=(knob,))
    assert not can_be(candidate, fitted(wear_rig, part, knob, spread=3.0))


@pytest.mark.parametrize(("depth", "odd"), [(1.35, True), (0.9, False), (0.4, False)])
def test_a_ripple_deeper_than_drives_make_gives_way_to_another_name(
    depth: float, odd: bool, wear_rig: Scenario
) -> None:
    """Six steps leave half of the torque; 0.9 exp(-1.96 0.19) is 0.62 of it, which a fit may have made of half."""
    part, knob = CommutationRipple(name="ripple", order_motor=84.0, depth=depth), Knob("ripple", "depth", 1.0)
    candidate = Candidate(mechanism="commutation_ripple", parts=(part,), knobs=(knob,))
    assert bool(price_of_odd_numbers(candidate, fitted(wear_rig, part, knob, spread=0.19))) is odd


@pytest.mark.parametrize(("ring", "possible"), [(1500.0, True), (20_000.0, False)])
def test_a_band_that_goes_on_to_half_the_sample_rate_is_no_mode(
    ring: float, possible: bool, wear_rig: Scenario
) -> None:
    part = BearingDefect(
        name="bearing", at="wear_part", order_output=3.08, ring_frequency=ring, damping=0.05, amplitude=0.1
    )
    knob = Knob("bearing", "ring_frequency", 0.2)
    candidate = Candidate(
        mechanism="bearing_defect", parts=(part,), knobs=(knob,), below={"ring_frequency": 0.45 * 25_000.0}
    )
    assert can_be(candidate, fitted(wear_rig, part, knob, spread=0.1)) is possible


@pytest.mark.parametrize(("backward", "possible"), [(2.0, True), (0.2, True), (12.0, False), (0.05, False)])
def test_directions_of_one_friction_are_alike(backward: float, possible: bool, wear_rig: Scenario) -> None:
    """A fit beside a drift came to 0.19 N m one way and 58 504 the other, which no step of time could follow."""
    part = StribeckFriction(
        name="dry", at="wear_part", coulomb=0.6, static=0.7, stribeck_speed=1.0, coulomb_backward=backward,
        static_backward=1.1 * backward,
    )  # fmt: skip
    knob = Knob("dry", "coulomb_backward", 0.8)
    candidate = Candidate(mechanism="stribeck_friction", parts=(part,), knobs=(knob,), variant="by_direction")
    assert can_be(candidate, fitted(wear_rig, part, knob, spread=0.1)) is possible
