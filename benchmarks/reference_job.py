"""The reference job: the general kernel from YAML beside the same algorithm written by hand in C, in one run.

Three masses, one spring with backlash, Stribeck friction, twelve harmonics of orders 6..72, PI speed control at 25 kHz,
four Runge-Kutta steps a sample. Prints times real time of one run and of a batch on all cores, their ratios, how far
the end states lie apart, the accurate setting beside the converged run, and what compiling and starting cost.
Run: python benchmarks/reference_job.py
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from math import pi
from pathlib import Path

import numpy as np

from torquerig.catalog.reading import Catalog
from torquerig.document import read_document
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.batch import simulate_batch
from torquerig.simulation.simulator import simulate

SECONDS, SPEED, TURNS, RATE = 10.0, 1000 * pi / 30, 9, 25_000
BATCH = 8 * (os.cpu_count() or 1)  # rigs, each with a seed of its own
ACCURATE, CONVERGED = 8, 64  # steps a sample
here = Path(__file__).resolve().parent
rig = read_scenario(read_document(here / "reference_job.yaml"), Catalog(), seed=1).rig
given = {"duration": SECONDS + 1 / RATE, "settling": 0.0, "substeps": 4}


def in_turns() -> tuple[list[float], float, float]:
    """Return the least seconds of C, one run (CPU), one run, a batch (by the clock); the end speeds [rad/s]."""
    least = [1e9] * 4
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "job"
        command = ["gcc", "-O3", "-march=native", "-o", str(program), str(here / "reference_job.c"), "-lm"]
        subprocess.run(command, check=True)
        for _ in range(TURNS):
            told = subprocess.run([str(program), str(SECONDS), repr(SPEED)], check=True, capture_output=True, text=True)
            cpu, clock = time.process_time(), time.perf_counter()
            made = simulate(rig, seed=1, **given)
            one = time.process_time() - cpu, time.perf_counter() - clock
            clock = time.perf_counter()
            simulate_batch([rig] * BATCH, seeds=range(BATCH), **given)
            taken = float(told.stdout.split()[0]), *one, time.perf_counter() - clock
            least = [min(pair) for pair in zip(least, taken, strict=True)]
    return least, made.channels["true_output_speed_rad_s"].values[-1], float(told.stdout.split()[1])


def apart() -> float:
    """Return the largest difference between the torques of a batch and those of single runs [N m]."""
    batch = simulate_batch([rig] * BATCH, seeds=range(BATCH), **given)
    return max(np.abs(batch[n].torque() - simulate(rig, seed=n, **given).torque()).max() for n in (0, BATCH - 1))


def accurate() -> tuple[float, float]:
    """Return the least CPU seconds of the accurate setting, and its largest error against the converged run [N m]."""
    least = 1e9
    for _ in range(TURNS):
        cpu = time.process_time()
        made = simulate(rig, seed=1, **given | {"substeps": ACCURATE})
        least = min(least, time.process_time() - cpu)
    exact = simulate(rig, seed=1, **given | {"substeps": CONVERGED})
    return least, np.abs(made.torque() - exact.torque()).max()


SHORT: dict[str, Callable[[], object]] = {
    "one run": lambda: simulate(rig, seed=1, **given | {"duration": 0.01}),
    "a batch": lambda: simulate_batch([rig] * 8, seeds=range(8), **given | {"duration": 0.01}),
}


def starting(what: str, cache: str) -> tuple[float, float]:
    """Return the CPU seconds of a first run of 10 ms in a fresh interpreter, and of that interpreter in all."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    told = subprocess.run(
        [sys.executable, __file__, what], env=os.environ | {"NUMBA_CACHE_DIR": cache},
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return float(told.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


if len(sys.argv) > 1:
    began = time.process_time()
    SHORT[sys.argv[1]]()
    print(time.process_time() - began)
    raise SystemExit
if shutil.which("gcc") is None:
    raise SystemExit("gcc is not there; the peer of this benchmark needs it")
with tempfile.TemporaryDirectory() as empty:
    starts = {what: (starting(what, empty), starting(what, empty)) for what in SHORT}
for run in SHORT.values():
    run()
(theirs, ours, clock, batch), end, their_end = in_turns()
fine, error = accurate()
print(f"one run, one core    {SECONDS / ours:6.1f} x real time (wanted: 30); C by hand {SECONDS / theirs:.1f}")
print(f"ratio of times to C  {ours / theirs:6.2f} (wanted: 1.5 or less); ends {end:.9f}, {their_end:.9f} rad/s")
print(f"batch of {BATCH}, {os.cpu_count()} cores {BATCH * SECONDS / batch:6.1f} x real time in all")
print(f"ratio to one run     {BATCH * clock / batch:6.1f} (wanted: 2.5); torques apart by {apart():.1e} N m")
print(f"accurate, {ACCURATE} steps    {SECONDS / fine:6.1f} x real time (wanted: 10)")
print(f"its torque           {error:6.0e} N m from that of {CONVERGED} steps (wanted: 1e-4)")
for what, ((compiling, _), (loading, in_all)) in starts.items():
    print(f"compiling {what}    {compiling:6.1f} s, once: it is kept on disk")
    print(f"warm start of it     {loading:6.2f} s to the first run, {in_all:.2f} s with the interpreter (wanted: 1)")
