"""Measured inputs: a channel of each recording drives the model in that recording."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

import torquerig as tr
from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.errors import InputError, TorquerigError
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.inputs import driven_by, input_channel
from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RATE = 5000.0
SHAFT = """
operating_point: {}
recording: {settling: 0 s}
measured: [outer, inner]
rig:
  motor: {kind: motor, inertia: 15 kg*cm^2, torque_limit: 50 N*m, viscous: 1.0e-3 N*m*s/rad}
  inner: {kind: torque_sensor, stiffness: 3 kN*m/rad, damping: 0.5 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 1 kHz}
  flywheel: {kind: body, inertia: 40 kg*cm^2}
  outer: {kind: torque_sensor, stiffness: 3 kN*m/rad, damping: 0.5 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 1 kHz}
  rotor: {kind: body, inertia: 20 kg*cm^2, viscous: 0.01 N*m*s/rad}
"""
LOAD = "  load: {kind: replayed_torque, at: rotor, from: channel brake_Nm, factor: -1}\n"
DRIVE = "  drive: {kind: replayed_torque, at: motor, from: channel}\n"
TURNED = "  turned: {kind: imposed_motion, at: motor, from: channel motor_speed}\n"


def scenario(*lines: str) -> Scenario:
    return read_scenario(parse_document(SHAFT + "".join(lines), Path("shaft.yaml")), Catalog(), seed=1)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """A shaft that is sped up and braked by known torques, with its reading, its motion and both torques."""
    time = np.arange(int(0.6 * RATE)) / RATE
    torques = {
        "push": 2 + 0.5 * np.sin(2 * pi * 20 * time), "brake": 1.5 * (1 - np.exp(-time / 0.05)) * np.ones_like(time),
    }  # fmt: skip
    folder = tmp_path_factory.mktemp("recorded")
    given = {
        name: Channel(values=values, quantity="motor_torque" if name == "push" else "torque", unit="N*m", role="input")
        for name, values in torques.items()
    }
    write_recording(Recording(sample_rate=RATE, channels=given), folder / "given.parquet")
    text = SHAFT + (
        "  push: {kind: replayed_torque, at: motor, recording: given.parquet, channel: push}\n"
        "  brake: {kind: replayed_torque, at: rotor, recording: given.parquet, channel: brake, factor: -1}\n"
    )
    made = read_scenario(parse_document(text, folder / "shaft.yaml"), Catalog(), seed=1)
    run = simulate(made.rig, duration=0.6, seed=1, sample_rate=RATE, settling=0.0)
    speed = Channel(values=run.channels["true_motor_speed_rad_s"].values, quantity="motor_speed", unit="rad/s",
                    role="input", of="motor")  # fmt: skip
    kept = {name: one for name, one in run.channels.items() if not one.truth}
    channels = {**kept, "push_Nm": given["push"], "brake_Nm": given["brake"], "speed": speed}
    return replace(run, channels=channels, name="run1.csv")


def reading(made: Scenario, given: Recording, *, place: str = "outer") -> np.ndarray:
    run = tr.simulate(made, inputs=given, duration=0.5)
    assert run.sample_rate == given.sample_rate
    return run.channels[f"{place}_V"].in_si()


@pytest.mark.parametrize("place", ["outer", "inner"])
@pytest.mark.parametrize("lines", [(LOAD, DRIVE), (LOAD, TURNED)], ids=["both torques", "load and speed"])
def test_the_inputs_of_a_recording_give_its_reading(recorded: Recording, lines: tuple[str, ...], place: str) -> None:
    """What differs is how torque or speed runs between two samples."""
    found, seen = reading(scenario(*lines), recorded, place=place), recorded.channels[f"{place}_V"].in_si()[:2500]
    skipped = 50  # the first value is held while nothing has begun: 10 ms
    assert found[skipped:] == pytest.approx(seen[skipped:], abs=5e-3 * np.ptp(seen))


def test_the_written_inputs_drive_again(recorded: Recording, tmp_path: Path) -> None:
    made = scenario(LOAD, DRIVE)
    run = tr.simulate(made, inputs=recorded, duration=0.5, truth=False)
    assert {name for name, one in run.channels.items() if one.role == "input"} == {"push_Nm", "brake_Nm"}
    assert np.array_equal(run.channels["brake_Nm"].values, recorded.channels["brake_Nm"].values[:2500])
    write_recording(run, tmp_path / "again.parquet")
    again = tr.simulate(made, inputs=tmp_path / "again.parquet", truth=False)
    assert np.array_equal(again.channels["outer_V"].values, run.channels["outer_V"].values)


@pytest.mark.parametrize(
    ("line", "channel"),
    [
        ("from: channel current, torque_constant: 0.11 N*m/A", {"quantity": "current", "unit": "A", "by": 1 / 0.11}),
        ("from: channel amps, torque_constant: -0.11 N*m/A", None),
        ("from: channel amps", {"quantity": "motor_torque", "unit": "A", "by": 1 / 0.11, "si": 0.11}),
        ("from: channel amps", {"quantity": "motor_torque", "unit": "mV", "by": -200.0, "si": -1 / 200}),
    ],
    ids=["current", "a negative constant", "A with its constant", "mV, turned round"],
)
def test_an_input_in_any_unit_is_the_same(recorded: Recording, line: str, channel: dict[str, object] | None) -> None:
    text = DRIVE.replace("from: channel", line)
    if channel is None:
        with pytest.raises(InputError, match=r"rig\.drive\.torque_constant: .* must be more than 0"):
            scenario(LOAD, text)
        return
    values = recorded.channels["push_Nm"].values * channel["by"]
    scaled = Channel(values=values, quantity=str(channel["quantity"]), unit=str(channel["unit"]), role="input",
                     si_per_unit=float(str(channel.get("si", 1.0))))  # fmt: skip
    given = recorded.with_channel("amps", scaled)
    given = replace(given, channels={name: one for name, one in given.channels.items() if name != "push_Nm"})
    assert reading(scenario(LOAD, text), given) == pytest.approx(reading(scenario(LOAD, DRIVE), recorded), abs=1e-9)


def test_a_load_at_another_rate_is_resampled(recorded: Recording) -> None:
    """A fifth of the rate, for torques below 30 Hz: the same within 1 % of the reading's range."""
    slow = {name: replace(one, values=one.values[::5]) for name, one in recorded.channels.items()}
    given = replace(recorded, channels=slow, sample_rate=RATE / 5)
    made = scenario(LOAD, DRIVE)
    fine = reading(made, recorded)
    stated = read_scenario(
        parse_document(
            (SHAFT + LOAD + DRIVE).replace("settling: 0 s", "settling: 0 s, sample_rate: 5 kHz"), Path("s.yaml")
        ),
        Catalog(), seed=1,
    )  # fmt: skip
    found = tr.simulate(stated, inputs=given, duration=0.5)
    assert found.sample_rate == RATE
    assert found.channels["outer_V"].in_si() == pytest.approx(fine, abs=0.01 * np.ptp(fine))
    assert found.channels["brake_Nm"].values == pytest.approx(recorded.channels["brake_Nm"].values[:2500], abs=0.02)


