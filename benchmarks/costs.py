"""What simulation, studies and filters cost, next to peers and to the limit of the machine; writes the page costs.md.

Needs the dependency group ``benchmark`` (MuJoCo) and motulator. Takes some three minutes on a quiet machine.
Run: python benchmarks/costs.py [PAGE.md]
"""

from __future__ import annotations

import json
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import drive_train_peers as peers
from counted_kernel import counted
from jinja2 import Environment, StrictUndefined
from machine_limit import bandwidth, peak_rate

HERE = Path(__file__).resolve().parent
LENGTHS = (1, 2, 5, 10, 20, 60)  # [s] of a recording at 25 kHz
CASES, STAGES, WORKERS = (64, 128, 256), (1, 2, 4, 8), (1, 2)
CASES_OF_WORKERS = 256
TRAIN_RIGS, TRAIN_SECONDS, DRIVE_SECONDS = 16, 2.0, 1.0
QUIET = 0.3  # load average at the start up to which the machine counts as quiet


@dataclass(frozen=True)
class Spent:
    """Seconds on the clock and of processor of one piece of work, and peak memory of its process [MB]."""

    clock: float
    processor: float
    megabytes: float
    before: float


@dataclass(frozen=True)
class KernelCost:
    """The batch kernel on one core: seconds per step of all lanes and of one rig, operations, bytes."""

    lanes_step: float
    single_step: float
    operations: dict[str, float]
    rate: float
    peak: float
    bytes_per_second: float
    bandwidth: float


def spent_in_child(kind: str, size: float) -> Spent:
    """Return what one piece of work costs in a process of its own; what is compiled is loaded before."""
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    run = subprocess.run(
        [sys.executable, __file__, "--one", kind, str(size)], env=environment, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    if run.returncode:
        raise SystemExit(run.stderr)
    return Spent(**json.loads(run.stdout))


def one(kind: str, size: float) -> None:
    """Do one piece of work and print what it cost."""
    work = {"samples": _recording, "cases": _cases, "stages": _chain, "workers": _workers}[kind]
    ready = work(size)
    before, clock, used = _peak(), time.perf_counter(), _processor()
    ready()
    spent = Spent(time.perf_counter() - clock, _processor() - used, _peak(), before)
    print(json.dumps(spent.__dict__))


def _recording(seconds: float):
    from torquerig.simulation.simulator import simulate

    rig = _wear_rig().rig
    simulate(rig, seed=1, duration=0.05)
    return lambda: simulate(rig, seed=1, duration=seconds)


def _wear_rig():
    from torquerig.catalog.reading import load_catalog
    from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
    from torquerig.document import read_document
    from torquerig.scenario.reading import read_scenario

    return read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=1)


def _drawn():
    from monte_carlo import EDITS

    from torquerig.catalog.reading import load_catalog
    from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
    from torquerig.document import read_document
    from torquerig.scenario.overrides import overridden
    from torquerig.study.definition import open_study
    from torquerig.study.monte_carlo.drawn_study import drawn_study

    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), EDITS)
    return drawn_study(open_study(document, load_catalog(shipped_folder())))


def _study(count: int, engine, *, seconds: float | None):
    from torquerig.study.monte_carlo.drawn_case import drawn_rows
    from torquerig.study.monte_carlo.drawn_study import cases_of_draws
    from torquerig.study.monte_carlo.running import run_draws

    drawn = _drawn()
    drawn_rows(drawn, cases_of_draws(drawn, 8))

    def run() -> None:
        with tempfile.TemporaryDirectory() as folder:
            run_draws(drawn, count, folder=Path(folder) / "store", engine=engine, seconds=seconds)

    return run


def _cases(count: float):
    from torquerig.cases import ThisProcess

    return _study(int(count), ThisProcess(), seconds=None)


def _workers(count: float):
    from torquerig.cases import ThisMachine

    return _study(CASES_OF_WORKERS, ThisMachine(int(count)), seconds=600.0)


def _chain(stages: float):
    from torquerig.filters.chains.chain_file import read_chains
    from torquerig.scenario.kinematics import kinematics_of
    from torquerig.simulation.simulator import simulate

    scenario = _wear_rig()
    chains = read_chains(scenario.document.path.parent / "filters.yaml", kinematics=kinematics_of(scenario.rig))
    recording = simulate(scenario.rig, seed=1, duration=10.0)
    every = [stage for name in ("order_lines", "low_pass_20Hz") for stage in chains[name].stages]
    listed = (every * int(stages))[: int(stages)]

    def run() -> None:
        made = recording
        for stage in listed:
            made = stage.apply(made)

    run()
    return run


