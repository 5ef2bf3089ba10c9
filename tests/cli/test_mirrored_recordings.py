"""A rig that turns the other way, a sensor mounted the other way round, another unit: every command says the same."""

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.scenario.reading import read_scenario

RATE, SECONDS, TOP, RATIO = 1000.0, 6.0, 20 * pi, 5.0
TIME = np.arange(int(RATE * SECONDS)) / RATE
TRUTH = "true_load_Nm"

VARIANTS = {
    "torque sensor the other way round": {"torque": -1},
    "encoder the other way round": {"angle": -1},
    "rig reversed": {"torque": -1, "angle": -1, "speed": -1},
    "set-point and angle reversed": {"angle": -1, "speed": -1},
    "mV": {"unit": "mV", "scale": 2e-3},
    "kN*m": {"unit": "kN*m", "scale": 1e3},
    "V, falling with the torque": {"unit": "V", "scale": -3.0},
}


def motion(profile: str) -> np.ndarray:
    """Return the speed of the motor [rad/s]."""
    if profile == "steady":
        return TOP * (1 + 0.002 * np.sin(2 * pi * 0.2 * TIME))
    if profile == "reversal":
        return TOP * np.sin(4 * pi * TIME / SECONDS)
    return TOP * np.where(TIME < 0.9 * SECONDS, 0.1 + TIME / SECONDS, 1.0)


def recorded(profile, source, *, torque=1, angle=1, speed=1, unit="N*m", scale=1.0) -> Recording:
    turning = motion(profile)
    turned = np.cumsum(turning) / RATE
    random = np.random.default_rng(1)
    load = 1.5 + 0.05 * random.standard_normal(TIME.size)
    for start in random.integers(100, TIME.size - 100, 30):
        load[start:] += 0.8 * np.exp(-(TIME[start:] - TIME[start]) / 0.01)
    reading = load + 0.3 * np.cos(turned / RATIO) + 0.2 * np.cos(turned) + 0.3 * np.cos(7 * turned + 1)
    reading += 0.05 * np.cos(2 * pi * 150 * TIME)
    counts = np.round(turned / (2 * pi) * 4096)
    channels = {
        "torque": Channel(values=torque * reading / scale, quantity="torque", unit=unit, si_per_unit=scale),
        TRUTH: Channel(values=torque * load, quantity="torque", unit="N*m", truth=True),
    }
    others = {
        "encoder": ("count", angle * counts, "motor_angle", 2 * pi / 4096),
        "degrees": ("deg", np.mod(np.degrees(angle * turned), 360.0), "motor_angle", pi / 180),
        "speed": ("rpm", angle * turning * 30 / pi, "motor_speed", pi / 30),
    }
    if source in others:
        name, values, quantity, factor = others[source]
        channels["motion"] = Channel(values=values, quantity=quantity, unit=name, si_per_unit=factor)
    run = Run(motor="bldc-12n14p", gear_ratio=RATIO, speed=speed * TOP, profile=profile)
    return Recording(sample_rate=RATE, channels=channels, run=run)


def told(capsys, path: Path, *arguments: str) -> list[str]:
    """Return the words that a command prints, without the signs of its numbers and the lines of its tables."""
    main((arguments[0], str(path), *arguments[1:]))
    return words_of(capsys.readouterr().out)


def words_of(printed: str) -> list[str]:
    """Return the words of a text, without the signs of its numbers and the lines of its tables."""
    return re.sub(r"-(?=[\d.])|(?m:^-+$)", "", printed).split()


@pytest.mark.long
@pytest.mark.parametrize("profile", ["steady", "ramp"])
@pytest.mark.parametrize(
    "source",
    [pytest.param("encoder"), *(pytest.param(one, marks=pytest.mark.full) for one in ("degrees", "speed", "none"))],
)
def test_filter_and_ordermap_say_the_same(tmp_path, monkeypatch, capsys, profile, source):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "run.parquet"
    commands = (
        ("filter", "--chain", "order_lines", "--chain", "report_filter_code", "--chain", "low_pass_20Hz"),
        ("ordermap",),
    )
    write_recording(recorded(profile, source), path)
    plain = [told(capsys, path, *command) for command in commands]
    for name, changed in VARIANTS.items():
        write_recording(recorded(profile, source, **changed), path, overwrite=True)
        assert [told(capsys, path, *command) for command in commands] == plain, name


@pytest.mark.long
@pytest.mark.parametrize("source", [pytest.param("encoder", marks=pytest.mark.full), "none"])
def test_an_evaluation_says_the_same(tmp_path, monkeypatch, capsys, source):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "run.parquet"
    command = ("filter", "--chain", "order_lines", "--evaluate", "--force")
    write_recording(recorded("ramp", source), path)
    plain = told(capsys, path, *command)
    for name, changed in VARIANTS.items():
        write_recording(recorded("ramp", source, **changed), path, overwrite=True)
        assert told(capsys, path, *command) == plain, name


@pytest.mark.parametrize("name", VARIANTS)
def test_the_filtered_torque_is_the_mirrored_or_scaled_one(name):
    import torquerig as tr

    plain = tr.filter(recorded("ramp", "encoder"), "order_lines").torque()
    changed = tr.filter(recorded("ramp", "encoder", **VARIANTS[name]), "order_lines").torque()
    sign = VARIANTS[name].get("torque", 1)
    assert sign * changed == pytest.approx(plain, abs=1e-9)


@pytest.mark.parametrize("name", VARIANTS)
def test_as_many_suspicions_are_found(name):
    from torquerig.recordings.inspection.recording_info import recording_info

    plain, changed = recorded("steady", "encoder"), recorded("steady", "encoder", **VARIANTS[name])
    assert len(recording_info(changed).suspicions()) == len(recording_info(plain).suspicions())


