"""The reference job: the general kernel from YAML beside the same algorithm written by hand in C, in one run.

Three masses, one spring with backlash, Stribeck friction, twelve harmonics of orders 6..72, PI speed control at 25 kHz,
four Runge-Kutta steps a sample. Prints times real time of both, their ratio, and how far their end states lie apart.
Run: python benchmarks/reference_job.py
"""

import shutil
import subprocess
import tempfile
import time
from math import pi
from pathlib import Path

from torquerig.catalog.reading import Catalog
from torquerig.document import read_document
from torquerig.scenario.reading import read_scenario
from torquerig.simulate.simulate import simulate

SECONDS, SPEED, TURNS = 10.0, 1000 * pi / 30, 5
here = Path(__file__).resolve().parent


def general() -> tuple[float, float, float]:
    """Return the least CPU seconds of the general kernel, its compile time, and the load's end speed [rad/s]."""
    rig = read_scenario(read_document(here / "reference_job.yaml"), Catalog(), seed=1).rig
    start = time.perf_counter()
    simulate(rig, duration=0.01, seed=1, settling=0.0, substeps=4)
    compiling = time.perf_counter() - start
    least, end = 1e9, 0.0
    for _ in range(TURNS):
        start = time.process_time()
        made = simulate(rig, duration=SECONDS + 1 / 25000, seed=1, settling=0.0, substeps=4)
        least = min(least, time.process_time() - start)
        end = made.channels["true_output_speed_rad_s"].values[-1]
    return least, compiling, end


def by_hand() -> tuple[float, float]:
    """Return the least CPU seconds of the C program, and the load's end speed [rad/s]."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "job"
        command = ["gcc", "-O3", "-march=native", "-o", str(program), str(here / "reference_job.c"), "-lm"]
        subprocess.run(command, check=True)
        runs = [subprocess.run([str(program), str(SECONDS), repr(SPEED)], check=True, capture_output=True, text=True)
                for _ in range(TURNS)]  # fmt: skip
    rows = [run.stdout.split() for run in runs]
    return min(float(row[0]) for row in rows), float(rows[0][1])


if shutil.which("gcc") is None:
    raise SystemExit("gcc is not there; the peer of this benchmark needs it")
ours, compiling, end = general()
theirs, their_end = by_hand()
print(f"general kernel {SECONDS / ours:6.1f} x real time (compiling or loading from cache took {compiling:.2f} s)")
print(f"C by hand      {SECONDS / theirs:6.1f} x real time")
print(f"ratio of times {ours / theirs:.2f} (wanted: 1.5 or less); end speeds {end:.9f} and {their_end:.9f} rad/s")
