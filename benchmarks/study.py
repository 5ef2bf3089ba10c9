"""The shipped study: its runs alone, and as a user runs it with its page, against the limits of 10 s and 1 GiB.

Processor time tells what was computed where other programs run at the same time; wall time needs two quiet cores.
Run: python benchmarks/study.py
"""

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LIMIT_SECONDS, LIMIT_GIB = 10.0, 1.0  # of the runs and the decision, without the page
root = Path(__file__).resolve().parents[1]
scenario = root / "scenarios/wear_rig.yaml"
ALONE = f"""
from pathlib import Path
from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.study.definition import open_study
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide

scenario = Path({str(scenario)!r})
decide(run_study(open_study(read_document(scenario), catalog_for(scenario, ()))))
"""


def taken(command: list[str]) -> tuple[float, float, float]:
    """Return wall time [s], processor time [s], and the largest memory of all commands so far [GiB]."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    seconds, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, processor, after.ru_maxrss / 2**20


taken([sys.executable, "-c", ALONE])  # compiles what is not cached
seconds, processor, gib = taken([sys.executable, "-c", ALONE])
print(f"runs alone     {seconds:5.1f} s of {LIMIT_SECONDS:.0f} s, {processor:5.1f} s of processor time, "
      f"{gib:.2f} GiB of {LIMIT_GIB:.0f} GiB")  # fmt: skip
with tempfile.TemporaryDirectory() as folder:
    compare = [sys.executable, "-m", "torquerig", "compare", str(scenario), "--out", f"{folder}/report"]
    seconds, processor, gib = taken(compare)
print(f"with its page  {seconds:5.1f} s, {processor:5.1f} s of processor time, {gib:.2f} GiB")
