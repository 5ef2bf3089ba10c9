"""``ripple: from_phase_level`` of a motor of the catalog: what it brings, where it comes from, what it refuses."""

from dataclasses import replace
from math import pi, sqrt
from pathlib import Path

import pytest

from torquerig.catalog.phases import sample_phases
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.mechanisms import CommutationRipple, FieldOrientedControl, SixStepCommutation
from torquerig.rig.host_changes import DriveRipple, waves_of
from torquerig.rig.parts import MotorPhases
from torquerig.rig.steady import steady_torque
from torquerig.scenario.catalog_values.from_catalog import sample_of
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario

CATALOG = load_catalog(shipped_folder())
SERVOS = sorted(name for name, motor in CATALOG.motors.items() if motor.kind == "pmsm")


def scenario(motor, *settings, seed=1):
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    asked = overridden(document, ["motor.ripple=from_phase_level", f"motor.catalog={motor}", *settings])
    return read_scenario(asked, CATALOG, seed=seed)


def depths(made):
    """The commutation's lines relative to the torque, by order over the pole pairs."""
    pairs = made.rig.part("motor.phases").pole_pairs
    waves = waves_of(made.rig.part("motor.commutation").changes_in_host(made.rig), DriveRipple)
    return {wave.order / pairs: wave.amplitude for wave in waves}


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_brushless_motor_ripples_at_6p_as_its_class_does_and_servos_hardly(seed):
    """5 to 25 % at 6p is what six-step motors have (Carlson et al. 1992), none of it stated in the scenario."""
    brushless = depths(scenario("bldc-12n14p", seed=seed))
    assert 0.05 < brushless[6.0] < 0.25
    assert {order % 6 for order, depth in brushless.items() if depth > 1e-3} == {0.0}
    for name in SERVOS[:3]:
        servo = depths(scenario(name, seed=seed)).get(6.0, 0.0)
        assert servo < min(0.03, 0.5 * brushless[6.0])  # 3 % of fifth harmonic is the most that the class is given


def test_a_servo_has_what_its_back_emf_has_and_no_more():
    """With a sinusoidal back-EMF and no dead time nothing is left: the class's six-pulse line does not go in."""
    made = scenario("HDS6A-0104A")
    phases = made.rig.part("motor.phases")
    assert isinstance(phases, MotorPhases)
    bare = made.rig.changed(replace(phases, emf_harmonics={})).changed(FieldOrientedControl(name="motor.commutation"))
    assert waves_of(made.rig.part("motor.commutation").changes_in_host(made.rig), DriveRipple)
    assert waves_of(bare.part("motor.commutation").changes_in_host(bare), DriveRipple) == ()


@pytest.mark.parametrize(
    ("motor", "kind"), [("bldc-12n14p", SixStepCommutation), ("ESM06X-401-302", FieldOrientedControl)]
)
def test_source_and_assumptions_are_named(motor, kind):
    made = scenario(motor)
    assert isinstance(made.rig.part("motor.commutation"), kind)
    assert "phase-level model" in made.assumed["motor.commutation.lines"]
    for field in ("phase_resistance", "phase_inductance", "flux_linkage", "dc_link"):
        assert made.assumed[f"motor.phases.{field}"]
    assert "no supply is stated" in made.assumed["motor.phases.dc_link"]


def test_a_line_of_the_class_at_6p_gives_way_and_the_others_stay():
    plain = read_scenario(
        overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), ["motor.catalog=HDS6A-0104A"]), CATALOG, seed=1
    )
    asked = scenario("HDS6A-0104A")
    pairs = asked.rig.part("motor").pole_pairs
    orders = [{part.order_motor for part in one.rig.parts_of(CommutationRipple)} for one in (plain, asked)]
    assert orders[0] - orders[1] == {6.0 * pairs}
    assert orders[1] == {2.0 * pairs}
    assert "ripple.six_pulse_ripple" in str(plain.assumed)
    assert "six_pulse_ripple" not in str(asked.assumed)


