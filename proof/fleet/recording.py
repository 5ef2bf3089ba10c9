"""One run of a rig: integrate, measure, and write table and sidecar."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from numpy.typing import NDArray

from proof.fleet.chain import converted, encoder_counts, low_passed, noise, tacho_volts
from proof.fleet.courses import courses_of
from proof.fleet.effect import Effect, Motion
from proof.fleet.kernel import run_train
from proof.fleet.plans import Run
from proof.fleet.rig import FleetRig
from proof.fleet.scale import RPM
from proof.fleet.settling import settling_time, start_state, substeps_of
from proof.fleet.train import Train, frames_per_sample, train_of

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Recorded:
    """One recording: torque [V], motor angle as read [rad], and the mean sensed torque [N m] for the answer."""

    volts: Floats
    motor_angle: Floats
    mean_torque: float


def train_with(rig: FleetRig, effects: Sequence[Effect]) -> Train:
    """Return the rig's train with these effects; the phases of its stated lines never change."""
    train = train_of(rig.design, rig.truth, rig.laws, np.random.default_rng([*rig.seed, 7]))
    for effect in effects:
        train = effect.on_train(train)
    return train


def move(rig: FleetRig, run: Run, number: int, effects: Sequence[Effect], *, redraw: int = 0) -> Motion:
    """Integrate one run; ``redraw`` above 0 draws load, wander and noise anew."""
    rate = rig.design.sample_rate * frames_per_sample(rig.design.sample_rate)
    plain = train_with(rig, ())
    train = train_with(rig, effects)
    settling = round(settling_time(plain) * rig.design.sample_rate) / rig.design.sample_rate
    seed = [*rig.seed, number, redraw]
    courses = courses_of(
        rig.design, rig.truth, rig.laws, run, frame_rate=rate, settling=settling, seed=seed,
        speed_error=rig.speed_error, wander=rig.wander,
    )  # fmt: skip
    # turbulence that does not follow the momentary speed keeps the torque that it has at the set-point
    speed = run.speed / abs(rig.design.ratio)
    fixed = 0.0 if train.swirl_follows else train.drag * speed**2
    train = train._replace(swirl_torque=fixed)
    # one step for all effects, so that the step itself makes no difference between them
    steps = substeps_of(train_with(rig, rig.effects), rate)

    def run_with(inputs: Any) -> Motion:
        out = run_train(train, start_state(train, inputs), inputs.arrays(), steps, rate)
        time = np.arange(out.shape[0]) / rate - settling
        return Motion(time, out[:, 0], out[:, 1], out[:, 2], out[:, 3], rate, run.duration)

    motion = run_with(courses)
    streams = [(effect, np.random.default_rng([*seed, 50 + i])) for i, effect in enumerate(rig.effects)]
    pushed = [effect.pushes(motion, rng) for effect, rng in streams if effect in effects]
    if any(pushed):
        for push in pushed:
            courses = courses.with_pushes(push)
        motion = run_with(courses)
    return motion


def measure(
    rig: FleetRig, run: Run, number: int, motion: Motion, effects: Sequence[Effect], *, redraw: int = 0
) -> Recorded:
    """Return what the file holds: the sensed torque through sensor, cable and converter."""
    design, truth = rig.design, rig.truth
    sensor = truth[design.sensor]
    seed = [*rig.seed, number, redraw]
    every = round(motion.rate / design.sample_rate)
    first = int(np.searchsorted(motion.time, -0.5 / motion.rate))
    samples = round(run.duration * design.sample_rate)
    torque, bandwidth = motion.torque, float(sensor["bandwidth"].split()[0])
    present = [(i, effect) for i, effect in enumerate(rig.effects) if effect in effects]
    for i, effect in present:
        torque = effect.on_torque(torque, motion, np.random.default_rng([*seed, 100 + i]))
        bandwidth = effect.on_bandwidth(bandwidth)
    torque = low_passed((1.0 + rig.gain_error) * torque + rig.zero, bandwidth, motion.rate)
    volts = torque[first::every][:samples] * float(sensor["sensitivity"].split()[0])
    time = np.arange(samples) / design.sample_rate
    volts = volts + noise(
        np.random.default_rng([*seed, 3]), samples, rms=sensor["noise_rms"], colour=rig.laws.noise_colour
    )
    angle = motion.motor_angle[first::every][:samples] + rig.angle_zero
    for i, effect in present:
        rng = np.random.default_rng([*seed, 200 + i])
        volts = effect.on_volts(volts, time, rng)
        angle = effect.on_angle(angle, time, rng)
    volts = converted(volts, full=float(sensor["converter_range"].split()[0]), bits=sensor["converter_bits"])
    for i, effect in present:
        volts = effect.on_codes(volts, time, np.random.default_rng([*seed, 300 + i]))
    return Recorded(volts, angle, float(np.mean(motion.torque[first:])))


def record(rig: FleetRig, number: int, *, effects: Sequence[Effect] | None = None, redraw: int = 0) -> Recorded:
    """Return run ``number`` of a rig with its effects, or with the given ones of them."""
    present = rig.effects if effects is None else effects
    run = rig.runs[number]
    return measure(rig, run, number, move(rig, run, number, present, redraw=redraw), present, redraw=redraw)


def write_recordings(rig: FleetRig, folder: Path) -> None:
    """Write the scenario and every run with its sidecar into a folder."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    folder.mkdir(parents=True, exist_ok=True)
    text = yaml.safe_dump(rig.scenario(), sort_keys=False, width=160)
    (folder / "scenario.yaml").write_text(text, encoding="utf-8")
    for number in range(len(rig.runs)):
        one = record(rig, number)
        columns: dict[str, Any] = {"torque_V": pa.array(one.volts.astype(np.float32))}
        if rig.design.angle == "encoder":
            columns["encoder_count"] = pa.array(encoder_counts(one.motor_angle, rig.design.angle_counts))
        if rig.design.angle == "tacho":
            columns["tacho_V"] = pa.array(tacho_volts(one.motor_angle, rig.design.angle_counts).astype(np.float32))
        path = folder / f"run{number + 1}.parquet"
        pq.write_table(pa.table(columns), path)
        text = yaml.safe_dump(sidecar(rig, rig.runs[number]), sort_keys=False)
        path.with_suffix(".yaml").write_text(text, encoding="utf-8")


def sidecar(rig: FleetRig, run: Run) -> dict[str, Any]:
    """Return the test conditions of a run: channels and set-points, no true values."""
    design = rig.design
    per_volt = 1.0 / float(design.parts[design.sensor]["sensitivity"].split()[0])
    channels: dict[str, Any] = {"torque_V": {"quantity": "torque", "unit": "V", "Nm_per_V": float(f"{per_volt:.9g}")}}
    facts: dict[str, Any] = {
        "motor": design.motor, "gear_ratio": float(f"{abs(design.ratio):.9g}"),
        "speed_rpm": float(f"{np.sign(design.ratio) * run.speed / RPM:.6g}"), "profile": run.profile,
        "occupancy_percent": run.occupancy,
    }  # fmt: skip
    if design.angle == "encoder":
        channels["encoder_count"] = {
            "quantity": "motor_angle", "unit": "count", "counts_per_rev": design.angle_counts,
        }  # fmt: skip
    if design.angle == "tacho":
        channels["tacho_V"] = {"quantity": "tacho", "unit": "V"}
        facts["tacho_pulses_per_motor_turn"] = design.angle_counts
    rate = design.sample_rate
    return {"sample_rate_Hz": int(rate) if rate == int(rate) else rate, "channels": channels, "run": facts}
