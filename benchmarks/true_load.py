"""How far filter chains are from the true load of the simulated wear rig, beside perfect line removal.

Four occupancies, a set-point that is wrong by 0.5 %, slow wander; with encoder and from the torque alone. Perfect line
removal is the same run (same seed) without any line mechanism. Run: python benchmarks/true_load.py [SECONDS [SEEDS]]
"""

import sys
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.filters.chains.chain_file import read_chains
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.load_inverse import LoadInverse
from torquerig.filters.load_response import LoadResponse
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.load_response import load_response
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

OCCUPANCIES = (5, 11, 15, 21)
SPEED_ERROR = 1.005
MESH = "rig.mesh={kind: gear_mesh, order_output: 84, transmission_error: [5.0e-5 rad]}"


def scenario_at(occupancy: float, *, mesh: bool = False) -> Scenario:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    settings = (f"operating_point.load.occupancy={occupancy} %", *((MESH,) if mesh else ()))
    return read_scenario(overridden(document, settings), load_catalog(shipped_folder()), seed=1)


def without_lines(rig: Rig) -> Rig:
    """Return the rig without what makes lines: every effect but the load."""
    return replace(rig, parts=tuple(part for part in rig.parts if part.group in ("", "load")))


def run_of(scenario: Scenario, rig: Rig, *, seconds: float, seed: int) -> Recording:
    """Return a run that is really faster by the set-point's error, with the set-point on its sheet."""
    faster = replace(rig.run, speed=rig.run.speed * SPEED_ERROR)
    made = simulate(rig.at(faster), duration=seconds, seed=seed, wander=scenario.operating_point.slow_speed_wander)
    return replace(made, run=rig.run)


def chains_of(scenario: Scenario, response: LoadResponse) -> Mapping[str, Chain]:
    kinematics = kinematics_of(scenario.rig)
    return read_chains(shipped_scenarios() / "filters.yaml", kinematics=kinematics, response=response)


def wrong_models(rig: Rig) -> Iterator[tuple[str, Rig]]:
    """Yield models that are 10 % wrong, each in its own way."""
    changes = {
        "all springs 10 % stiffer": ("stiffness", 1.1),
        "all springs 10 % softer": ("stiffness", 0.9),
        "all inertias 10 % larger": ("inertia", 1.1),
        "all dampers 10 % stronger": ("damping", 1.1),
    }
    for told, (key, factor) in changes.items():
        parts = tuple(
            replace(part, **{key: getattr(part, key) * factor}) if hasattr(part, key) else part for part in rig.parts
        )
        yield told, replace(rig, parts=parts)


def measured(recording: Recording, *, encoder: bool) -> Recording:
    """Return what the rig records, without truth and, where asked for, without its encoder."""
    bare = recording.without_truth()
    kept = {name: one for name, one in bare.channels.items() if encoder or one.quantity == "torque"}
    return replace(bare, channels=kept)


def main(seconds: float, seeds: int) -> None:
    print(f"rms error to the true load [N m], {seconds:g} s, {seeds} seeds; times perfect line removal")
    for occupancy in OCCUPANCIES:
        scenario = scenario_at(occupancy)
        chains = chains_of(scenario, load_response(scenario.rig))
        errors: dict[str, list[float]] = {}
        for seed in range(1, seeds + 1):
            run = run_of(scenario, scenario.rig, seconds=seconds, seed=seed)
            clean = run_of(scenario, without_lines(scenario.rig), seconds=seconds, seed=seed)
            # the load sees the same draws, but the shaft turns a little differently: each against its own truth
            errors.setdefault("perfect", []).append(truth_error(clean, clean))
            reading = measured(run, encoder=True)
            for told, rig in wrong_models(scenario.rig):
                for retune, how in ((0.15, "retuned"), (0.0, "trusted")):
                    stage = LoadInverse(response=load_response(rig), retune=retune)
                    answer = stage.apply(chains["order_lines"].apply(reading))
                    errors.setdefault(f"inverse, model with {told}, {how}", []).append(truth_error(answer, run))
            for name, chain in chains.items():
                for encoder in (True, False):
                    answer = chain.apply(measured(run, encoder=encoder))
                    errors.setdefault(f"{name}{'' if encoder else ', torque alone'}", []).append(
                        truth_error(answer, run)
                    )
        perfect = np.array(errors["perfect"])
        load = run.channels[TRUE_LOAD].values
        print(f"occupancy {occupancy} %: mean {load.mean():.3f}, standard deviation {load.std():.3f}")
        for name, values in errors.items():
            share = np.array(values) / perfect
            print(f"  {name:44s} {np.mean(values):8.4f}  x {share.mean():6.3f} (largest {share.max():6.3f})")


if __name__ == "__main__":
    main(*(float(sys.argv[1]) if len(sys.argv) > 1 else 10.0, int(sys.argv[2]) if len(sys.argv) > 2 else 2))
