"""The shipped study as a user runs it: wall time and memory against the limits of 60 s and 2 GiB.

Run: python benchmarks/study.py
"""

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LIMIT_SECONDS, LIMIT_GIB = 60.0, 2.0
root = Path(__file__).resolve().parents[1]
run = [sys.executable, "-m", "torquerig", "compare", str(root / "scenarios/wear_rig.yaml"), "--out"]

for turn in ("first (compiles what is not cached)", "second"):
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        subprocess.run([*run, f"{folder}/report"], check=True, capture_output=True)
        seconds = time.perf_counter() - start
    gib = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20
    print(f"{turn}: {seconds:.1f} s of {LIMIT_SECONDS:.0f} s, {gib:.2f} GiB of {LIMIT_GIB:.0f} GiB")
