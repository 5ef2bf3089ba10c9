"""The same rig in other units of torque and time gives the same recording, lines and filtered signal."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import yaml

import torquerig as tr
from tests.scaled_rigs import Scale, scaled_rig
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.filters.chains.chain_file import read_chains
from torquerig.filters.evaluation.load_scale import LoadScale
from torquerig.metrics.filter_evaluation import FilterEvaluation, evaluate_filter
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Recording
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.load_response import load_response
from torquerig.simulation.simulator import simulate

SCALES = [(0.01, 1.0), (100.0, 1.0), (1.0, 0.2), (1.0, 4.0), (100.0, 0.2)]
SCENARIOS = ["wear_rig.yaml", "two_stage_branch.yaml"]
DURATION, SETTLING = 4.0, 0.3  # [s] of the original


@cache
def run(scenario: str, torque: float, speed: float) -> Recording:
    made = tr.read_scenario(shipped_scenarios() / scenario)
    rig = scaled_rig(made.rig, Scale(torque, speed))
    return simulate(
        rig, duration=DURATION / speed, seed=3, sample_rate=5000.0 * speed, wander=2e-4, settling=SETTLING / speed
    )


def close(found: np.ndarray, expected: np.ndarray) -> bool:
    return bool(np.abs(found - expected).max() <= 1e-6 * max(float(np.abs(expected).max()), 1e-300))


@pytest.mark.parametrize("scenario", SCENARIOS)
@pytest.mark.parametrize(("torque", "speed"), SCALES)
def test_simulated_channels_scale(scenario: str, torque: float, speed: float) -> None:
    plain, twin, scale = run(scenario, 1.0, 1.0), run(scenario, torque, speed), Scale(torque, speed)
    assert twin.channels.keys() == plain.channels.keys()
    for name, channel in plain.channels.items():
        unit = "1" if channel.unit == "count" else channel.unit
        assert close(twin.channels[name].values, channel.values * scale.of(unit)), name


@pytest.mark.parametrize(("torque", "speed"), SCALES)
def test_lines_have_the_same_orders_and_causes(torque: float, speed: float) -> None:
    plain, twin = (
        tr.order_lines(run("wear_rig.yaml", *scale), mains=50.0 * scale[1]) for scale in ((1.0, 1.0), (torque, speed))
    )
    assert len(twin.lines) == len(plain.lines) >= 5
    for one, other in zip(plain.lines, twin.lines, strict=True):
        assert (other.axis, other.detected_over, other.label) == (one.axis, one.detected_over, one.label)
        frequency = speed if one.detected_over == "frequency" else 1.0
        assert other.place == pytest.approx(one.place * frequency, rel=1e-6)
        assert other.amplitude == pytest.approx(one.amplitude * torque, rel=1e-6)
        assert other.above_dB == pytest.approx(one.above_dB, abs=1e-5)


@pytest.mark.parametrize("chain", ["report_filter_code", "order_lines", "order_lines_low_pass"])
@pytest.mark.parametrize(("torque", "speed"), SCALES)
def test_filtered_signals_scale(chain: str, torque: float, speed: float, tmp_path: Path) -> None:
    plain = tr.filter(run("wear_rig.yaml", 1.0, 1.0), chain, filters=scaled_filters(tmp_path / "plain.yaml", 1.0))
    twin = tr.filter(run("wear_rig.yaml", torque, speed), chain, filters=scaled_filters(tmp_path / "twin.yaml", speed))
    assert close(twin.torque(), plain.torque() * torque)
    assert not close(plain.torque(), run("wear_rig.yaml", 1.0, 1.0).torque())


@pytest.mark.parametrize(("torque", "speed"), SCALES)
def test_the_lines_give_the_same_relative_speed_without_an_encoder(torque: float, speed: float) -> None:
    """The priors of the acceleration and of hum are in seconds, so that other speeds agree within their intervals."""
    lines = kinematics_of(tr.read_scenario(shipped_scenarios() / "wear_rig.yaml").rig).lines()
    plain, twin = (best_motor_angle(without_angle(run("wear_rig.yaml", *scale)), lines, ratio=5.0)
                   for scale in ((1.0, 1.0), (torque, speed)))  # fmt: skip
    allowed = 1e-9 if speed == 1 else plain.half_width + twin.half_width
    assert twin.values[-1] - twin.values[0] == pytest.approx(plain.values[-1] - plain.values[0], rel=allowed)


def without_angle(recording: Recording) -> Recording:
    torque = {name: one for name, one in recording.channels.items() if one.quantity == "torque" and not one.truth}
    return replace(recording, channels=torque)


def scaled_filters(path: Path, speed: float) -> Path:
    """Write the shipped filters with their times and frequencies scaled."""
    data = yaml.safe_load((shipped_scenarios() / "filters.yaml").read_text(encoding="utf-8"))

    def scaled(one: object) -> object:
        if isinstance(one, dict):
            return {key: scaled(inner) for key, inner in one.items()}
        if isinstance(one, list):
            return [scaled(inner) for inner in one]
        if isinstance(one, str) and one.endswith((" Hz", " s")):
            number, unit = one.split()
            return f"{float(number) * (speed if unit == 'Hz' else 1 / speed)!r} {unit}"
        return one

    path.write_text(yaml.safe_dump(scaled(data)), encoding="utf-8")
    return path


@pytest.mark.parametrize(("torque", "speed"), SCALES)
def test_evaluations_scale_with_the_stated_hit_decay_and_bands(torque: float, speed: float, tmp_path: Path) -> None:
    drive = kinematics_of(tr.read_scenario(shipped_scenarios() / "wear_rig.yaml").rig)
    plain, twin = (evaluated(drive, *scale, folder=tmp_path) for scale in ((1.0, 1.0), (torque, speed)))
    assert compared(twin) == pytest.approx(compared(plain, torque=torque, speed=speed), rel=1e-6)


def compared(made: FilterEvaluation, *, torque: float = 1.0, speed: float = 1.0) -> list[float]:
    """Return the numbers of an evaluation, scaled as stated."""
    found: list[float] = []
    for error in (made.error_before, made.error_after):
        assert error is not None
        assert error.hits is not None
        assert error.delay is not None
        found += [torque * one for one in (error.rms, *error.in_band, *error.load_in_band, error.hits.height)]
        found += [one / speed for one in (error.hits.rise, error.delay.seconds)]
        found += [error.hits.count, error.hits.peak, error.delay.correlation]
    assert made.step is not None
    assert made.placebo is not None
    return [*found, made.step.hit_peak, made.step.overshoot, made.step.rise / speed, *made.placebo.cuts]


def evaluated(drive: Kinematics, torque: float, speed: float, *, folder: Path) -> FilterEvaluation:
    chain = read_chains(scaled_filters(folder / f"{speed}.yaml", speed), kinematics=drive)["order_lines_low_pass"]
    scale = LoadScale(4e-3 / speed, tuple(edge * speed for edge in LoadScale().edges))
    return evaluate_filter(chain, run("wear_rig.yaml", torque, speed), ratio=5.0, known=drive.lines(30), scale=scale)


@pytest.mark.parametrize(("torque", "speed"), [(0.01, 1.0), (100.0, 4.0)])
def test_the_load_inverse_scales(torque: float, speed: float, tmp_path: Path) -> None:
    plain, twin = (inverted(*scale, folder=tmp_path) for scale in ((1.0, 1.0), (torque, speed)))
    # the fit of the spectra ends within 1e-3 of the logarithm of each number
    assert np.std(twin / torque - plain) < 1e-2 * np.std(plain)


def inverted(torque: float, speed: float, *, folder: Path) -> np.ndarray:
    rig = scaled_rig(tr.read_scenario(shipped_scenarios() / "wear_rig.yaml").rig, Scale(torque, speed))
    filters = folder / f"{torque}_{speed}.yaml"
    filters.write_text(f"filters: {{inverse: [{{type: load_inverse, lowest: {20 * speed} Hz}}]}}", encoding="utf-8")
    response = load_response(rig, rate=5000.0 * speed)
    chain = read_chains(filters, kinematics=kinematics_of(rig), response=response)["inverse"]
    return chain.apply(run("wear_rig.yaml", torque, speed)).torque()
