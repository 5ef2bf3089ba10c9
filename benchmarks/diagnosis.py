"""Four recordings of 12 s at 25 kHz through ``torquerig diagnose``: seconds and peak memory, next to their simulation.

Run with ``python benchmarks/diagnosis.py``; ``--hidden NAME`` takes one of the effects alone.
The wear rig of the shipped scenario is recorded with an effect that the scenario lacks, its speed
wandering, two speeds, two loads and a ramp. The limits on two cores are 20 s and 1 GiB;
the ratio is to the simulation of the four runs in the same process.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from dataclasses import replace
from math import pi
from pathlib import Path

from child import cost_of

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import Backlash, CommutationRipple, GearMesh, SensorDrift, StribeckFriction
from torquerig.recordings.files import write_recording
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

WEAR_RIG = shipped_scenarios() / "wear_rig.yaml"
RUNS = ((1000.0, 5.0, "steady"), (600.0, 5.0, "steady"), (1000.0, 0.0, "steady"), (1400.0, 5.0, "ramp"))
SECONDS, RATE = 12.0, 25_000.0
MOST_SECONDS, MOST_MEGABYTES = 20.0, 1074.0
HIDDEN: dict[str, tuple[Part, ...]] = {
    "nothing": (),
    "gear mesh": (GearMesh(name="hidden", order_output=84.0, transmission_error=(2e-4, 5e-5)),),
    "backlash": (Backlash(name="hidden", gear="gearbox", gap=12 / 60 * pi / 180),),
    "friction": (StribeckFriction(name="hidden", coulomb=0.35, static=0.8, stribeck_speed=1.0),),
    "ripple and drift": (
        CommutationRipple(name="hidden", order_motor=42.0, depth=0.15, harmonics=(0.04,)),
        SensorDrift(name="drift", span=0.5, time_constant=3.0),
    ),
}


def recorded(rig: Rig, folder: Path) -> tuple[list[str], float]:
    """Write the four runs; return their files and how long their simulation took [s]."""
    files, spent = [], 0.0
    for index, (rpm, occupancy, profile) in enumerate(RUNS, start=1):
        run = replace(rig.run, speed=rpm * pi / 30, occupancy_percent=occupancy, profile=profile)  # type: ignore[arg-type]
        start = time.perf_counter()
        made = simulate(rig.at(run), duration=SECONDS, seed=index, sample_rate=RATE, wander=2e-4)
        spent += time.perf_counter() - start
        files.append(str(folder / f"run{index}.parquet"))
        write_recording(made.without_truth(), Path(files[-1]))
    return files, spent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hidden", choices=tuple(HIDDEN), action="append")
    options = parser.parse_args()
    nominal = read_scenario(read_document(WEAR_RIG), load_catalog(shipped_folder()), seed=1).rig
    simulate(nominal, duration=0.1, seed=1)  # compiled before any clock runs
    for name in options.hidden or HIDDEN:
        rig = nominal
        for part in HIDDEN[name]:
            rig = rig + part
        with tempfile.TemporaryDirectory() as folder:
            files, simulated = recorded(rig, Path(folder))
            out = Path(folder) / "diagnosis.json"
            command = ["diagnose", *files, "--scenario", str(WEAR_RIG), "--json", str(out)]
            cost = cost_of(command)
            told = json.loads(out.read_text(encoding="utf-8"))
        named = ", ".join(finding["mechanism"] for finding in told["findings"]) or "nothing named"
        within = "within" if cost.seconds <= MOST_SECONDS and cost.megabytes <= MOST_MEGABYTES else "BEYOND"
        print(
            f"{name:>16}: {cost.seconds:5.1f} s ({cost.processor:.1f} s of processor), peak {cost.megabytes:.0f} MB, "
            f"{within} the limits; {cost.seconds / simulated:.0f} x the simulation of the runs ({simulated:.1f} s); "
            f"{told['verdict']}: {named}"
        )


if __name__ == "__main__":
    main()
