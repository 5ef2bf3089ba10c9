"""Rigs whose motion was measured, made by equations of the test and diagnosed by the likelihood of their samples."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.moved_rigs import CARRIAGE, ROTOR, recorded, scenario
from torquerig.errors import InputError, RecordingError
from torquerig.inference.motion.answer import as_json
from torquerig.inference.motion.engine import MotionOutcome, diagnose_motion
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]
Extra = Callable[[Floats, Floats, Floats], Floats]


def nothing(time: Floats, position: Floats, speed: Floats) -> Floats:
    return np.zeros(time.size)


def friction(time: Floats, position: Floats, speed: Floats) -> Floats:
    return np.where(speed > 0, 6.0 + 8.0 * speed, -9.0 + 20.0 * speed)


def ripple(time: Floats, position: Floats, speed: Floats) -> Floats:
    return 1.0 * np.cos(2 * np.pi * 150.0 * position + 0.4)


def tone(time: Floats, position: Floats, speed: Floats) -> Floats:
    return 1.0 * np.cos(2 * np.pi * 23.0 * time)


def both(time: Floats, position: Floats, speed: Floats) -> Floats:
    return friction(time, position, speed) + ripple(time, position, speed)


@cache
def carriage(extra: Extra) -> MotionOutcome:
    return diagnose_motion(scenario(CARRIAGE), [recorded(extra)])


@pytest.fixture(scope="module")
def diagnosed() -> Callable[[Extra], MotionOutcome]:
    return carriage


def rotor(sizes: dict[int, float]) -> Recording:
    """A slow turn to and fro at 200 Hz: cosines of the angle, noise of 3 mN m, friction none."""
    time = np.arange(6000) / 200.0
    angle = 4.0 * np.sin(2 * np.pi * time / 20.0)
    effort = sum(size * np.cos(order * angle + order) for order, size in sizes.items())
    noise = 0.003 * np.random.default_rng(3).standard_normal(time.size)
    channels = {
        "torque_Nm": Channel(values=np.asarray(effort + noise), quantity="motor_torque", unit="N*m"),
        "angle_rad": Channel(values=angle, quantity="angle", unit="rad"),
    }
    return Recording(sample_rate=200.0, channels=channels, name="turn.csv")


def test_a_wrong_mass_is_no_missing_physics(diagnosed: Callable[[Extra], MotionOutcome]) -> None:
    outcome = diagnosed(nothing)
    data = as_json(outcome)
    assert (data["verdict"], data["findings"], data["unnamed"]) == ("adequate", [], [])
    assert outcome.completed.part("carriage").mass == pytest.approx(10.0, rel=5e-3)  # type: ignore[attr-defined]
    assert data["fit"]["after"]["heldout_misfit"] < 0.2 * data["fit"]["before"]["nominal"]


@pytest.mark.long
def test_friction_by_direction_is_named_with_its_numbers(diagnosed: Callable[[Extra], MotionOutcome]) -> None:
    data = as_json(diagnosed(friction))
    (finding,) = data["findings"]
    assert (data["verdict"], finding["mechanism"], finding["variant"]) == (
        "missing_physics", "stribeck_friction", "by_direction",
    )  # fmt: skip
    found = {name: each["value"] for name, each in finding["parameters"].items()}
    assert found["coulomb_Nm_forward"] == pytest.approx(6.0, rel=0.05)
    assert found["coulomb_Nm_backward"] == pytest.approx(9.0, rel=0.05)
    assert found["viscous_Nms_forward"] == pytest.approx(8.0, rel=0.2)
    assert found["viscous_Nms_backward"] == pytest.approx(20.0, rel=0.15)
    assert data["fit"]["improvement"]["ci95"][0] > 0.6


@pytest.mark.long
@pytest.mark.parametrize(
    ("extra", "kind", "axis", "at"), [(ripple, "line_family", "cycles/m", 150.0), (tone, "tone", "Hz", 23.0)]
)
def test_a_line_without_a_name_is_located(
    diagnosed: Callable[[Extra], MotionOutcome], extra: Extra, kind: str, axis: str, at: float
) -> None:
    data = as_json(diagnosed(extra))
    assert data["findings"] == []
    line = max(data["unnamed"], key=lambda one: one["size"]["value"])
    assert (line["kind"], line["axis"]) == (kind, axis)
    assert line["at"] == pytest.approx(at, rel=3e-3)
    assert line["size"]["value"] == pytest.approx(1.0, rel=0.1)


@pytest.mark.long
def test_friction_is_named_next_to_a_line_without_a_name(diagnosed: Callable[[Extra], MotionOutcome]) -> None:
    data = as_json(diagnosed(both))
    assert [one["mechanism"] for one in data["findings"]] == ["stribeck_friction"]
    assert [one["at"] for one in data["unnamed"]] == [pytest.approx(150.0, rel=3e-3)]


@pytest.mark.long
def test_cogging_is_named_and_a_foreign_order_is_not() -> None:
    outcome = diagnose_motion(scenario(ROTOR), [rotor({84: 0.02, 12: 0.03, 28: 0.04, 7: 0.05})])
    data = as_json(outcome)
    assert [one["mechanism"] for one in data["findings"]] == ["cogging"]
    amplitudes = outcome.completed.of_kind("cogging")[0].amplitudes()
    assert {order: amplitudes[order] for order in (12, 28, 84)} == {
        12: pytest.approx(0.03, rel=0.05), 28: pytest.approx(0.04, rel=0.05), 84: pytest.approx(0.02, rel=0.05),
    }  # fmt: skip
    (line,) = (one for one in data["unnamed"] if not one["minor"])
    assert (line["axis"], line["at"]) == ("motor_shaft", 7.0)
    assert data["verdict"] == "unexplained"


def test_recordings_are_refused_with_a_reason() -> None:
    one = recorded(nothing)
    with pytest.raises(InputError, match=r"no recording has this name; choose among run\.csv"):
        diagnose_motion(scenario(CARRIAGE), [one], held_out_runs=["other.csv"])
    with pytest.raises(InputError, match="names every recording"):
        diagnose_motion(scenario(CARRIAGE), [one], held_out_runs=["run.csv"])
    short = Recording(
        sample_rate=one.sample_rate, name=one.name,
        channels={name: Channel(values=each.values[:300], quantity=each.quantity, unit=each.unit)
                  for name, each in one.channels.items()},
    )  # fmt: skip
    with pytest.raises(RecordingError, match="300 samples of motion are too few"):
        diagnose_motion(scenario(CARRIAGE), [short])
