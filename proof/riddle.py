"""The 280 Hz line of the reference report, with harmonics, at 1000 rpm behind a 5:1 gear, in every load case.

Three rigs whose 280 Hz look alike at 1000 rpm, each with and without speed wander and at one speed and at two: a
planetary mesh of 21 and 84 teeth (order 84 of the output shaft), a comb of fixed frequency, and a resonance at 280 Hz
that the load excites. Without wander the speed is exact, so that 84 times the output's speed *is* 280 Hz.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from proof.rig_program.draw import Case
from proof.rig_program.effects.effect import Effect
from proof.rig_program.effects.fixed_comb import FixedComb
from proof.rig_program.effects.gear_mesh import GearMesh
from proof.rig_program.effects.torsional_mode import TorsionalMode
from proof.rig_program.laws import SAME_LAWS, draw_laws
from proof.rig_program.machine import machine_of
from proof.rig_program.plan import PlanKind, Profile, Run
from proof.rig_program.transfer import gain_of_twist, mode_frequencies
from proof.rig_program.true_rig import TrueRig, draw_true_rig

RIDDLE = 280.0  # [Hz]
HARMONICS = (1.0, 0.4, 0.3, 0.2, 0.15)  # 280 to 1400 Hz, as in the reference report
READING = 0.05  # [V] of the first


def draw_riddle(seed: int, *, duration: float = 12.0) -> list[Case]:
    """Return the twelve cases in random order."""
    rng = np.random.default_rng([seed, 280])
    rows = [(kind, wanders, two) for kind in range(3) for wanders in (False, True) for two in (False, True)]
    cases = []
    for i, row in enumerate(rng.permutation(len(rows)), start=1):
        kind, wanders, two = rows[int(row)]
        cases.append(_case(f"riddle-{i:02d}", (seed, 280, i), kind=kind, wanders=wanders, two=two, duration=duration))
    return cases


def _case(name: str, seed: tuple[int, ...], *, kind: int, wanders: bool, two: bool, duration: float) -> Case:
    """Return one rig with a 280 Hz line."""
    rng = np.random.default_rng(seed)
    rig, laws = draw_true_rig(rng), draw_laws(rng)
    if not wanders:
        rig = replace(rig, speed_error=0.0)
    makers = (planetary_mesh, fixed_comb, resonance)
    rows = ((1000.0, 5.0), (1000.0, 15.0), (700.0, 5.0), (700.0, 11.0)) if two else _one_speed()
    return Case(
        name=name,
        seed=seed,
        rig=rig,
        laws=laws,
        plan=tuple(Run(speed, Profile.STEADY, level, duration=duration) for speed, level in rows),
        plan_kind=PlanKind.OTHER if two else PlanKind.ONE_SPEED,
        effects=(makers[kind](rng, rig),),
        sizes=(0.5,),
        with_encoder=False,
        wanders=wanders,
    )


def _one_speed() -> tuple[tuple[float, float], ...]:
    """Return the load cases of the reference report at 1000 rpm."""
    return ((1000.0, 0.0), (1000.0, 5.0), (1000.0, 11.0), (1000.0, 15.0))


def planetary_mesh(rng: np.random.Generator, rig: TrueRig) -> Effect:
    """Return the mesh of a sun of 21 and a ring of 84 teeth with three planets."""
    error = READING / gain_of_twist(machine_of(rig, SAME_LAWS), RIDDLE)
    return GearMesh(
        teeth=84,
        errors=tuple(error * share for share in HARMONICS),
        phases=tuple(float(x) for x in rng.uniform(0.0, 2.0 * np.pi, len(HARMONICS))),
        modulation=float(rng.uniform(0.03, 0.12)),
        reading=READING,
    )


def fixed_comb(rng: np.random.Generator, rig: TrueRig) -> Effect:  # same signature for all makers
    """Return a comb of constant frequency."""
    return FixedComb(RIDDLE, tuple(READING * share for share in HARMONICS))


def resonance(rng: np.random.Generator, rig: TrueRig) -> Effect:
    """Return a branch on the wear part whose mode, coupled with the rig, is at 280 Hz."""
    inertia, damping = 0.5 * rig["wear_inertia"], float(rng.uniform(0.004, 0.015))
    bare, low, high = machine_of(rig, SAME_LAWS), 0.3 * RIDDLE, RIDDLE
    for _ in range(60):
        middle = 0.5 * (low + high)
        machine = TorsionalMode(middle, inertia, damping).on_machine(bare, _any_run(), rng)
        low, high = (middle, high) if mode_frequencies(machine)[1] < RIDDLE else (low, middle)
    return TorsionalMode(0.5 * (low + high), inertia, damping)


def _any_run() -> Run:
    """Return an arbitrary run."""
    return Run(1000.0, Profile.STEADY, 5.0)