def _processor() -> float:
    return sum(
        one.ru_utime + one.ru_stime
        for one in (resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN))
    )


def _peak() -> float:
    unit = 1 if sys.platform == "darwin" else 1024
    return (
        max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)) * unit / 1e6
    )


def kernel_cost() -> KernelCost:
    """Return what the kernel does per second on one core, and what the core could do, measured one after the other."""
    import numpy as np

    from torquerig.catalog.reading import Catalog
    from torquerig.document import read_document
    from torquerig.scenario.reading import read_scenario
    from torquerig.simulation.inputs import Span
    from torquerig.simulation.kernel.lanes import LANES
    from torquerig.simulation.kernel.loop import integrate
    from torquerig.simulation.kernel.side_by_side import integrate_together
    from torquerig.simulation.outputs import as_arrays
    from torquerig.simulation.ready import ready

    rig = read_scenario(read_document(HERE / "reference_job.yaml"), Catalog(), seed=1).rig
    span = Span.of(duration=2.0, settling=0.0, rate=25_000.0, seed=1, wander=0.0)
    run = ready(rig, span, substeps=4)
    outputs, steps = as_arrays(run.outputs), run.steps * span.samples

    def together() -> None:
        starts = [run.start() for _ in range(LANES)]
        integrate_together(
            [theta for theta, _ in starts], [omega for _, omega in starts], [run.terms] * LANES, outputs, span.rate, 0,
            run.steps, span.samples,
        )  # fmt: skip

    def single() -> None:
        kept = np.empty((outputs.kind.size, span.samples))
        integrate(*run.start(), run.terms, outputs, span.rate, 0, run.steps, kept)

    lanes, alone = (_least(each) / steps for each in (together, single))
    operations = counted()
    of_a_step = sum(operations[kind] for kind in ("additions", "products") if kind in operations)
    of_a_step = (of_a_step + operations.get("divisions", 0.0)) / run.steps
    return KernelCost(
        lanes_step=lanes, single_step=alone, operations=operations, rate=LANES * of_a_step / lanes, peak=peak_rate(),
        bytes_per_second=LANES * 8 * operations["outputs"] / run.steps / lanes, bandwidth=bandwidth(),
    )  # fmt: skip


def _least(function, turns: int = 5) -> float:
    function()
    spent = []
    for _ in range(turns):
        start = time.process_time()
        function()
        spent.append(time.process_time() - start)
    return min(spent)


def machine() -> str:
    """Return the processor, its cores, and the versions that compute."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    model = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor())
    libraries = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy", "numba"))
    return f"{model}, {os.cpu_count()} cores; Python {platform.python_version()}, {libraries}"


def main(page: Path) -> None:
    """Measure everything and write the page."""
    load = os.getloadavg()[0]
    table = {
        kind: {size: spent_in_child(kind, size) for size in sizes}
        for kind, sizes in (("samples", LENGTHS), ("cases", CASES), ("stages", STAGES), ("workers", WORKERS))
    }
    trains = [work(TRAIN_RIGS, TRAIN_SECONDS, workers=1) for work in (peers.torquerig_train, peers.mujoco_train)]
    drives = [peers.torquerig_drive(DRIVE_SECONDS), peers.motulator_drive(DRIVE_SECONDS)]
    kernel = kernel_cost()
    template = Environment(undefined=StrictUndefined, keep_trailing_newline=True).from_string(
        (HERE / "costs.md.jinja").read_text(encoding="utf-8")
    )
    measured = {
        "machine": machine(), "load": load, "quiet": load <= QUIET, "table": table,
        "cases_of_workers": CASES_OF_WORKERS, "trains": trains, "drives": drives, "drive": DRIVE_SECONDS,
        "train": {"rigs": TRAIN_RIGS, "seconds": TRAIN_SECONDS}, "kernel": kernel,
        **{kind: kernel.operations[kind] for kind in ("additions", "products", "comparisons")},
    }  # fmt: skip
    text = template.render(measured)
    page.write_text(text, encoding="utf-8")
    print(f"written: {page}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        one(sys.argv[2], float(sys.argv[3]))
    else:
        main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "costs.md")
