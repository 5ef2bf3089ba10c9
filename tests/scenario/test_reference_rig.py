"""scenarios/wear_rig.yaml cell by cell against the reference rig, where that file stands beside the checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import ParticleLoad, TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

REFERENCE = Path(__file__).resolve().parents[2] / ".." / "shared" / "reference-rig.yaml"
pytestmark = pytest.mark.skipif(not REFERENCE.exists(), reason="shared/reference-rig.yaml is not beside this checkout")

# cell of the reference -> field of the rig; a mapping in the reference also states rel_sd
CELLS = {
    "motor.slots": "motor.slots",
    "motor.rotor_inertia_kgm2": "motor.inertia",
    "motor.viscous_Nms_per_rad": "motor.viscous",
    "motor.coulomb_Nm": "motor.coulomb",
    "motor.torque_limit_Nm": "motor.torque_limit",
    "motor.current_loop_bandwidth_Hz": "motor.current_loop_bandwidth",
    "gearbox.ratio": "gearbox.ratio",
    "gearbox.stiffness_output_Nm_per_rad": "gearbox.stiffness",
    "gearbox.damping_output_Nms_per_rad": "gearbox.damping",
    "gearbox.efficiency": "gearbox.efficiency",
    "gearbox.backlash_arcmin": "gearbox.backlash",
    "torque_sensor.stiffness_Nm_per_rad": "torque_sensor.stiffness",
    "torque_sensor.damping_Nms_per_rad": "torque_sensor.damping",
    "torque_sensor.inertia_output_side_kgm2": "torque_sensor.inertia",
    "torque_sensor.sensitivity_V_per_Nm": "torque_sensor.sensitivity",
    "torque_sensor.bandwidth_Hz": "torque_sensor.bandwidth",
    "torque_sensor.noise_rms_V": "torque_sensor.noise_rms",
    "torque_sensor.adc.range_V": "torque_sensor.converter_range",
    "torque_sensor.adc.bits": "torque_sensor.converter_bits",
    "coupling.stiffness_Nm_per_rad": "coupling.stiffness",
    "coupling.damping_Nms_per_rad": "coupling.damping",
    "wear_part.inertia_kgm2": "wear_part.inertia",
    "wear_part.viscous_Nms_per_rad": "wear_part.viscous",
    "speed_controller.kp_Nms_per_rad": "speed_controller.kp",
    "speed_controller.ki_Nm_per_rad": "speed_controller.ki",
}


def reference(path: str = "") -> Any:
    """A cell of the reference; PyYAML reads ``1.5e-4`` (no sign of the mantissa's point) as YAML 1.1 does."""
    cell = yaml.safe_load(REFERENCE.read_text(encoding="utf-8"))
    for key in path.split(".") if path else []:
        cell = cell[key]
    return cell


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    return read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=1)


def value(rig: Rig, field: str) -> float:
    part, name = field.split(".")
    return float(getattr(rig.part(part), name))


@pytest.mark.parametrize(("cell", "field"), CELLS.items())
def test_each_cell_of_the_reference_stands_in_the_wear_rig(cell: str, field: str, scenario: Scenario) -> None:
    stated = reference(cell)
    uncertain = stated if isinstance(stated, dict) else {"value": stated, "rel_sd": 0}
    assert value(scenario.rig, field) == pytest.approx(float(uncertain["value"]), rel=1e-12)
    spread = scenario.uncertainties[field].rel_sd if field in scenario.uncertainties else 0.0
    assert spread == pytest.approx(uncertain["rel_sd"], rel=1e-12)


def test_every_uncertainty_of_the_rig_stands_in_the_reference(scenario: Scenario) -> None:
    inertia = "gearbox.input_inertia"  # stated at the output there, see the next test
    assert set(scenario.uncertainties) <= {*CELLS.values(), inertia}


def test_gearbox_inertia_is_the_reference_one_at_the_output(scenario: Scenario) -> None:
    stated = reference("gearbox.inertia_output_kgm2")
    rig = scenario.rig
    at_output = value(rig, "gearbox.output_inertia") + value(rig, "gearbox.input_inertia") * 5**2
    assert at_output == pytest.approx(float(stated["value"]), rel=1e-12)
    assert scenario.uncertainties["gearbox.input_inertia"].rel_sd == stated["rel_sd"]


def test_magnets_are_twice_the_pole_pairs(scenario: Scenario) -> None:
    assert 2 * value(scenario.rig, "motor.pole_pairs") == reference("motor.magnets")


def test_operating_point(scenario: Scenario) -> None:
    stated = reference("operating_point")
    assert scenario.rig.run.speed_rpm == pytest.approx(stated["motor_speed_rpm"])
    assert scenario.operating_point.speed_set_point_error_max == stated["speed_set_point_error_max"]
    assert scenario.operating_point.slow_speed_wander == stated["slow_speed_wander"]["rel_sd"]


@pytest.mark.parametrize(("stated", "group"), [
    ("mechanical", "mechanical"), ("cogging_as_published", "cogging"), ("electrical", "electrical"),
])  # fmt: skip
def test_lines_of_the_motor(stated: str, group: str, scenario: Scenario) -> None:
    ripple = scenario.rig.part(f"motor.{group}")
    assert isinstance(ripple, TorqueRipple)
    assert ripple.amplitudes == pytest.approx(reference("ripple_at_motor_Nm_by_motor_order")[stated])
    assert (ripple.at, ripple.group, ripple.amplitude_rel_sd, ripple.relief_per_percent) == ("motor", group, 0.25, 0.0)


def test_lines_of_the_wear_part(scenario: Scenario) -> None:
    ripple = scenario.rig.part("shaft")
    assert isinstance(ripple, TorqueRipple)
    assert ripple.amplitudes == pytest.approx(reference("ripple_at_wear_part_Nm_by_output_order.mechanical"))
    # the relief 0.12 per percent and the spread 0.25 stand in the reference's comments
    assert (ripple.at, ripple.relief_per_percent, ripple.amplitude_rel_sd) == ("wear_part", 0.12, 0.25)


def test_nothing_else_disturbs_the_nominal_rig(scenario: Scenario) -> None:
    effects = {part.name for part in scenario.rig.parts if part.group}
    assert effects == {"motor.mechanical", "motor.cogging", "motor.electrical", "shaft", "load"}
    assert scenario.assumed.keys() <= {"gearbox.teeth"}


def test_load(scenario: Scenario) -> None:
    stated, load = reference("load"), scenario.rig.part("load")
    assert isinstance(load, ParticleLoad)
    assert load.mean_by_occupancy_percent == stated["mean_Nm_by_occupancy_percent"]
    hits = stated["particle_hits"]
    assert hits["rate_per_s"].startswith(
        f"{load.hit_rate:g} * (0.5 / particle_mm) ** 1.5 * (0.3 + occupancy_percent / 10)"
    )
    assert hits["pulse_decay_s"] == f"{load.hit_decay:g} * sqrt(particle_mm / 0.5)"
    assert hits["hit_size"] == f"gamma distributed, shape {load.hit_shape:g}"
    assert load.hit_rms == hits["rms_fraction_of_mean"]
    assert load.slow_rms == stated["slow_variation"]["rms_fraction_of_mean"]
    assert load.slow_cutoff == stated["slow_variation"]["low_pass_Hz"]
    assert load.smoothing == 0.02
