"""Variants from the catalog: the rating holds for each; documented values come first; intervals hold the nominal."""

from __future__ import annotations

from functools import cache
from math import inf

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.parameter import Estimate
from torquerig.thermal.duty_temperatures import temperatures_of_duty
from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import RATED_AMBIENT, copper_bounds, thermal_variants
from torquerig.thermal.warming import warming


@cache
def catalog():
    return load_catalog(shipped_folder())


def steady(torque: float, speed: float = 0.0) -> MotorDuty:
    return MotorDuty(duration=np.array([10.0]), torque_square=np.array([torque**2]), speed=np.array([speed]),
                     speed_square=np.array([speed**2]), peak_torque=torque)  # fmt: skip


def highest(variant, duty) -> float:
    made = warming(variant, duty, ambient=RATED_AMBIENT)
    return made.extremes(made.settled())[1]


def test_every_motor_of_the_catalog_has_copies_and_says_what_was_assumed():
    for name, entry in catalog().motors.items():
        made = thermal_variants(entry)
        assert "winding limit" in made.assumed, name
        assert "thermal classes B and F" in made.assumed["winding limit"]
        unknown = entry.thermal_resistance.unknown
        assert ("not in the catalog; trend" in made.assumed["thermal resistance"]) == unknown, name
        assert all(variant.copper_loss > 0 for variant in made.corners), name


def test_stall_torque_brings_each_copy_to_its_limit_or_less():
    """HDS6A-0104A, 1.4 N*m: at 40 C; less only where its largest resistance does not heat it so much."""
    entry = catalog().motor("HDS6A-0104A")
    most = copper_bounds(entry)[1]
    reached = [(variant, highest(variant, steady(1.4))) for variant in thermal_variants(entry).corners]
    assert all(found <= variant.limit + 1e-9 for variant, found in reached)
    at_limit = [found == pytest.approx(variant.limit) for variant, found in reached]
    assert any(at_limit)
    assert all(holds or variant.copper_loss == most for (variant, _), holds in zip(reached, at_limit, strict=True))


def test_rated_torque_at_rated_speed_is_as_hot_as_stall_torque():
    """Where the rating is not cut by the resistance: iron loss takes what copper loss is less (1.27 for 1.40 N*m)."""
    entry = catalog().motor("HDS6A-0104A")
    rated = steady(1.27, entry.rated_speed.nominal())
    free = [
        one for one in thermal_variants(entry).corners if one.copper_loss < copper_bounds(entry)[1] and one.iron > 0
    ]
    assert free
    for variant in free:
        assert highest(variant, rated) == pytest.approx(highest(variant, steady(1.4)))


def test_documented_copper_goes_before_the_rating():
    entry = catalog().motor("HDS6A-0104A").model_copy(update={
        "phase_resistance": Estimate(1.5, evidence="DOC", unit="ohm"),
        "torque_constant": Estimate(0.5, evidence="DOC", unit="N*m/Arms"),
    })  # fmt: skip
    made = thermal_variants(entry)
    assert [variant.copper_loss for variant in made.corners] == pytest.approx([3 * 1.5 / 0.25] * len(made.corners))
    assert made.nominal.phase_resistance == pytest.approx(1.5)
    assert made.nominal.current(1.0) == pytest.approx(2.0)
    assert "copper loss" not in made.assumed


@pytest.mark.parametrize("name", ["bldc-12n14p", "HDS6A-0104A", "GP-71M"])
def test_intervals_hold_the_nominal_copy_and_words_follow_the_margin(name):
    entry = catalog().motor(name)
    made = thermal_variants(entry)
    words = []
    for share in (0.3, 1.05, 2.5):
        torque = share * entry.rated_torque.nominal()
        found = temperatures_of_duty(steady(torque), made, ambient=RATED_AMBIENT)
        for span in (found.winding, found.housing, found.margin, found.use, found.until):
            assert span.low <= span.value <= span.high
        words.append(found.word)
        assert (found.until.high == inf) == (found.word != "too hot")
        assert found.rms_torque == pytest.approx(torque)
    assert words[0] == "safe"
    assert words[2] == "too hot"
