"""Exact simulation of a rig that is linear at its operating point, thousands of times faster than real time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, SimulationError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load
from torquerig.simulation import kernel
from torquerig.simulation.inputs import Span, filled
from torquerig.simulation.linear_start import LinearPath, prepared, wanted_speed
from torquerig.simulation.lower import Lowered
from torquerig.simulation.measured_places import Output
from torquerig.simulation.outputs import outputs_of
from torquerig.simulation.sampling import SAMPLE_RATE, SETTLING
from torquerig.simulation.simulator import recorded
from torquerig.simulation.twin.blocks import lifted, run
from torquerig.simulation.twin.friction_slope import sliding
from torquerig.simulation.twin.operating_point import HALF_WAVE_SQUARED_MEAN, mean_torques
from torquerig.simulation.twin.plant import load_input
from torquerig.simulation.twin.system import LinearSystem

Floats = NDArray[np.float64]


def simulate_linear(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, scenario: str = "",
) -> Recording:  # fmt: skip
    """Return what ``simulate`` returns, by exact discretisation of the rig linearised about its operating point.

    Springs, dampers, viscous friction, lines at constant speed, sampled loads, the sampled speed loop and the current
    lag are exact. Dry friction and drag enter by value and slope at the steady speed, losses of gears by the direction
    in which power flows there, gaps as closed; ``origin["linear_about"]`` and ``origin["left_out"]`` say so.
    A loop without integrator leaves the lines the phase that starting up gave them, and a lossy gear starts up less
    than linearly; with an integrator the phase is right too. The parameters are those of ``simulate``.

    Raises
    ------
    InputError
        For a profile other than steady, dry friction or an opposing load on a shaft that stands, or a gap that nothing
        holds closed.
    SimulationError
        Where the run left what it was linear about: a gap opened, or the motor met its torque limit; names the time.
    """
    samples, unkept = round(duration * sample_rate), round(settling * sample_rate)
    if samples < 2:
        raise InputError(f"a recording of {duration:g} s at {sample_rate:g} Hz has {samples} samples; ask for more")
    path = prepared(rig, seed, rate=sample_rate)
    lowered, system = path.lowered, path.system
    if unkept and not lowered.drive_terms:
        raise InputError("nothing holds the speed while the rig settles; ask for a settling of 0, or use simulate")
    span = Span(settling=unkept, samples=samples, rate=sample_rate, seed=seed, wander=wander)
    inputs = _inputs(path, rig, span)
    moving = [row for row in range(len(system.inputs)) if row in inputs]
    step = lifted(system.only(inputs=[system.inputs[row] for row in moving]), path.lines)
    start = path.start - _moved(system, {row: float(inputs[row][0]) for row in moving})
    listed = outputs_of(rig, lowered)
    rows = [system.output(_named(output, lowered)) for output in listed]
    watched = _watched(path)
    values, finite = run(
        step, path.lines, period=1 / sample_rate, start=start, skipped=unkept, outputs=[*rows, *watched],
        inputs=np.array([inputs[row] for row in moving]).reshape(len(moving), unkept + samples),
    )  # fmt: skip
    if not finite:
        raise SimulationError("the linear rig grows without bound: its speed loop is unstable; lower kp")
    times = (unkept + np.arange(samples)) / sample_rate
    for row, output in enumerate(listed):
        values[row] += _steady(path, output, times)
    _check(path, values[len(listed) :], rate=sample_rate)
    about = f"{path.point.speeds[lowered.node(lowered.leader())]:.6g} rad/s"
    origin = {"scenario": scenario, "seed": seed, "linear_about": about, "left_out": list(path.point.left_out)}
    return recorded(rig, listed, values[: len(listed)], rate=sample_rate, origin=origin)


def _inputs(path: LinearPath, rig: Rig, span: Span) -> dict[int, Floats]:
    """Return the deviations of set-point and loads at every sample, by input; without those that are always 0."""
    lowered, system, count = path.lowered, path.system, span.settling + span.samples
    terms, means = filled(rig, lowered, span), mean_torques(lowered)
    found = {
        system.input(load_input(lowered, row)): terms.loads.samples[row, :count] - means[row]
        for row in range(means.size)
    }
    for row, name in enumerate(lowered.drive_names):
        found[system.input(f"set-point of {name}")] = terms.drives.reference[row, :count] - wanted_speed(
            lowered, path.point
        )
    return {at: values for at, values in found.items() if values.any()}


def _moved(system: LinearSystem, first: dict[int, float]) -> Floats:
    """Return by how much the sampled states are moved at the start (``sampled``): all of them are outputs as well."""
    moved = np.zeros(len(system.states))
    for row, state in enumerate(system.states):
        if state in system.outputs:
            moved[row] = sum(system.D[system.output(state), at] * value for at, value in first.items())
    return moved


_NAMED: dict[int, Callable[[Lowered, int], str]] = {
    kernel.SPRING_TORQUE: lambda lowered, row: f"torque in {lowered.spring_names[row]}",
    kernel.SPEED: lambda lowered, row: f"speed of {lowered.nodes[row]}",
    kernel.ANGLE: lambda lowered, row: f"angle of {lowered.nodes[row]}",
    kernel.DRIVE_TORQUE: lambda lowered, row: f"torque of {lowered.drive_names[row]}",
    kernel.OPPOSING_TORQUE: lambda lowered, row: f"opposing torque on {lowered.nodes[row]}",
}


def _named(output: Output, lowered: Lowered) -> str:
    """Return the linear model's name of the kernel's ``output``."""
    if output.kind not in _NAMED:
        raise InputError(f"{output.name}: the linear path has no such output; use simulate")
    return _NAMED[output.kind](lowered, output.row)


def _steady(path: LinearPath, output: Output, times: Floats) -> Floats | float:
    """Return the operating point's share of an output."""
    point, row = path.point, output.row
    if output.kind == kernel.SPRING_TORQUE:
        return float(point.spring_torques[row])
    if output.kind == kernel.SPEED:
        return float(point.speeds[row])
    if output.kind == kernel.ANGLE:
        return np.asarray(point.speeds[row] * times + path.angles[row])
    return point.drive_torque if output.kind == kernel.DRIVE_TORQUE else _steady_opposing(path, row)


