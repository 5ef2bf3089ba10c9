"""The worked examples of the how-tos do what their pages say."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import numpy as np
import pytest

import torquerig
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import load_catalog, read_entry
from torquerig.document import read_document
from torquerig.inference.motion.answer import as_json
from torquerig.inference.motion.engine import diagnose_motion
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar import read_sidecar
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.input_channels import driven_parts
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

ROOT = Path(__file__).resolve().parents[2]


def example(page: str, name: str) -> str:
    """Return the fenced block after ``<!-- file: name -->``."""
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    match = re.search(rf"<!-- file: {re.escape(name)} -->\n```\w+\n(.*?)```", text, re.DOTALL)
    assert match is not None
    return match[1]


def scenario(name: str) -> Scenario:
    return read_scenario(read_document(ROOT / "scenarios" / name), load_catalog(ROOT / "catalogs"), seed=1)


def test_eccentric_mass_of_howto_add_physics_reaches_the_sensor_as_predicted(tmp_path: Path) -> None:
    file = tmp_path / "eccentric_mass.py"
    parts = [example("howto-add-physics.md", name) for name in ("eccentric_mass.py", "check_eccentric_mass.py")]
    file.write_text("\n\n".join(parts), encoding="utf-8")
    made = runpy.run_path(str(file))
    effect = made["EccentricMass"](name="screw", mass=0.5, radius=0.02)
    found, predicted = made["line_and_expectation"](scenario("wear_rig.yaml").rig, effect)
    assert 0.5 * made["GRAVITY"] * 0.02 == pytest.approx(0.0981, abs=5e-5)
    assert predicted == pytest.approx(0.0987, abs=5e-5)
    # the weight moves the speed, so that the load's pulses fall on other angles: 0.15 % on this seed
    assert found == pytest.approx(predicted, rel=5e-3)


def test_motor_of_howto_add_a_motor_is_read(tmp_path: Path) -> None:
    file = tmp_path / "servo-300W.yaml"
    file.write_text(example("howto-add-a-motor.md", "catalogs/motors/servo-300W.yaml"), encoding="utf-8")
    motor = read_entry(file, Motor)
    assert motor.name == "servo-300W"
    assert motor.drive_price.unknown


def test_figures_as_printed_of_howto_add_a_motor_are_converted(tmp_path: Path) -> None:
    page, doubled = "howto-add-a-motor.md", ("coulomb_friction", "viscous_friction", "  cogging")
    lines = example(page, "catalogs/motors/servo-300W.yaml").splitlines()
    text = "\n".join(line for line in lines if not line.startswith(doubled))
    file = tmp_path / "servo-300W.yaml"
    file.write_text(f"{text}\n{example(page, 'as_printed')}", encoding="utf-8")
    motor = read_entry(file, Motor)
    assert motor.torque_constant.value == pytest.approx(0.39)
    assert "taken as rms, the reading that agrees with the other value" in motor.torque_constant.note
    assert motor.phase_resistance.bounds == pytest.approx((2.565, 3.135))


def test_the_short_motor_of_howto_add_a_motor_is_filled_by_its_class(tmp_path: Path) -> None:
    file = tmp_path / "servo-400W.yaml"
    file.write_text(example("howto-add-a-motor.md", "like"), encoding="utf-8")
    motor = read_entry(file, Motor, load_catalog(ROOT / "catalogs").classes)
    assert motor.coulomb_friction.evidence == "CLASS"
    assert motor.rated_torque.value == 1.27


def test_two_stage_branch_turns_and_sounds_as_its_page_says() -> None:
    made = scenario("two_stage_branch.yaml")
    assert made.rig.speed_ratios("motor") == pytest.approx(
        {
            "motor": 1,
            "planetary": 1 / 4,
            "fan_shaft": 1 / 4,
            "belt": 1 / 10,
            "torque_sensor": 1 / 10,
            "coupling": 1 / 10,
        }
    )
    assert made.rig.run.speed_rpm == pytest.approx(600)
    modes = matrices(lower(made.rig, 1)).undamped_frequencies()
    assert modes[:4] == pytest.approx((0, 64, 127, 257), abs=0.5)
    reading = simulate(made.rig, duration=4.0, seed=1).torque()
    window = np.hanning(reading.size)
    levels = 2 * np.abs(np.fft.rfft((reading - reading.mean()) * window)) / window.sum()
    # bins of 0.25 Hz; the mesh stands alone between the motor's orders 17 and 19
    near = slice(round(171 / 0.25), round(189 / 0.25))
    assert np.argmax(levels[near]) * 0.25 + 171 == pytest.approx(180, abs=0.3)
    assert levels[near].max() == pytest.approx(0.045, abs=0.005)


def test_howto_describe_your_own_rig_prints_the_lines_of_the_shipped_scenario() -> None:
    shipped = (ROOT / "scenarios" / "two_stage_branch.yaml").read_text(encoding="utf-8")
    page = (ROOT / "docs" / "howto-describe-your-own-rig.md").read_text(encoding="utf-8")
    other = re.sub(r"<!-- file: \S+ -->\n```yaml\n.*?```", "", page, flags=re.DOTALL)  # rigs and sidecars of their own
    printed = [line for block in re.findall(r"```yaml\n(.*?)```", other, re.DOTALL) for line in block.splitlines()]
    stated = {line.split("#")[0].rstrip() for line in shipped.splitlines()}
    assert [line for line in printed if line.rstrip() not in stated] == []


def test_several_sensors_of_howto_describe_your_own_rig_are_written(tmp_path: Path) -> None:
    """Each place has its column; the parts under measured inputs are of that rig too."""
    page, file = "howto-describe-your-own-rig.md", tmp_path / "several_sensors.yaml"
    file.write_text(example(page, file.name), encoding="utf-8")
    made = read_scenario(read_document(file), load_catalog(ROOT / "catalogs"), seed=1)
    run = simulate(made.rig, duration=0.2, seed=1)
    of = {name: one.of for name, one in run.channels.items() if not one.truth}
    assert of == {
        "output_sensor_V": "output_sensor", "input_sensor_V": "input_sensor", "tacho_rad_s": "tacho",
        "motor_current_A": "motor_current",
    }  # fmt: skip
    assert run.channels["input_sensor_V"].si_per_unit < 0
    whole = example(page, file.name) + example(page, "inputs.yaml")
    file.write_text(re.sub(r"  speed_controller:.*\n", "", whole), encoding="utf-8")
    driven = read_scenario(read_document(file), load_catalog(ROOT / "catalogs"), seed=1)
    assert [part.from_ for part in driven_parts(driven.rig)] == ["channel torque", "channel motor_speed"]
    file.write_text(example(page, "input_channel.yaml"), encoding="utf-8")
    assert read_sidecar(file).channels["brake_mV"].si_per_unit == 0.005


def test_the_motor_foot_of_howto_describe_your_own_rig_is_read_beside_the_sensor(tmp_path: Path) -> None:
    """Its two keys are put into the shipped wear rig."""
    block = example("howto-describe-your-own-rig.md", "motor_foot.yaml")
    measured, foot = block.split("rig:\n")
    shipped = (ROOT / "scenarios" / "wear_rig.yaml").read_text(encoding="utf-8")
    shipped = re.sub(r"^measured:.*\n", measured, shipped, flags=re.MULTILINE)
    file = tmp_path / "wear_rig.yaml"
    file.write_text(shipped.replace("\nrig:\n", f"\nrig:\n{foot}", 1), encoding="utf-8")
    made = read_scenario(read_document(file), load_catalog(ROOT / "catalogs"), seed=1)
    run = simulate(made.rig, duration=0.5, seed=1)
    torques = {name: one for name, one in run.channels.items() if one.quantity == "torque" and not one.truth}
    assert {one.of for one in torques.values()} == {"foot", "torque_sensor"}
    # the sensor reads the foot's torque times the ratio of 5, less the losses of motor and gear
    means = {one.of: float(one.in_si().mean()) for one in torques.values()}
    assert 3.5 < means["torque_sensor"] / means["foot"] < 5


def test_shaft_line_of_howto_diagnose_measured_motion_is_driven_by_its_recording(tmp_path: Path) -> None:
    page = "howto-diagnose-measured-motion.md"
    for name in ("shaft_line.yaml", "line1.yaml"):
        (tmp_path / name).write_text(example(page, name), encoding="utf-8")
    wave = np.sin(0.1 * np.arange(600))
    rows = np.column_stack([1 + 0.3 * wave, 1.2 + 0.3 * wave, 0.5 + 0.2 * wave, np.linspace(300, 320, 600)])
    header = "outer_V,inner_V,brake_Nm,speed_rpm"
    np.savetxt(tmp_path / "line1.csv", rows, delimiter=",", header=header, comments="")
    made = read_scenario(read_document(tmp_path / "shaft_line.yaml"), load_catalog(ROOT / "catalogs"), seed=1)
    shown = run_check(made, [read_recording(tmp_path / "line1.csv")]).text()
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    for line in re.findall(r"^line1\.csv: .*$", text, re.MULTILINE):
        assert line in shown


@pytest.mark.long
def test_table_of_howto_diagnose_measured_motion_lacks_its_dry_friction(tmp_path: Path) -> None:
    """Beside the scenario and the sheet of the page a recording of 4.6 kg on a guide of 20 N, by its own equation."""
    page, rate = "howto-diagnose-measured-motion.md", 500.0
    (tmp_path / "table.yaml").write_text(example(page, "table.yaml"), encoding="utf-8")
    (tmp_path / "run1.yaml").write_text(example(page, "run1.yaml"), encoding="utf-8")
    time = np.arange(6000) / rate
    swings = ((0.1, 2 * np.pi * 0.5), (0.02, 2 * np.pi * 1.3))
    place = sum(a * np.sin(w * time) for a, w in swings)
    speed = sum(a * w * np.cos(w * time) for a, w in swings)
    gained = sum(-a * w**2 * np.sin(w * time) for a, w in swings)
    force = 4.6 * gained + 20.0 * np.tanh(speed / 1e-3) + 0.3 * np.random.default_rng(4).standard_normal(time.size)
    rows = np.column_stack([time, force / 50, np.round(place / 1e-6)])
    np.savetxt(tmp_path / "run1.csv", rows, delimiter=",", header="time_s,force_V,scale_count", comments="", fmt="%.8g")
    made = read_scenario(read_document(tmp_path / "table.yaml"), load_catalog(ROOT / "catalogs"), seed=0)
    outcome = diagnose_motion(made, [read_recording(tmp_path / "run1.csv")])
    said = as_json(outcome)
    (finding,) = said["findings"]
    assert (said["verdict"], finding["mechanism"]) == ("missing_physics", "stribeck_friction")
    assert finding["parameters"]["coulomb_Nm"]["value"] == pytest.approx(20.0, rel=0.03)
    assert (finding["parameters"]["coulomb_Nm"]["unit"], outcome.runs[0].channel.unit) == ("N", "V")


def test_joint_of_howto_diagnose_measured_motion_is_read(tmp_path: Path) -> None:
    file = tmp_path / "joint.yaml"
    file.write_text(example("howto-diagnose-measured-motion.md", "joint.yaml"), encoding="utf-8")
    made = read_scenario(read_document(file), load_catalog(ROOT / "catalogs"), seed=0)
    assert imposed_part(made.rig) is not None


@pytest.mark.long
def test_scripts_of_howto_use_python_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The blocks from simulate to a further effect run in order; those of minutes are parsed and their names exist."""
    text = (ROOT / "docs" / "howto-use-python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    quick = [block for block in blocks if "tr.compare" not in block and "tr.diagnose" not in block]
    assert (len(blocks), len(quick)) == (6, 4)
    monkeypatch.chdir(tmp_path)
    scope: dict[str, object] = {}
    for block in quick:
        exec(compile(block, "howto-use-python.md", "exec"), scope)
    assert (tmp_path / "clean.parquet").exists()
    assert (tmp_path / "orders.png").exists()
    for block in blocks:
        compile(block, "howto-use-python.md", "exec")
    assert [name for name in re.findall(r"\btr\.(\w+)", text) if not hasattr(torquerig, name)] == []