# a reversal, and the commands that read a scenario

SCENARIO = """
operating_point: {output_speed: SPEED, load: {occupancy: 5 %}, duty_cycle: {segments: [
  {duration: 1 s, output_speed: SPEED, ramp: true, load_torque: 1 N*m},
  {duration: 5 s, output_speed: SPEED, load_torque: 2 N*m}, {duration: 4 s, output_speed: 0 rpm, load_torque: 0 N*m}]}}
measured: sensor
recording: {sample_rate: 1 kHz, duration: 1 s, settling: 1 s}
rig:
  motor: {kind: motor, catalog: HDS6A-0104A}
  gear: {kind: gear, ratio: RATIO, stiffness: 5 kN*m/rad, damping: 1 N*m*s/rad, efficiency: 0.9,
         output_inertia: 5 kg*cm^2}
  sensor: {kind: torque_sensor, stiffness: 2 kN*m/rad, damping: 0.1 N*m*s/rad, inertia: 1 kg*cm^2,
           sensitivity: 1 V/(N*m), bandwidth: 200 Hz, noise_rms: 1 mV, mounting: MOUNTING}
  drum: {kind: body, inertia: 0.005 kg*m^2, viscous: 0.02 N*m*s/rad}
  load: {kind: particle_load, at: drum, mean_by_occupancy_percent: {0: 0.5 N*m, 10: 2 N*m}, hit_rms: 0.05}
  controller: {kind: speed_controller, motor: motor, kp: 0.02 N*m*s/rad, ki: 0.1 N*m/rad}
  encoder: {kind: motor_encoder, counts_per_rev: 4096}
"""
RIGS = {
    "as it is": ("120 rpm", "5", "forward"),
    "the other way": ("-120 rpm", "5", "forward"),
    "behind a reversing gear": ("120 rpm", "-5", "forward"),
    "both": ("-120 rpm", "-5", "forward"),
    "sensor the other way round": ("120 rpm", "5", "reversed"),
}


def written(folder: Path, name: str) -> Path:
    speed, ratio, mounting = RIGS[name]
    path = folder / "rig.yaml"
    text = SCENARIO.replace("SPEED", speed).replace("RATIO", ratio).replace("MOUNTING", mounting)
    path.write_text(text if mounting == "reversed" else text.replace(", mounting: forward", ""))
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_a_reversal_is_filtered_and_mapped_the_same(name):
    import torquerig as tr

    plain, changed = recorded("reversal", "encoder"), recorded("reversal", "encoder", **VARIANTS[name])
    sign = VARIANTS[name].get("torque", 1)
    filtered = [tr.filter(one, "order_lines").torque() for one in (plain, changed)]
    assert sign * filtered[1] == pytest.approx(filtered[0], abs=1e-9)
    assert np.std(filtered[0]) < np.std(plain.torque())
    lines = [tr.order_lines(one).lines for one in (plain, changed)]
    assert [one.label for one in lines[1]] == [one.label for one in lines[0]]
    assert [one.place for one in lines[1]] == pytest.approx([one.place for one in lines[0]], rel=1e-9)


@pytest.mark.parametrize("command", [("size",), ("duty", "--profile", "duty_cycle")])
def test_size_and_duty_say_the_same_of_a_mirrored_rig(tmp_path, capsys, command):
    said = {}
    for name in RIGS:
        said[name] = told(capsys, written(tmp_path, name), *command)
    assert all(one == said["as it is"] for one in said.values())


def test_a_simulated_mirrored_rig_reads_the_mirrored_load(tmp_path, capsys):
    levels = {}
    for name, (speed, _, _) in RIGS.items():
        out = tmp_path / "run.parquet"
        main(("simulate", str(written(tmp_path, name)), "--out", str(out), "--force"))
        capsys.readouterr()
        read = read_recording(out)
        sign = -1 if speed.startswith("-") else 1
        assert np.sign(read.run.speed) == sign * (-1 if RIGS[name][1] == "-5" else 1)
        levels[name] = sign * read.torque().mean(), read.torque().std()
    # the lines of motor and load meet in another phase
    for name, (mean, spread) in levels.items():
        assert mean == pytest.approx(levels["as it is"][0], rel=0.01), name
        assert spread == pytest.approx(levels["as it is"][1], rel=0.25), name


@pytest.mark.parametrize("profile", ["steady", "reversal"])
def test_a_check_before_a_diagnosis_says_the_same(tmp_path, profile):
    path, scenario = (
        tmp_path / "run.parquet",
        read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=0),
    )
    said = {}
    for name, changed in {"plain": {}, **VARIANTS}.items():
        write_recording(recorded(profile, "encoder", **changed), path, overwrite=True)
        said[name] = words_of(run_check(scenario, [read_recording(path)]).text())
    for name, words in said.items():
        assert words == said["plain"], name


def test_the_duty_of_a_mirrored_recording_is_the_same():
    from torquerig.thermal.motor_duty import duty_of_recording

    duties = []
    for sign in (1, -1):
        one = recorded("reversal", "speed", torque=sign, angle=sign, speed=sign)
        motor = Channel(values=one.torque(), quantity="motor_torque", unit="N*m")
        duties.append(duty_of_recording(one.with_channel("motor_torque", motor)))
    first, second = duties
    assert second.rms_torque == pytest.approx(first.rms_torque, rel=1e-12)
    assert second.mean_speed == pytest.approx(first.mean_speed, rel=1e-12)
    assert second.peak_torque == pytest.approx(first.peak_torque, rel=1e-12)
