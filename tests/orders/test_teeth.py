"""Tooth counts against handbook 4.2 and report audit C."""

import re

import pytest

from torquerig.errors import InputError
from torquerig.orders.kinematics.teeth import Planetary, Spur


def test_only_sun_21_and_ring_84_give_mesh_order_16_8_at_ratio_5():
    # report audit C: zs zr / (zs + zr) = 16.8 with N = 5 has one solution
    stage = Planetary(21, 84, planets=3)
    assert stage.ratio == 5.0
    assert stage.mesh_order_in == pytest.approx(16.8, rel=1e-15)
    assert stage.mesh_order_out == 84.0


@pytest.mark.parametrize(
    ("sun", "ring", "planets"),
    [
        (12, 48, 3),
        (12, 48, 4),
        (15, 60, 3),
        (16, 64, 4),
        (18, 72, 3),
        (20, 80, 4),
        (21, 84, 3),
        (24, 96, 4),
        (30, 120, 3),
    ],
)
def test_the_admissible_five_to_one_sets_of_the_audit_assemble(sun, ring, planets):
    # report audit C, list of admissible 5:1 sets
    assert Planetary(sun, ring, planets).ratio == 5.0


@pytest.mark.parametrize(("sun", "ring", "planets"), [(21, 85, 3), (16, 64, 3), (21, 84, 4)])
def test_planets_that_cannot_be_put_in_are_refused_with_the_nearest_sets_that_can(sun, ring, planets):
    with pytest.raises(InputError, match="must be whole; the nearest sun/ring that can be assembled") as refused:
        Planetary(sun, ring, planets)
    named = [tuple(map(int, found)) for found in re.findall(r"(\d+)/(\d+) \(", str(refused.value))]
    assert len(named) == 3
    for near_sun, near_ring in named:
        ratio = Planetary(near_sun, near_ring, planets).ratio  # each of them assembles
        assert ratio == pytest.approx(1 + ring / sun, rel=0.02)
        assert abs(near_sun - sun) + abs(near_ring - ring) <= 5


def test_planets_that_would_touch_are_refused():
    # sun 12, ring 108: planets of 48 teeth; four of them would overlap, for (12 + 48) sin 45 = 42.4 < 50
    with pytest.raises(InputError, match="collide"):
        Planetary(12, 108, planets=4)


def test_a_ring_smaller_than_the_sun_does_not_exist():
    with pytest.raises(InputError, match="more teeth than the sun"):
        Planetary(30, 20)


def test_a_pair_meshes_once_per_tooth_of_either_wheel():
    pair = Spur(20, 50)
    assert (pair.ratio, pair.mesh_order_in, pair.mesh_order_out) == (2.5, 20.0, 50.0)


def test_a_pinion_without_teeth_does_not_exist():
    with pytest.raises(InputError, match="at least one"):
        Spur(0, 50)
