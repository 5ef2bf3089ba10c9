"""One case: a rig, its laws, a plan of runs and the effects that the nominal model lacks."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from proof.rig_program.effect_draws import draw_effect, draw_pair, plan_kind, shows
from proof.rig_program.effects.effect import Effect, Setting
from proof.rig_program.gap_shows import gap_shows
from proof.rig_program.laws import SAME_LAWS, Laws, draw_laws
from proof.rig_program.plan import PlanKind, Run, draw_plan
from proof.rig_program.recording import record
from proof.rig_program.true_rig import TrueRig, draw_true_rig
from proof.rig_program.writing import write_recording


@dataclass(frozen=True)
class Case:
    """One rig with its runs, ready to be recorded.

    Parameters
    ----------
    name : str
        Its folder; it tells nothing.
    seed : tuple of int
        Of everything random in its runs.
    sizes : tuple of float
        0 (just visible) to 1 for each effect.
    wrong_parameters : bool
        The rig was drawn twice as far from the nominal as the reference says.
    wanders : bool
        The speed of steady runs wanders slowly.
    """

    name: str
    seed: tuple[int, ...]
    rig: TrueRig
    laws: Laws
    plan: tuple[Run, ...]
    plan_kind: PlanKind
    effects: tuple[Effect, ...] = ()
    sizes: tuple[float, ...] = ()
    with_encoder: bool = False
    wrong_parameters: bool = False
    wanders: bool = True


def draw_case(
    name: str,
    seed: tuple[int, ...],
    kinds: tuple[str, ...],
    *,
    wrong_parameters: bool = False,
    same_laws: bool = False,
    second: bool = False,
    duration: float = 12.0,
) -> Case:
    """Draw one case with effects of these kinds; ``second`` adds one more that the first does not hide."""
    rng = np.random.default_rng(seed)
    if second:
        kinds = (*kinds, draw_pair(rng, kinds[0]))
    rig = draw_true_rig(rng, spread=2.0 if wrong_parameters else 1.0)
    laws = draw_laws(rng)
    sort = plan_kind(rng, kinds)
    while True:
        plan = draw_plan(rng, sort, duration=duration)
        if not shows(plan, kinds):
            continue
        sizes = tuple(float(rng.uniform(0.3 if second else 0.0, 1.0)) for _ in kinds)
        setting = Setting(rig, plan)
        effects = tuple(draw_effect(rng, kind, setting, size=size) for kind, size in zip(kinds, sizes, strict=True))
        if gap_shows(plan, rig, laws, effects=effects, seed=seed):
            break
    return Case(
        name=name,
        seed=seed,
        rig=rig,
        laws=SAME_LAWS if same_laws else laws,
        plan=plan,
        plan_kind=sort,
        effects=effects,
        sizes=sizes,
        with_encoder=bool(rng.integers(2)),
        wrong_parameters=wrong_parameters,
    )


def record_case(case: Case, folder: Path) -> None:
    """Write the recordings of a case into its folder: run1.parquet and its sidecar, and so on."""
    for i, run in enumerate(case.plan, start=1):
        table = record(run, case.rig, case.laws, effects=case.effects, seed=[*case.seed, i], wanders=case.wanders)
        write_recording(table, folder / case.name / f"run{i}.parquet", run=run, with_encoder=case.with_encoder)


def answer_of(case: Case) -> dict[str, Any]:
    """Return the sealed answer of a case: effects first, then all drawn values."""
    outside = any(not effect.in_library for effect in case.effects)
    return {
        "verdict": "unexplained" if outside else "missing_physics" if case.effects else "adequate",
        "wrong_parameters": case.wrong_parameters,
        "effects": [
            {
                "mechanism": effect.kind,
                "in_library": effect.in_library,
                "size": size,
                "also_right": list(effect.also_right()),
                "parameters": effect.parameters(),
            }
            for effect, size in zip(case.effects, case.sizes, strict=True)
        ],
        "plan": case.plan_kind.value,
        "one_speed": len({(run.speed, run.profile) for run in case.plan}) == 1,
        "speed_error": case.rig.speed_error,
        "encoder": case.with_encoder,
        "load_factor": case.rig.load_factor,
        "quantities": case.rig.quantities,
        "laws": {key: _plain(value) for key, value in vars(case.laws).items()},
    }


def _plain(value: Any) -> Any:
    """Return the name of an enumeration, and any other value unchanged."""
    return value.name.lower() if hasattr(value, "name") else value
