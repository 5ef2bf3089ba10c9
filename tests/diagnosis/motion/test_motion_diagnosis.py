"""Carriages and rotors made by equations of the test's own, diagnosed through the motion that was measured."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray

from tests.moved_rigs import ROTOR
from torquerig import mechanisms
from torquerig.catalog.reading import Catalog
from torquerig.cli.diagnose import command
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.lines import lines_in
from torquerig.diagnosis.motion.moved import moved
from torquerig.diagnosis.motion.set_aside import CLASSES
from torquerig.document import parse_document
from torquerig.errors import RecordingError
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.parts import ImposedMotion
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

Floats = NDArray[np.float64]
Carriage = Callable[..., Recording]
Diagnosed = Callable[..., MotionOutcome]


def friction(time: Floats, position: Floats, speed: Floats) -> Floats:
    return np.where(speed > 0, 6.0 + 8.0 * speed, -9.0 + 20.0 * speed)


def nothing(time: Floats, position: Floats, speed: Floats) -> Floats:
    return np.zeros(time.size)


def ripple(time: Floats, position: Floats, speed: Floats) -> Floats:
    return 1.0 * np.cos(2 * np.pi * 150.0 * position + 0.4)


def hum(time: Floats, position: Floats, speed: Floats) -> Floats:
    return 1.0 * np.cos(2 * np.pi * 23.0 * time)


def test_a_wrong_mass_is_no_missing_physics(diagnosed: Diagnosed, carriage: Carriage) -> None:
    outcome = diagnosed(carriage(nothing))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("adequate", ())
    assert outcome.after.rig.part("carriage").mass == pytest.approx(10.0, rel=5e-3)
    fit = outcome.diagnosis.fit
    assert fit.before == fit.after < 0.2 * fit.nominal
    aside = outcome.diagnosis.set_aside
    assert set(aside) == set(CLASSES)
    assert aside["stribeck_friction"].startswith(
        "tested: the log-likelihood rises by less than the penalty for its parameters"
    )
    assert aside["backlash"] == "the rig has no gear or link that could have backlash"
    assert aside["cogging"] == "the moved part is not a motor"


@pytest.mark.long
def test_friction_by_direction_is_named_with_its_numbers(diagnosed: Diagnosed, carriage: Carriage) -> None:
    outcome = diagnosed(carriage(friction))
    (finding,) = outcome.diagnosis.findings
    assert (outcome.diagnosis.verdict, finding.mechanism, finding.variant) == (
        "missing_physics", "stribeck_friction", "by_direction",
    )  # fmt: skip
    told = {name: each.value for name, each in finding.parameters.items()}
    assert told["coulomb_Nm_forward"] == pytest.approx(6.0, rel=0.05)
    assert told["coulomb_Nm_backward"] == pytest.approx(9.0, rel=0.05)
    assert told["viscous_Nms_forward"] == pytest.approx(8.0, rel=0.1)
    assert told["viscous_Nms_backward"] == pytest.approx(20.0, rel=0.1)
    assert outcome.diagnosis.fit.improvement[1] > 0.8
    aside = outcome.diagnosis.set_aside
    assert set(aside) == set(CLASSES) - {"stribeck_friction"}
    assert aside["quadratic_drag"].startswith("tested together with stribeck friction: ")
    assert (outcome.left, outcome.diagnosis.mismatch) == ((), outcome.missed)


@pytest.mark.long
def test_without_its_mechanism_friction_is_unexplained_and_gets_no_other_name(
    monkeypatch: pytest.MonkeyPatch, diagnosed: Diagnosed, carriage: Carriage
) -> None:
    for gone in ("StribeckFriction", "LugreFriction"):
        monkeypatch.delattr(mechanisms, gone)
    outcome = diagnosed(carriage(friction))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    assert outcome.diagnosis.mismatch[0].domain == "speed"
    assert outcome.diagnosis.set_aside["stribeck_friction"] == "not in the library"
    assert outcome.diagnosis.set_aside["quadratic_drag"].startswith("tested: its gain is ")


@pytest.mark.long
@pytest.mark.parametrize(
    ("extra", "domain", "axis", "at"), [(ripple, "order", "cycles/m", 150.0), (hum, "frequency", "Hz", 23.0)]
)
def test_a_line_of_no_known_cause_is_located_and_left_without_a_name(
    extra: Callable[..., Floats], domain: str, axis: str, at: float, diagnosed: Diagnosed, carriage: Carriage
) -> None:
    outcome = diagnosed(carriage(extra))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    worst = outcome.diagnosis.mismatch[0]
    assert (worst.domain, worst.axis) == (domain, axis)
    assert worst.at == pytest.approx(at, abs=worst.width)
    assert worst.p_value < 1e-6
    first = outcome.neutrals[0]
    assert first.after < 0.7 * first.before  # 0.71 N of the line beside 0.22 N of noise in the compared band


@pytest.mark.long
def test_cogging_of_a_turned_motor_is_named_by_its_native_order(diagnosed: Diagnosed) -> None:
    """12 slots, 14 poles: order 84 and, of unequal magnets, 12."""
    time = np.arange(6000) / 100.0
    angle = 0.11 * time + 0.02 * np.sin(0.5 * time)
    torque = 0.02 * np.cos(84 * angle + 0.3) + 0.004 * np.cos(12 * angle - 1.0)
    torque += 5e-4 * np.random.default_rng(3).standard_normal(time.size)
    channels = {
        "current_A": Channel(values=torque / 0.05, quantity="motor_torque", unit="A", si_per_unit=0.05),
        "angle_rad": Channel(values=angle, quantity="angle", unit="rad"),
    }
    outcome = diagnosed(Recording(sample_rate=100.0, channels=channels, name="turn.csv"), ROTOR)
    (finding,) = outcome.diagnosis.findings
    assert finding.mechanism == "cogging"
    assert finding.parameters["order_motor"].value == 84
    assert finding.parameters["amplitude_A"].value == pytest.approx(0.4, rel=0.02)
    assert outcome.diagnosis.verdict == "missing_physics"


@pytest.mark.long
def test_the_command_writes_a_model_that_simulates_to_the_figures_after(
    tmp_path: Path, carriage: Carriage, stated: str
) -> None:
    write_recording(carriage(friction), tmp_path / "run.csv")
    (tmp_path / "rig.yaml").write_text(stated, encoding="utf-8")
    asked = [str(tmp_path / "run.csv"), "--scenario", str(tmp_path / "rig.yaml"), "--json", str(tmp_path / "out.json")]
    answer = CliRunner().invoke(command, asked, catch_exceptions=False)
    assert answer.exit_code == 0
    told = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    assert told["schema"] == "torquerig.diagnosis/1"
    assert [one["mechanism"] for one in told["findings"]] == ["stribeck_friction"]
    text = Path(told["model"]).read_text(encoding="utf-8").replace(
        "kind: imposed_motion", "kind: imposed_motion\n    recording: run.csv"
    )  # fmt: skip
    better = read_scenario(parse_document(text, tmp_path / "model.yaml"), Catalog(), seed=0)
    run = read_recording(tmp_path / "run.csv")
    made = simulate(better.rig, duration=run.duration, seed=0, sample_rate=run.sample_rate, settling=0.0).torque()
    measured = run.torque()
    inner = slice(100, -100)
    left = measured[inner] - made[inner]
    assert np.sqrt(np.mean((left - left.mean()) ** 2)) < 1.0  # 0.5 N of noise, and sharper reversals than the fit's


def test_a_recording_without_effort_or_motion_is_refused_in_one_sentence(
    diagnosed: Diagnosed, carriage: Carriage
) -> None:
    whole = carriage(nothing)
    force = Recording(sample_rate=whole.sample_rate, channels={"force_N": whole.channels["force_N"]}, name="run.csv")
    with pytest.raises(RecordingError, match=r"run.csv has no channel 'position'"):
        diagnosed(force)
    place = Recording(
        sample_rate=whole.sample_rate, channels={"position_m": whole.channels["position_m"]}, name="run.csv"
    )
    with pytest.raises(RecordingError, match=r"run.csv: there is no torque, force or motor_torque channel"):
        diagnosed(place)
    quiet = {**whole.channels, "force_N": Channel(values=np.zeros(whole.samples), quantity="force", unit="N")}
    with pytest.raises(RecordingError, match=r"run.csv: its torque or force is always zero"):
        diagnosed(Recording(sample_rate=whole.sample_rate, channels=quiet, name="run.csv"))


def test_a_motion_that_has_every_frequency_hides_them_and_breaks_nothing() -> None:
    """Forth and back at one speed: its square wave leaves no frequency in which a line could be told from it."""
    rate = 400.0
    time = np.arange(8000) / rate
    channels = {
        "force_N": Channel(values=np.full(time.size, 20.0), quantity="force", unit="N"),
        "position_m": Channel(values=0.05 * np.abs((time + 5.0) % 10.0 - 5.0), quantity="position", unit="m"),
    }
    part = ImposedMotion(name="motion", at="carriage", channel="position")
    run = moved(Recording(sample_rate=rate, channels=channels, name="even.csv"), part)
    left = 0.1 * np.random.default_rng(5).standard_normal(time.size)
    assert lines_in([left], [run]) == ()