def test_from_catalog_is_what_stands_without_the_key():
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    plain = read_scenario(document, CATALOG, seed=1)
    assert read_scenario(overridden(document, ["motor.ripple=from_catalog"]), CATALOG, seed=1).rig == plain.rig


@pytest.mark.parametrize("motor", ["bldc-12n14p", "ESM06X-401-302", "ESM013B-152-304"])
@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_resistance_inductance_and_torque_constant_are_of_one_number_of_turns(motor, seed):
    """The same rank in every interval, and a DC link that reaches the largest speed."""
    entry = CATALOG.motor(motor)
    sample = sample_of(entry, seed)
    phases = sample_phases(sample, seed)
    assert phases == sample_phases(sample, seed)
    pairs, flux = sample.count("pole_pairs"), phases.values["flux_linkage"]
    constant = flux * (2 * pairs if entry.kind == "bldc" else 1.5 * sqrt(2) * pairs)
    assert entry.torque_constant.low <= constant <= entry.torque_constant.high
    for field in ("phase_resistance", "phase_inductance"):
        assert getattr(entry, field).low <= phases.values[field] <= getattr(entry, field).high
    line_emf = flux * pairs * sample.value("max_speed") * (2 if entry.kind == "bldc" else sqrt(3))
    assert line_emf < phases.values["dc_link"] < 2 * line_emf


def test_a_stated_supply_is_rectified():
    sample = sample_of(CATALOG.motor("HDS6A-0104A"), 1)
    assert sample_phases(sample, 1).values["dc_link"] == pytest.approx(sqrt(2) * 230)


def test_the_ripple_follows_the_operating_point():
    """Twice the torque and the same lines in newton-metres would halve the depth; commutation keeps neither."""
    light, heavy = (scenario("bldc-12n14p", f"load.occupancy={occupancy} %") for occupancy in (5, 21))
    assert steady_torque(heavy.rig, "motor") > 3 * steady_torque(light.rig, "motor")
    assert depths(light)[6.0] != depths(heavy)[6.0]


def test_steady_torque_is_the_load_through_gear_and_losses():
    """1.0 N m and 0.01 N m s/rad at 200 rpm over 5 x 0.96, plus the motor's own friction at 1000 rpm."""
    rig = scenario("bldc-12n14p").rig
    gear = rig.part("gearbox")
    turning = 200 * pi / 30
    expected = (1.0 + 0.010 * turning) / (gear.ratio * gear.efficiency) + 0.015 + 1.5e-4 * 5 * turning
    assert steady_torque(rig, "motor") == pytest.approx(expected, rel=1e-9)


def test_an_induction_motor_keeps_the_lines_of_its_class():
    made = scenario("GP-71M")
    assert "no commutation" in made.assumed["motor.ripple"]
    assert not made.rig.parts_of(MotorPhases)


RIG = """
rig:
  motor: {kind: motor, inertia: 1.5 kg*cm^2, torque_limit: 2 N*m, RIPPLE}
  torque_sensor: {kind: coupling, stiffness: 1000 N*m/rad, damping: 0.1 N*m*s/rad}
  wear_part: {kind: body, inertia: 2.0e-3 kg*m^2}
"""


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("ripple: from_phase_leve, catalog: bldc-12n14p", r"own\.yaml:3: .*did you mean 'from_phase_level'"),
        ("ripple: from_phase_level", r"own\.yaml:3: .*only a motor of the catalog"),
    ],
)
def test_what_cannot_be_is_refused_with_its_line(written, said):
    document = parse_document(RIG.replace("RIPPLE", written), Path("own.yaml"))
    with pytest.raises(InputError, match=said):
        read_scenario(document, CATALOG, seed=1)


def test_a_motor_file_that_states_no_resistance_is_refused():
    motor = CATALOG.motor("bldc-12n14p")
    unknown = motor.model_copy(update={"phase_resistance": type(motor.phase_resistance)()})
    with pytest.raises(InputError, match="phase_resistance is unknown"):
        sample_phases(sample_of(unknown, 1), 1)
