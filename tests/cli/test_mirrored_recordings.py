"""A rig that turns the other way, a sensor mounted the other way round, another unit: every command says the same."""

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

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
    printed = capsys.readouterr().out
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
