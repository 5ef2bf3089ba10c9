"""The exact linear path beside scipy's lsim and dlsim and the integrator, in one run, on the wear rig made linear.

The rig is the shipped one at 1000 rpm under 5 % occupancy, where its dry friction and gear losses are linear. What is
timed is 10 s at 25 kHz: the same sampled closed-loop system with the same load and lines for all of them. scipy gets
the lines as further inputs, sampled (lsim and dlsim know no phasors). One thread.
Run: python benchmarks/linear_path.py
"""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy import signal
from threadpoolctl import threadpool_limits

from torquerig.catalog.reading import load_catalog
from torquerig.document import read_document
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.inputs import Span, filled
from torquerig.simulation.linear_path import simulate_linear
from torquerig.simulation.linear_start import prepared
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.blocks import lifted, run
from torquerig.simulation.twin.operating_point import mean_torques
from torquerig.simulation.twin.plant import plant

SECONDS, RATE, TURNS = 10.0, 25_000.0, 9
root = Path(__file__).resolve().parents[1]


def least(job: Callable[[], object], turns: int = TURNS) -> float:
    """Return the shortest time of several runs [s]."""
    times = []
    for _ in range(turns):
        start = time.perf_counter()
        job()
        times.append(time.perf_counter() - start)
    return min(times)


def told(what: str, seconds: float) -> None:
    print(f"{what:62s} {SECONDS / seconds:8.0f} x real time")


rig = read_scenario(read_document(root / "scenarios/wear_rig.yaml"), load_catalog(root / "catalogs"), seed=1).rig
path = prepared(rig, 1, rate=RATE)
samples = round(SECONDS * RATE)
terms = filled(rig, path.lowered, Span(settling=0, samples=samples, rate=RATE, seed=1))
load = terms.loads.samples[0, :samples] - mean_torques(path.lowered)[0]
name = f"load {path.lowered.load_terms[0].name}"
system = path.system.only(inputs=[name], outputs=[f"torque in {rig.measured}"])
everything = path.system.only(inputs=[name])
sensor = path.system.output(f"torque in {rig.measured}")
one_line = type(path.lines)(path.lines.angular, path.lines.onto_states, path.lines.onto_outputs[[sensor]])

with threadpool_limits(1):
    start = time.perf_counter()
    step = lifted(system, one_line)
    run(step, one_line, period=1 / RATE, start=path.start, inputs=load[None, :64], skipped=0, outputs=[0])
    ready = time.perf_counter() - start

    def ours() -> np.ndarray:
        """The sensor's torque, all lines on."""
        return run(step, one_line, period=1 / RATE, start=path.start, inputs=load[None], skipped=0, outputs=[0])[0][0]

    whole = lifted(everything, path.lines)
    rows = range(len(everything.outputs))[:6]
    told(f"exact path, the sensor's torque ({path.lines.angular.size} lines, {len(system.states)} states)", least(ours))

    def six() -> object:
        """Six channels of the same run."""
        return run(whole, path.lines, period=1 / RATE, start=path.start, inputs=load[None], skipped=0, outputs=rows)

    told("exact path, six channels", least(six))
    told("simulate_linear: all channels, load drawn, sensor stages, settling",
         least(lambda: simulate_linear(rig, duration=SECONDS, seed=1), 5))  # fmt: skip
    told("simulate (Runge-Kutta), the same", least(lambda: simulate(rig, duration=SECONDS, seed=1), 3))
    # scipy: the phasors' effect on the states as inputs of their own, two a line
    turning = np.exp(1j * np.outer(np.arange(samples) / RATE, path.lines.angular))
    inputs = np.column_stack([load, turning.real, turning.imag])
    B = np.hstack([system.B, path.lines.onto_states.real, -path.lines.onto_states.imag])
    D = np.hstack([system.D, one_line.onto_outputs.real, -one_line.onto_outputs.imag])
    discrete = (system.A, B, system.C, D, 1 / RATE)
    theirs = signal.dlsim(discrete, inputs, x0=path.start)[1][:, 0]
    told("scipy.signal.dlsim, the sensor's torque", least(lambda: signal.dlsim(discrete, inputs, x0=path.start), 2))
    free = plant(path.lowered, path.point).only(inputs=[name], outputs=[f"torque in {rig.measured}"])
    continuous = (free.A, free.B, free.C, free.D)
    times = np.arange(samples) / RATE
    told("scipy.signal.lsim, no speed loop and no lines", least(lambda: signal.lsim(continuous, load, times), 2))
print(f"ready to run (matrices of a block, kernel from cache) after {ready:.3f} s")
print(
    f"largest difference of the sensor's torque from dlsim: {np.abs(ours() - theirs).max():.1e} N m (wanted: rounding)"
)
print("wanted: 3000 x real time or better for the exact path")
