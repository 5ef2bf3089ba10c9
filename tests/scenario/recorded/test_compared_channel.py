"""Which column is which sensor: by ``of:``, never the first one silently; scale, zero and sense of the sensor."""

from __future__ import annotations

from dataclasses import replace
from math import inf, sqrt
from pathlib import Path

import numpy as np
import pytest

from tests.scenario.test_measured_places import RIG, scenario
from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.recorded.compared_channel import (
    as_measured,
    what_is_compared,
    with_sensor_errors,
    without_sensor_errors,
)
from torquerig.scenario.recorded.sensor_priors import sensor_priors
from torquerig.simulation.simulator import simulate

VALUES = np.arange(5.0)


def recording(**channels: Channel) -> Recording:
    return Recording(sample_rate=1000.0, channels=channels, name="run.csv")


def torque(of: str | None = None, role: str | None = None, **more: object) -> Channel:
    return Channel(values=VALUES, quantity="torque", unit="V", of=of, role=role, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("measured", "channels", "taken"),
    [
        ("outer", {"a": torque("inner"), "b": torque("outer")}, "b"),
        ("inner", {"a": torque("inner"), "b": torque("outer", "compared")}, "a"),
        ("[outer, inner]", {"a": torque("inner"), "b": torque("outer")}, "b"),
        ("[inner, outer]", {"a": torque("inner"), "b": torque("outer")}, "a"),
        ("outer", {"a": torque()}, "a"),
        ("outer", {"a": torque(role="input"), "b": torque()}, "b"),
        ("outer", {"a": torque(), "b": torque(role="compared")}, "b"),
        ("[outer, inner]", {"a": torque(), "b": torque(role="compared")}, "b"),
        ("outer", {"a": torque("inner"), "b": torque()}, "b"),
    ],
)
def test_of_says_which_column_is_compared(measured: str, channels: dict[str, Channel], taken: str) -> None:
    rig = scenario(measured).rig
    (read,) = as_measured([recording(**channels)], rig)
    assert read.torque_name() == taken
    others = [one.role for name, one in read.channels.items() if name != taken]
    assert set(others) <= {"context", "input"}
    if len(channels) > 1 and "input" not in others:
        assert f"compared: {taken} of {rig.measured}; context: " in str(what_is_compared(read, rig))


@pytest.mark.parametrize(
    ("measured", "channels", "said"),
    [
        ("outer", {"a": torque(), "b": torque()}, r"nothing states whether a or b is .* at 'outer'; write of: outer"),
        ("[outer, inner]", {"a": torque()}, r"nothing states whether a is what the scenario measures at 'outer'"),
        ("outer", {"a": torque("inner")}, r"measures 'outer' first, and the recording has a of inner; write measured"),
        ("outer", {"a": torque("oter")}, r"run.csv: channels.a.of: the scenario's rig has no part 'oter'; did you"),
        ("outer", {"a": torque("outer"), "b": torque("outer")}, r"nothing states whether a or b is"),
    ],
)
def test_a_column_that_is_not_stated_is_refused(measured: str, channels: dict[str, Channel], said: str) -> None:
    with pytest.raises(InputError, match=said):
        as_measured([recording(**channels)], scenario(measured).rig)


def test_the_sentence_names_the_line_of_the_sidecar(tmp_path: Path) -> None:
    write_recording(recording(a=torque("oter")), tmp_path / "run.csv")
    with pytest.raises(InputError, match=r"run\.yaml:7: channels\.a\.of: the scenario's rig has no part 'oter'"):
        as_measured([read_recording(tmp_path / "run.csv")], scenario("outer").rig)


def test_what_is_known_of_a_sensor_is_its_prior() -> None:
    inner, outer, tacho = sensor_priors(scenario("[inner, outer, tacho]"))
    assert (inner.sign, inner.scale_sd, inner.zero, inner.zero_sd) == (-1.0, 0.01, pytest.approx(0.02), inf)
    assert (outer.sign, outer.scale_sd, outer.zero_sd, outer.tare) == (1.0, pytest.approx(0.002 / sqrt(3)), 0.0, True)
    assert (tacho.zero, tacho.zero_sd) == (pytest.approx(0.1), inf)
    tared = sensor_priors(scenario("[inner, outer]"), [recording(a=torque("inner", tare=True))])
    assert tared[0].zero_sd == 0.0
    assert "mounted the other way round" in inner.sentence()


def test_the_stated_errors_of_a_sensor_are_taken_off_and_written_again() -> None:
    """The corrected reading is that of an ideal sensor, whichever way the sensor and its scale are turned."""
    text = RIG.replace("{{value: 1, rel_sd: 0.01}}", "1.02")
    made = scenario("inner", text)
    off = simulate(made.rig, duration=0.1, seed=2, sample_rate=5000.0)
    ideal = without_sensor_errors(made.rig)
    plain = simulate(ideal, duration=0.1, seed=2, sample_rate=5000.0)
    step = 20 / 2**16  # of the converter, [V]
    (read,) = as_measured([off], made.rig)
    assert read.torque() == pytest.approx(plain.torque(), abs=step)
    name = off.torque_name()
    positive = replace(off.channels[name], si_per_unit=abs(off.channels[name].si_per_unit))  # as a data sheet has it
    (again,) = as_measured([off.with_channel(name, positive)], made.rig)
    assert np.array_equal(again.torque(), read.torque())
    assert with_sensor_errors(ideal, made.rig) == made.rig


def test_check_lists_what_is_compared_and_what_is_known_of_the_sensors() -> None:
    made = scenario("[outer, inner]")
    run = simulate(made.rig, duration=1.0, seed=2, sample_rate=5000.0).without_truth()
    shown = " ".join(run_check(made, [run]).text().split())
    assert "compared: outer_V of outer; context: inner_V of inner" in shown
    assert "sensor inner: scale 1 +- 0.01, zero free, mounted the other way round" in shown
    other = read_scenario(parse_document(RIG.format(measured="[inner, outer]"), Path("rig.yaml")), Catalog(), seed=1)
    assert "compared: inner_V of inner; context: outer_V of outer" in " ".join(run_check(other, [run]).text().split())
