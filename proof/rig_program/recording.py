"""Recording of one run: the machine starts while turning, and the sensor signals are stored."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect
from proof.rig_program.forcing import Forcing, forcing_of
from proof.rig_program.laws import Integrator, Laws
from proof.rig_program.machine import Machine, machine_of
from proof.rig_program.plan import Run
from proof.rig_program.recorded import Recording
from proof.rig_program.sensor_chain import add_noise, convert, count
from proof.rig_program.stepping import rule_of
from proof.rig_program.true_rig import TrueRig
from proof.rig_program.waves import OUTPUT_POINTS, sum_of


def record(
    run: Run, rig: TrueRig, laws: Laws, *, effects: tuple[Effect, ...], seed: list[int], wanders: bool = True
) -> Recording:
    """Return the recording of one run of a rig with its effects; the same seed gives the same recording.

    Each effect has a separate random generator, so that the run without it is otherwise the same.
    """
    rng = np.random.default_rng([*seed, 0])
    own = [(effect, np.random.default_rng([*seed, i])) for i, effect in enumerate(effects, start=1)]
    machine = at_occupancy(machine_of(rig, laws), rig, run)
    forcing = forcing_of(run, rig, laws, rng, wanders=wanders)
    for effect, numbers in own:
        machine = effect.on_machine(machine, run, numbers)
        forcing = effect.on_forcing(forcing, run, numbers)
    moved = move(machine, forcing, laws, start_angle=float(rng.uniform(0.0, 2.0 * np.pi * nominal.RATIO)))
    kept = round(nominal.SETTLING * nominal.SAMPLE_RATE)
    volts = (1.0 + laws.gain_error) * moved[kept:, 0]
    volts = add_noise(volts, rng, rms=rig["noise"], colour=laws.noise_colour)
    for effect, numbers in own:
        volts = effect.on_voltage(volts, run, numbers)
    table = Recording(torque=convert(volts), encoder=count(moved[kept:, 1]))
    for effect, numbers in own:
        table = effect.on_file(table, run, numbers)
    return table


def at_occupancy(machine: Machine, rig: TrueRig, run: Run) -> Machine:
    """Return the machine with the wear part's lines scaled for the run's occupancy."""
    share = 1.0 + nominal.WEAR_LINES_BY_OCCUPANCY * run.occupancy
    return machine._replace(wear_table=sum_of(rig.wear_lines, points=OUTPUT_POINTS) / share)


def move(machine: Machine, forcing: Forcing, laws: Laws, *, start_angle: float = 0.0) -> NDArray[np.float64]:
    """Run the machine from a turning start and give amplifier [Nm], motor angle [rad], wear part speed [rad/s] (n, 3).

    Raises
    ------
    FloatingPointError
        If the motion is not finite: the drawn rig is outside the range of the integrator.
    """
    from proof.rig_program.kernel import run_machine

    state = turning_start(machine, forcing, start_angle=start_angle)
    steps = steps_for(machine, forcing, laws)
    inputs = (forcing.set_point, forcing.load, forcing.push, forcing.coupling_limit, forcing.line_phase)
    moved = run_machine(machine, state, inputs, rule_of(laws.integrator), steps, nominal.SAMPLE_RATE)
    if not np.isfinite(moved[-1]).all():
        raise FloatingPointError("the rig's motion is not finite")
    return np.asarray(moved)


def turning_start(machine: Machine, forcing: Forcing, *, start_angle: float) -> NDArray[np.float64]:
    """Return the state (18,) of a rig that turns at its first set-point under its first load."""
    from proof.rig_program.kernel import STATES

    speed = forcing.set_point[0] / machine.ratio
    side = 0 if speed >= 0.0 else 3
    torque = np.sign(speed) * (forcing.load[0] + machine.dry[side]) + machine.wear_viscous * speed
    torque += machine.drag * speed * abs(speed)
    state = np.zeros(STATES)
    state[0] = start_angle / machine.ratio
    twist = torque / machine.gear_stiffness + np.sign(torque) * machine.half_gap
    state[1] = state[0] - twist
    state[2] = state[1] - torque / machine.sensor_stiffness
    state[3:6] = state[2] - torque / machine.coupling_stiffness
    state[6:12] = speed
    state[12] = torque / machine.ratio * (1.0 + machine.loss * np.sign(torque * speed))
    state[13] = np.sign(speed)
    state[14] = torque
    return state


def steps_for(machine: Machine, forcing: Forcing, laws: Laws) -> int:
    """Return the steps per sample: those drawn, or more if dry friction or a branch is stiff."""
    dry = float(forcing.load.max()) + float(machine.dry[[0, 1, 3, 4]].max()) + float(machine.blade_table.max())
    rate = dry / laws.friction_width / machine.inertia[3] if laws.friction == 0 else 0.0
    if laws.friction in (1, 2):
        rate = float(np.abs(forcing.set_point).max()) / machine.ratio / laws.friction_width
    bound = 2.5 if laws.integrator is Integrator.DORMAND_PRINCE else 1.4
    return max(laws.steps, int(np.ceil(rate / nominal.SAMPLE_RATE / bound)))
