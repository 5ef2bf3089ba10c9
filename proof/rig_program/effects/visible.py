"""Smallest visible size of a line in at least one run of a plan."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Setting
from proof.rig_program.laws import SAME_LAWS
from proof.rig_program.machine import Machine, machine_of
from proof.rig_program.plan import Run
from proof.rig_program.transfer import line_floor, resisting, steady_runs

TIMES_FLOOR = 8.0  # a line this far above the amplitude of the noise in its width is just visible


def just_visible(
    setting: Setting, frequency: Callable[[Run], float], gain: Callable[[Machine, float, Run], float]
) -> float:
    """Smallest size that lifts a line `TIMES_FLOOR` above the floor in the best steady run of the plan.

    Parameters
    ----------
    frequency : callable
        The line's frequency [Hz] in a run.
    gain : callable
        Reading [V] per unit of size, from machine, frequency [Hz] and run.
    """
    machine = machine_of(setting.rig, SAME_LAWS)
    sizes = []
    for run in steady_runs(setting.plan):
        at = frequency(run)
        sizes.append(TIMES_FLOOR * line_floor(setting.rig, run, at) / max(gain(machine, at, run), 1e-12))
    return min(sizes)


def unit_reading(
    setting: Setting, frequency: Callable[[Run], float], gain: Callable[[Machine, float, Run], float]
) -> float:
    """Largest reading [V] per unit of size over the steady runs of the plan."""
    machine = machine_of(setting.rig, SAME_LAWS)
    return max(gain(machine, frequency(run), run) for run in steady_runs(setting.plan))


def motor_frequency(order: float) -> Callable[[Run], float]:
    """Return the frequency [Hz] of an order of the motor, by run."""
    return lambda run: float(order * run.motor_speed / (2.0 * np.pi))


def output_frequency(order: float) -> Callable[[Run], float]:
    """Return the frequency [Hz] of an order of the output shaft, by run."""
    return motor_frequency(order / nominal.RATIO)


def motor_torque(setting: Setting, run: Run) -> float:
    """Mean torque of the motor [Nm] in a run."""
    return resisting(setting.rig, run) / (nominal.RATIO * nominal.EFFICIENCY) + setting.rig["motor_coulomb"]
