"""Draws stay in their bounds, do not depend on each other, and say what they assumed."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.catalog.entry import estimates
from torquerig.catalog.lines import ripple_lines
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.sampling import nominal, sample_entry, sample_teeth
from torquerig.catalog.shipped import shipped_folder
from torquerig.errors import InputError
from torquerig.machines.winding import has_winding, winding_pairs
from torquerig.parameter import Estimate

CATALOG = load_catalog(shipped_folder())
SEEDS = st.integers(0, 2**31)
SERVOS = [name for name, motor in CATALOG.motors.items() if motor.kind != "induction"]


@settings(max_examples=40, deadline=None)
@given(name=st.sampled_from([*CATALOG.motors]), seed=SEEDS)
def test_every_drawn_value_lies_in_its_interval(name, seed):
    motor = CATALOG.motor(name)
    values = sample_entry(motor, seed).values
    for field, estimate in estimates(motor):
        if estimate.low is not None:
            assert estimate.low <= values[field] <= estimate.high
        elif estimate.choices:
            assert values[field] in estimate.choices


@settings(max_examples=40, deadline=None)
@given(name=st.sampled_from(SERVOS), seed=SEEDS)
def test_drawn_pole_pairs_and_slots_have_a_winding(name, seed):
    motor = sample_entry(CATALOG.motor(name), seed)
    assert has_winding(motor.count("pole_pairs"), motor.count("slots"))


@settings(max_examples=40, deadline=None)
@given(seed=SEEDS)
def test_pairs_without_a_winding_are_never_drawn(seed):
    motor = CATALOG.motor("HDS6A-0104A")
    choices = {"pole_pairs": Estimate(choices=(3.0, 4.0)), "slots": Estimate(choices=(12.0, 9.0))}
    pair = sample_entry(motor.model_copy(update=choices), seed)
    assert (pair.count("pole_pairs"), pair.count("slots")) in [(3, 9), (4, 12), (4, 9)]


def test_a_winding_exists_where_the_star_of_slots_says_so():
    # 12 slots and 14 magnets exist, 14 slots and 12 magnets do not; 9/8, 12/10 are common, 12/6 is not balanced
    assert winding_pairs([7], [12, 14]) == [(7, 12)]
    assert has_winding(4, 9)
    assert has_winding(5, 12)
    assert not has_winding(3, 12)


def test_the_same_seed_draws_the_same_and_another_seed_does_not():
    motor = CATALOG.motor("HDS6A-0104A")
    assert sample_entry(motor, 3) == sample_entry(motor, 3)
    assert sample_entry(motor, 3).value("rotor_inertia") != sample_entry(motor, 4).value("rotor_inertia")


def test_a_draw_does_not_depend_on_what_else_the_file_states():
    motor = CATALOG.motor("HDS6A-0104A")
    fewer = motor.model_copy(update={"mass": Estimate(), "rated_current": Estimate()})
    more, less = sample_entry(motor, 3).values, sample_entry(fewer, 3).values
    assert set(more) - set(less) == {"mass", "rated_current"}
    assert all(more[field] == less[field] for field in less)


def test_an_alias_draws_the_numbers_of_the_motor_that_it_stands_for():
    assert sample_entry(CATALOG.motor("HDS5C-102A"), 5).values == sample_entry(CATALOG.motor("HDS6A-0102A"), 5).values


def test_what_is_documented_is_not_assumed_and_everything_else_is():
    chosen = nominal(CATALOG.motor("HDS6A-0104A"))
    documented = {"rated_torque", "stall_torque", "peak_torque", "rated_speed", "max_speed", "supply_voltage"}
    assert set(chosen.values) - set(chosen.assumed) == documented
    assert chosen.assumed["pole_pairs"].known == "? (4 or 5)"
    assert chosen.assumed["rotor_inertia"].value == pytest.approx(0.48e-4)


def test_a_spread_is_assumed_only_where_it_was_drawn():
    motor = CATALOG.motor("bldc-12n14p")
    assert "rotor_inertia" not in nominal(motor).assumed
    assert sample_entry(motor, 1).assumed["rotor_inertia"].known == "0.00015 kg*m^2 ± 8%"


def test_an_unknown_value_is_named_with_the_remedy():
    with pytest.raises(InputError, match="GP-71M: torque_constant is unknown; state low and high"):
        nominal(CATALOG.motor("GP-71M")).value("torque_constant")


def test_teeth_are_drawn_among_the_possible_sets():
    box = CATALOG.gearbox("economy-5-1")
    rings = {sample_teeth(box, seed).mesh_order_out for seed in range(60)}
    assert rings <= {stage.mesh_order_out for stage in box.tooth_sets()}
    assert len(rings) > 3
    assert sample_teeth(CATALOG.gearbox("reference-5-1"), 0) is None


def test_the_rig_motor_has_the_published_lines_and_a_servo_those_of_its_class():
    rig = {(line.family, line.order): line.torque for line in ripple_lines(nominal(CATALOG.motor("bldc-12n14p")))}
    assert len(rig) == 12
    assert rig["cogging_per_pole", 6] == pytest.approx(0.020)
    # pole pairs 4, slots 9: handbook 1.1 gives cogging at LCM(9, 8) = 72, 1.4 six pulses at 24
    servo = {(line.family, line.order) for line in ripple_lines(nominal(CATALOG.motor("HDS6A-0104A")))}
    assert {("cogging", 72), ("six_pulse", 24), ("cogging_tolerance_slots", 9), ("cogging_tolerance_poles", 8)} <= servo


def test_an_induction_motor_does_not_cog():
    families = {line.family for line in ripple_lines(sample_entry(CATALOG.motor("GP-71M"), 2))}
    assert families == {"motor", "electrical"}


def test_two_values_and_two_motors_are_drawn_independently():
    # equal quantiles would mean a shared generator: the chance of two uniform draws within 1e-9 is 2e-9
    def quantile(motor, field):
        known = getattr(motor, field)
        return (sample_entry(motor, 7).value(field) - known.low) / (known.high - known.low)

    one, other = CATALOG.motor("HDS60-0104A"), CATALOG.motor("ESM06X-401-302")
    assert abs(quantile(one, "rated_current") - quantile(one, "torque_constant")) > 1e-9
    assert abs(quantile(one, "rated_current") - quantile(other, "rated_current")) > 1e-9


def test_a_changed_copy_of_an_entry_lists_its_new_values():
    motor = CATALOG.motor("HDS6A-0104A")
    before = dict(estimates(motor))
    copy = motor.model_copy(update={"mass": Estimate(7.0, evidence="DOC", source="test", unit="kg")})
    assert dict(estimates(copy))["mass"].value == 7.0
    assert dict(estimates(motor)) == before
