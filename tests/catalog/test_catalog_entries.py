"""What the shipped entries say agrees with the reference rig, and no value is a number out of nowhere."""

from math import pi
from pathlib import Path

import pytest
import yaml

from torquerig.catalog.entry import estimates
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.ripple import RENAMED
from torquerig.catalog.shipped import shipped_folder
from torquerig.orders.kinematics.teeth import Planetary

RIG = Path(__file__).resolve().parents[2] / ".." / "shared" / "reference-rig.yaml"
CATALOG = load_catalog(shipped_folder())
ENTRIES = [
    entry
    for shelf in (CATALOG.motors, CATALOG.gearboxes, CATALOG.sensors, CATALOG.couplings)
    for entry in shelf.values()
]
VALUES = [(entry.name, field, estimate) for entry in ENTRIES for field, estimate in estimates(entry)]


def test_every_undocumented_value_has_an_interval_choices_or_a_spread():
    known = [(name, field, value) for name, field, value in VALUES if not value.unknown]
    assert len(known) > 500
    for name, field, value in known:
        bounded = value.low is not None or value.choices or value.rel_sd
        assert value.evidence in ("DOC", "REF") or bounded, (name, field)
        assert value.source, (name, field)


def test_every_source_key_is_explained():
    text = (shipped_folder().parent / "docs" / "sources.md").read_text(encoding="utf-8")
    keys = {
        key.strip()
        for _, _, value in VALUES
        for bracket in value.source.split("[")[1:]
        for key in bracket.split("]")[0].split(",")
    }
    assert len(keys) > 15
    assert {key for key in keys if f"| {key} |" not in text} == set()


@pytest.fixture(scope="module")
def rig():
    if not RIG.exists():
        pytest.skip("the reference rig's file lies beside the checkout, and there is none")
    return yaml.safe_load(RIG.read_text(encoding="utf-8"))


def close(estimate, written, factor=1.0):
    nominal = written if isinstance(written, dict) else {"value": written, "rel_sd": 0.0}
    assert estimate.evidence == "REF"
    assert estimate.value == pytest.approx(float(nominal["value"]) * factor, rel=1e-12)
    assert estimate.rel_sd == nominal["rel_sd"]


def test_the_motor_is_the_one_of_the_reference_rig(rig):
    motor, written = CATALOG.motor("bldc-12n14p"), rig["motor"]
    close(motor.rotor_inertia, written["rotor_inertia_kgm2"])
    close(motor.viscous_friction, written["viscous_Nms_per_rad"])
    close(motor.coulomb_friction, written["coulomb_Nm"])
    close(motor.peak_torque, written["torque_limit_Nm"])
    close(motor.current_loop_bandwidth, written["current_loop_bandwidth_Hz"])
    assert (motor.slots.value, motor.pole_pairs.value) == (written["slots"], written["magnets"] / 2)


def test_its_ripple_lines_are_those_of_the_reference_rig(rig):
    lines = CATALOG.motor("bldc-12n14p").ripple.known_lines
    for family, orders in rig["ripple_at_motor_Nm_by_motor_order"].items():
        known = getattr(lines, RENAMED.get(family, family))
        assert set(known) == set(orders)
        for order, torque in orders.items():
            close(known[order], {"value": torque, "rel_sd": 0.25})


def test_gearbox_sensor_and_coupling_are_those_of_the_reference_rig(rig):
    box, written = CATALOG.gearbox("reference-5-1"), rig["gearbox"]
    close(box.input_inertia, written["inertia_output_kgm2"], 1 / 25)
    close(box.stiffness, written["stiffness_output_Nm_per_rad"])
    close(box.damping, written["damping_output_Nms_per_rad"])
    close(box.efficiency, written["efficiency"])
    close(box.backlash, written["backlash_arcmin"])
    sensor, written = CATALOG.sensor("reference-10nm"), rig["torque_sensor"]
    close(sensor.stiffness, written["stiffness_Nm_per_rad"])
    close(sensor.damping, written["damping_Nms_per_rad"])
    close(sensor.inertia, written["inertia_output_side_kgm2"])
    close(sensor.noise, written["noise_rms_V"])
    close(sensor.bandwidth, written["bandwidth_Hz"])
    close(sensor.adc.range, written["adc"]["range_V"])
    close(sensor.adc.sample_rate, written["adc"]["sample_rate_Hz"])
    close(CATALOG.coupling("reference-coupling").stiffness, rig["coupling"]["stiffness_Nm_per_rad"])
    close(CATALOG.coupling("reference-coupling").damping, rig["coupling"]["damping_Nms_per_rad"])


def test_a_stiffness_per_arcmin_is_the_makers_per_radian():
    # Wittenstein NPT015: 3.3 N*m/arcmin is printed beside 11.3e3 N*m/rad
    assert CATALOG.gearbox("NPT015-5").stiffness.value == pytest.approx(3.3 * 60 * 180 / pi)
    assert CATALOG.gearbox("NPT015-5").stiffness.value == pytest.approx(11.3e3, rel=0.005)


def test_only_one_tooth_set_of_five_to_one_has_the_280_hertz_line():
    # report audit, section C: of all 5:1 sets only sun 21 / ring 84 meshes 84 times per output turn
    sets = CATALOG.gearbox("economy-5-1").tooth_sets()
    assert [stage for stage in sets if stage.mesh_order_out == 84] == [Planetary(21, 84, 3)]
    assert CATALOG.gearbox("ZLS160-5").tooth_sets() == (Planetary(21, 84, 3),)


def test_every_motor_is_consistent_with_its_power():
    # the power that the part number states, from rated torque and speed; 5 % is the width of the class intervals
    power = {"HDS6A-0104A": 400, "HDS60-0102A": 200, "ESM04X-101-302": 100, "ESM013B-152-304": 1500}
    for name, watts in power.items():
        motor = CATALOG.motor(name)
        assert motor.rated_torque.nominal() * motor.rated_speed.nominal() == pytest.approx(watts, rel=0.05)
