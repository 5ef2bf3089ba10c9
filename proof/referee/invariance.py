"""Changes of the files that must not change the answer: order, unit, sign, start, rate, and two similarities.

A rig with all torques times q, or all speeds times a (inertias by a^-2, dampers by a^-1), has the same samples; only
scenario and sidecars differ. So the diagnosis must say the same.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from proof.fleet.draw import RIGS, FleetCase, NoRigError, with_effects
from proof.fleet.effects import MECHANISMS
from proof.fleet.rig import draw_rig
from proof.fleet.setting import setting_of
from proof.referee.edits import Columns, Edit, Tree, times

KINDS = ("gear_mesh", "commutation_ripple", "blade_pass", "torsional_mode", "cogging", "stribeck_friction")
SHIFT = 0.37  # [s] that is cut off the beginning
POWERS = {
    "N*m": (1, 0), "N": (1, 0), "kg*m^2": (1, -2), "N*m/rad": (1, 0), "N*m*s/rad": (1, -1), "N*s/m": (1, -1),
    "N*m*s^2/rad^2": (1, -2), "V/(N*m)": (-1, 0), "Hz": (0, 1), "1/s": (0, 1), "rpm": (0, 1),
    "ms": (0, -1), "s": (0, -1),
}  # fmt: skip
"""Powers of the factors of torque and of speed in a number of each unit; other units stay."""
KEPT_UNITS = ("V", "rad", "deg", "mm", "%")


def similar(tree: Any, torque: float, speed: float) -> Any:
    """Return a scenario of the similar rig; every number with a unit is scaled."""
    if isinstance(tree, dict):
        if "value" in tree:
            return tree | {"value": similar(tree["value"], torque, speed)}
        return {key: similar(value, torque, speed) for key, value in tree.items()}
    if isinstance(tree, list):
        return [similar(value, torque, speed) for value in tree]
    if isinstance(tree, str) and len(tree.split()) == 2:
        number, unit = tree.split()
        if unit in POWERS and _is_number(number):
            of_torque, of_speed = POWERS[unit]
            return times(tree, torque**of_torque * speed**of_speed)
    return tree


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _similarity(torque: float, speed: float) -> Edit:
    def sidecar(facts: Tree) -> Tree:
        facts["sample_rate_Hz"] = float(f"{facts['sample_rate_Hz'] * speed:.9g}")
        facts["channels"]["torque_V"]["Nm_per_V"] = times(facts["channels"]["torque_V"]["Nm_per_V"], torque)
        facts["run"]["speed_rpm"] = times(facts["run"]["speed_rpm"], speed)
        return facts

    def scenario(tree: Tree) -> Tree:
        changed: Tree = similar(tree, torque, speed)
        return changed

    return Edit(scenario, sidecar)


def _millivolts() -> Edit:
    def sidecar(facts: Tree) -> Tree:
        channel = facts["channels"].pop("torque_V")
        per_volt = channel.pop("Nm_per_V")
        facts["channels"] = {"torque_mV": channel | {"unit": "mV", "Nm_per_mV": times(per_volt, 1e-3)}} | facts[
            "channels"
        ]
        return facts

    def columns(table: Columns, rate: float) -> Columns:
        rest = {name: values for name, values in table.items() if name != "torque_V"}
        return {"torque_mV": (1e3 * table["torque_V"].astype(float)).astype(np.float32)} | rest

    return Edit(sidecar=sidecar, columns=columns)


def _turned() -> Edit:
    def sidecar(facts: Tree) -> Tree:
        facts["channels"]["torque_V"]["Nm_per_V"] = times(facts["channels"]["torque_V"]["Nm_per_V"], -1.0)
        return facts

    def columns(table: Columns, rate: float) -> Columns:
        return table | {"torque_V": -table["torque_V"]}

    return Edit(sidecar=sidecar, columns=columns)


def _later() -> Edit:
    def columns(table: Columns, rate: float) -> Columns:
        return {name: values[round(SHIFT * rate) :] for name, values in table.items()}

    return Edit(columns=columns)


def _half_rate() -> Edit:
    def sidecar(facts: Tree) -> Tree:
        facts["sample_rate_Hz"] = facts["sample_rate_Hz"] / 2
        return facts

    def columns(table: Columns, rate: float) -> Columns:
        from scipy.signal import firwin, oaconvolve

        taps = firwin(129, 0.45)
        halved = {name: values[::2] for name, values in table.items()}
        torque = table["torque_V"].astype(float)
        padded = np.concatenate([np.full(64, torque[0]), torque, np.full(64, torque[-1])])
        filtered = oaconvolve(padded, taps, mode="valid")
        return halved | {"torque_V": filtered[::2].astype(np.float32)}

    return Edit(sidecar=sidecar, columns=columns)


CHANGES: dict[str, Callable[[], Edit]] = {
    "as_is": Edit,
    "order_of_files": lambda: Edit(backwards=True),
    "millivolts": _millivolts,
    "sign": _turned,
    "time_shift": _later,
    "half_rate": _half_rate,
    "torque_x0.01": lambda: _similarity(0.01, 1.0),
    "torque_x100": lambda: _similarity(100.0, 1.0),
    "speed_x0.2": lambda: _similarity(1.0, 0.2),
    "speed_x4": lambda: _similarity(1.0, 4.0),
}
"""Edits by the name of the change; ``as_is`` is what all others are compared with."""


def changed_case(name: str, seed: tuple[int, ...]) -> FleetCase:
    """Draw a rig with one effect that can have every change: runs of 8 s and more, no frequency of the mains."""
    case = _case(seed)
    return replace(case, rig=replace(case.rig, name=name))


@lru_cache(maxsize=1)
def _case(seed: tuple[int, ...]) -> FleetCase:
    rng = np.random.default_rng([*seed, 24])
    kind = KINDS[seed[-1] % len(KINDS)]
    for attempt in range(3 * RIGS):
        rig = draw_rig("", (*seed, attempt), plans=("several", "reversal"), motors=("servo", "bldc"))
        if not 4000.0 <= rig.design.sample_rate <= 12000.0:
            continue
        setting = setting_of(rig)
        if MECHANISMS[kind](np.random.default_rng(0), setting) is not None:
            return with_effects(rig, setting, [MECHANISMS[kind]], rng)
    raise NoRigError(f"INVARIANCE, seed {seed}: none of {3 * RIGS} drawn rigs can have {kind}")