def _steady_opposing(path: LinearPath, node: int) -> float:
    lowered, point = path.lowered, path.point
    total = float(point.friction_torques[sliding(lowered).on == node].sum())
    means = mean_torques(lowered)
    for term, on, way, mean in zip(
        lowered.load_terms, lowered.arrays.loads.on, point.load_directions, means, strict=True
    ):
        if on == node and isinstance(term, Load):
            total += way * mean
    pulses = HALF_WAVE_SQUARED_MEAN * lowered.arrays.blades.amplitude * point.blade_directions
    return total + float(pulses[lowered.arrays.blades.on == node].sum())


def _watched(path: LinearPath) -> list[int]:
    """Return the outputs that show whether the run is linear: torques of gapped springs, then the commands."""
    lowered, system = path.lowered, path.system
    gapped = [f"torque in {lowered.spring_names[row]}" for row in np.flatnonzero(lowered.arrays.springs.half_gap)]
    return [system.output(name) for name in (*gapped, *(f"command of {one}" for one in lowered.drive_names))]


def _check(path: LinearPath, values: Floats, *, rate: float) -> None:
    """Refuse a run that leaves the range in which it is linear."""
    lowered, point = path.lowered, path.point
    gapped = np.flatnonzero(lowered.arrays.springs.half_gap)
    beyond = "the start of the recording, where the rig is no longer linear; use simulate"
    for at, row in enumerate(gapped):
        torque = point.spring_torques[row] + values[at]
        if (opens := np.flatnonzero(torque * point.spring_torques[row] <= 0)).size:
            name = lowered.spring_names[row]
            raise SimulationError(f"the gap of {name!r} opens {opens[0] / rate:.4f} s after {beyond}")
    for at, name in enumerate(lowered.drive_names):
        limit = lowered.arrays.drives.limit[at]
        if (meets := np.flatnonzero(np.abs(point.drive_torque + values[gapped.size + at]) > limit)).size:
            after = f"{meets[0] / rate:.4f} s after {beyond}"
            raise SimulationError(f"{name!r} asks for more than the limit of {limit:.4g} N m {after}")
