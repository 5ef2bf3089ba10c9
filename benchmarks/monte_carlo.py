"""Ten thousand draws of the wear rig (2 s at 25 kHz, sensor and one filter each): time, overhead, memory, workers.

Run: python benchmarks/monte_carlo.py [CASES]
"""

import resource
import sys
import tempfile
import time
from pathlib import Path

from torquerig.cases import ThisMachine
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.monte_carlo.drawn_study import drawn_study
from torquerig.study.monte_carlo.running import run_draws

LIMIT_SECONDS = 180.0
EDITS = (
    "study.duration=2 s", "study.motors=[HDS6A-0104A]", "study.gearboxes=[reference-5-1]",
    "study.present.motor=HDS6A-0104A", "study.filters.names=[order_lines_low_pass]",
    "study.present.filter=order_lines_low_pass", "study.criteria.disturbance.metric=truth_error",
)  # fmt: skip


def measured(count: int, workers: int) -> float:
    """Run so many draws, print what they cost, and return the time on the clock [s]."""
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), EDITS)
    drawn = drawn_study(open_study(document, load_catalog(shipped_folder())))
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        made = run_draws(drawn, count, folder=Path(folder) / "store", engine=ThisMachine(workers)).run
        seconds = time.perf_counter() - start
    overhead = 1 - made.work_seconds / (workers * made.seconds)
    own, others = (
        resource.getrusage(who).ru_maxrss / 2**20 for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    )
    print(
        f"{count} cases, {workers} workers: {seconds:.1f} s ({1e3 * made.work_seconds / count:.1f} ms of work a case), "
        f"outside the work {100 * overhead:.1f} %, memory {own:.2f} GiB here and {others:.2f} GiB in the largest worker"
    )
    return seconds


if __name__ == "__main__":
    asked = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    measured(64, 2)  # compiles what is not cached
    one, two = measured(asked // 10, 1), measured(asked // 10, 2)
    print(f"two workers against one: {one / two:.2f}")
    whole = measured(asked, 2)
    print(f"{asked} cases in {whole:.0f} s; limit for 10000 is {LIMIT_SECONDS:.0f} s")