def test_inputs_go_through_a_written_scenario() -> None:
    made = scenario(LOAD, DRIVE, TURNED)
    text = made.text()
    assert "from: channel brake_Nm" in text
    assert read_scenario(parse_document(text, Path("shaft.yaml")), Catalog(), seed=1).rig == made.rig


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("load: {kind: replayed_torque, at: rotor}", "neither recording: nor from: is stated; write recording: FILE"),
        ("load: {kind: replayed_torque, at: rotor, from: brake}", "from is 'brake'; write from: channel NAME"),
        ("load: {kind: replayed_torque, at: rotor, from: channel, recording: a.csv}", "both recording: and from:"),
        ("load: {kind: replayed_torque, at: rotor, from: channel a, channel: b}", "names the channel 'a', and channel"),
        ("load: {kind: replayed_torque, at: roter, from: channel a}", "no part 'roter'; did you mean"),
        ("load: {kind: quadratic_drag, at: rotor, coefficient: 1 N*m*s^2, from: channel a}", "rig.load.from"),
    ],
)
def test_a_source_that_contradicts_is_refused_with_its_line(line: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        scenario(f"  {line}\n")
    assert said in str(caught.value)
    assert str(caught.value).startswith("shaft.yaml:11: rig.load")


def test_without_a_recording_nothing_is_guessed() -> None:
    with pytest.raises(InputError, match=r"load takes a channel of each recording .* name one with --inputs RECORDING"):
        tr.simulate(scenario(LOAD), duration=0.1)
    with pytest.raises(InputError, match="turned takes a channel of each recording"):
        tr.simulate(scenario(TURNED), duration=0.1)


@pytest.mark.parametrize(
    ("lines", "changed", "said"),
    [
        ((LOAD,), {"brake_Nm": None}, "shaft.yaml:11: rig.load.from: run1.csv has no channel 'brake_Nm', the input"),
        ((DRIVE.replace("channel", "channel torque"),), {"brake_Nm": {"role": None}},
         "nothing states which of inner_V, brake_Nm is the input at 'motor'; write role: input, of: motor"),
        ((DRIVE.replace("channel", "channel outer_V"),), {"outer_V": {"role": "compared"}},
         "outer_V is compared with the model and cannot drive it"),
        ((DRIVE,), {"push_Nm": {"quantity": "force", "unit": "N"}}, "has no channel 'motor_torque', the input"),
        ((DRIVE.replace("channel", "channel push_Nm"),), {"push_Nm": {"quantity": "force", "unit": "N"}},
         "is a force, and 'motor' turns: it needs a torque"),
        ((DRIVE.replace("channel", "channel push_Nm"),), {"push_Nm": {"quantity": "current", "unit": "A"}},
         "is a current; add torque_constant:"),
    ],
)  # fmt: skip
def test_an_input_that_is_missing_or_not_stated_is_one_sentence(
    recorded: Recording, lines: tuple[str, ...], changed: dict[str, dict[str, object] | None], said: str
) -> None:
    channels = {
        name: replace(one, **(changed.get(name) or {}))  # type: ignore[arg-type]
        for name, one in recorded.channels.items() if changed.get(name, {}) is not None
    }  # fmt: skip
    with pytest.raises(TorquerigError) as caught:
        tr.simulate(scenario(*lines), inputs=replace(recorded, channels=channels), duration=0.1)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_scenario_without_inputs_takes_none(recorded: Recording) -> None:
    with pytest.raises(InputError, match=r"no part of the scenario takes a channel of run1\.csv"):
        tr.simulate(scenario(), inputs=recorded)


def test_an_input_of_no_part_is_refused(recorded: Recording) -> None:
    wrong = recorded.with_channel("brake_Nm", replace(recorded.channels["brake_Nm"], of="roter"))
    with pytest.raises(InputError, match=r"channels\.brake_Nm\.of: the scenario's rig has no part 'roter'"):
        tr.simulate(scenario(LOAD, DRIVE), inputs=wrong, duration=0.1)


def test_of_chooses_among_several_inputs(recorded: Recording) -> None:
    first = replace(recorded.channels["brake_Nm"], of="rotor")
    two = recorded.with_channel("brake_Nm", first).with_channel("other", replace(first, of="flywheel"))
    assert input_channel(two, "torque", at="rotor") == "brake_Nm"
    assert input_channel(two, "torque", at="flywheel") == "other"
    assert driven_by(recorded).run != driven_by(recorded).run  # each recording drives its own simulation
    assert driven_by(recorded).run.inputs is not None


def test_check_shows_the_inputs_of_every_recording(recorded: Recording, tmp_path: Path) -> None:
    """The second recording has no brake: the scenario's line and the recording are named."""
    made = scenario(LOAD, "  servo: {kind: torque_controller, motor: motor, from: channel push_Nm}\n")
    write_recording(recorded, tmp_path / "run1.csv")
    less = {name: one for name, one in recorded.channels.items() if name != "brake_Nm"}
    write_recording(replace(recorded, channels=less), tmp_path / "run2.csv")
    one, two = (read_recording(tmp_path / name) for name in ("run1.csv", "run2.csv"))
    shown = " ".join(run_check(made, [one]).text().split())
    assert "run1.csv: input: brake_Nm drives load (replayed_torque)" in shown
    assert "run1.csv: input: push_Nm drives servo (torque_controller)" in shown
    assert "run1.csv: compared: outer_V of outer; context: inner_V of inner" in shown
    with pytest.raises(
        InputError, match=r"shaft.yaml:11: rig.load.from: run2.csv has no channel 'brake_Nm', the input at 'rotor'"
    ):
        run_check(made, [one, two])


@pytest.mark.parametrize(("stated", "smoothing"), [("", 0.5), (", smoothing: 0.01 rad/s", 0.01)])
def test_a_slow_motor_has_its_dry_friction_above_the_stated_smoothing(stated: str, smoothing: float) -> None:
    speed = np.full(400, 0.1)
    turned = Recording(sample_rate=100, channels={"w": Channel(values=speed, quantity="motor_speed", unit="rad/s")})
    text = f"""
operating_point: {{}}
recording: {{sample_rate: 100 Hz, settling: 0 s}}
measured: motion
rig:
  motor: {{kind: motor, inertia: 2 kg*cm^2, torque_limit: 1 N*m, coulomb: 2 mN*m{stated}}}
  motion: {{kind: imposed_motion, at: motor, from: channel motor_speed}}
"""
    made = read_scenario(parse_document(text, Path("slow.yaml")), Catalog(), seed=1)
    hidden: AbstractContextManager[object] = (
        nullcontext() if stated else pytest.warns(UserWarning, match="its sign is smoothed over 0.5 rad/s")
    )
    with hidden:
        torque = tr.simulate(made, inputs=turned).torque()
    assert torque[100:] == pytest.approx(2e-3 * np.tanh(0.1 / smoothing), rel=1e-6)


@pytest.mark.parametrize("role", ["compared", "context"])
def test_a_channel_of_the_quantity_with_another_role_is_named(role: str) -> None:
    given = Recording(
        sample_rate=RATE, channels={"flange": Channel(values=np.ones(4), quantity="torque", unit="N*m", role=role)}
    )
    with pytest.raises(
        TorquerigError, match=f"no torque that is an input at 'rotor': flange is {role}; write role: in"
    ):
        input_channel(given, "torque", at="rotor")
