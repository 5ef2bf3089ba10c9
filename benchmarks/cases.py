"""What the case engine costs: two workers against one, share of time outside the work, start, rows a second, memory.

Run: python benchmarks/cases.py [ADDRESS of a Dask scheduler]
"""

import os
import resource
import sys
import tempfile
import time
from pathlib import Path

from torquerig.cases import Case, Cluster, Column, Identity, ThisMachine, ThisProcess, answers, run_cases

CASES, BLOCK, TURNS = 480, 8, 5
CASE_SECONDS = 0.012  # of processor, as the batch kernel takes for 2 s of a rig
IDENTITY = Identity(study={"benchmark": "cases"}, values=[Column("x")], results=[Column(f"y{n}") for n in range(10)])


def busy(loops, cases):
    """Compute for a fixed number of loops, whatever else the machine does; return the processor time [s]."""
    rows = []
    for case in cases:
        start, total = time.process_time(), case.values["x"]
        for n in range(loops):
            total += (total * n) % 3.0
        rows.append({"processor": time.process_time() - start, "y": total})
    return rows


def cheap(inputs, cases):
    """Compute next to nothing."""
    return [{f"y{n}": case.values["x"] + n for n in range(10)} for case in cases]


def table(count):
    """Return so many cases."""
    return [Case(n, {"x": n / 7}, seed=n) for n in range(count)]


def loops_of(seconds):
    """Return how many loops take so many seconds of this processor [s]."""
    start = time.process_time()
    busy(100_000, table(1))
    return int(100_000 * seconds / (time.process_time() - start))


def timed(engine, loops):
    """Return the time [s] to the first answer, from there to the last, in the work function, and of its processor."""
    begin = time.perf_counter()
    first, work, processor = 0.0, 0.0, 0.0
    for answer in answers(busy, loops, table(CASES), engine=engine, block_size=BLOCK):
        if not first:  # each worker has done about one block by then
            first, work = time.perf_counter() - begin, -BLOCK * answer.seconds * (getattr(engine, "workers", None) or 1)
        work += answer.seconds
        processor += answer.value["processor"]
    return first, time.perf_counter() - begin - first, work, processor


def used_by_others():
    """Return which share of all processors is in use while this program waits a second; Linux only."""
    counts = []
    for wait in (1.0, 0.0):
        counts.append([int(word) for word in Path("/proc/stat").read_text().split("\n")[0].split()[1:9]])
        time.sleep(wait)
    passed = [later - earlier for earlier, later in zip(*counts, strict=True)]
    return 1 - (passed[3] + passed[4]) / sum(passed)  # idle, and waiting for the disk


def two_against_one(loops):
    """Print the time of one and two workers in turn, with how busy the machine was before each."""
    print(f"{CASES} cases of {1e3 * CASE_SECONDS:.0f} ms in blocks of {BLOCK}, {os.cpu_count()} processors")
    times, used = {1: [], 2: []}, {1: [], 2: []}
    for _ in range(TURNS):
        for workers, measured in times.items():
            others = used_by_others()
            start, seconds, work, processor = timed(ThisMachine(workers), loops)
            measured.append(seconds)
            used[workers].append(processor)
            outside = 1 - work / (workers * seconds)
            print(
                f"  {workers} workers: {seconds:.2f} s, first block after {start:.2f} s, outside the work "
                f"{100 * outside:.1f} %, processors used by others before: {100 * others:.0f} %"
            )
    print(f"  two against one: {min(times[1]) / min(times[2]):.2f} on the clock (fastest of {TURNS} each)")
    print(f"  processor time of two against one: {min(used[2]) / min(used[1]):.2f}, which others disturb less")


def many_rows(count):
    """Print what a row costs where the work costs nothing, and the memory of the process that stores them."""
    for engine, name in ((ThisProcess(), "this process"), (ThisMachine(2), "two workers")):
        with tempfile.TemporaryDirectory() as folder:
            cases = table(count)
            place = Path(folder) / "s"
            run = run_cases(cheap, None, cases, folder=place, identity=IDENTITY, engine=engine, block_size=64)
            size = sum(path.stat().st_size for path in (place / "rows").iterdir())
            again = time.perf_counter()
            run_cases(cheap, None, cases, folder=place, identity=IDENTITY, engine=engine)
            again = time.perf_counter() - again
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(
            f"{count} rows of 14 columns, {name}: {1e6 * run.seconds / count:.0f} us a row, "
            f"opened again in {again:.2f} s, {size / 1e6:.1f} MB, peak memory {peak:.0f} MB"
        )


if __name__ == "__main__":
    loops = loops_of(CASE_SECONDS)
    two_against_one(loops)
    for count in (10_000, 100_000):
        many_rows(count)
    for address in sys.argv[1:]:
        start, seconds, work, _ = timed(Cluster(address), loops)
        print(f"{address}: {seconds:.2f} s, first block after {start:.2f} s, work {work:.2f} s")
