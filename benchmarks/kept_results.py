"""What a comparison costs again: after a weight, a trace, one changed motor, another occupancy, and after kill -9.

Each figure is measured in this run, in a new process with a new cache folder, start of Python included. The limit of
what simulates nothing is 1 s; what simulates one motor is compared with a study of that motor alone. Processor time is
what counts where other programs run at the same time; wall time needs a quiet machine.

Run: python benchmarks/kept_results.py [length of a recording, such as '2 s'; 10 s is that of the shipped study]
"""

import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LIMIT, ALIKE = 1.0, 1.3  # [s] of what simulates nothing; [1] of one motor among thirty drives to that motor alone
MOTOR = "GP-71M"
SCENARIO = "scenarios/wear_rig.yaml"
CELL = ("bldc-12n14p 5:1", "reading error")
root = Path(__file__).resolve().parents[1]
usual = {name: text for name, text in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
length = sys.argv[1] if len(sys.argv) > 1 else "10 s"


def command(folder, *options):
    """Return the command of a comparison whose scenario, catalog, cache and report are in ``folder``."""
    return [sys.executable, "-m", "torquerig", "compare", f"{folder}/{SCENARIO}", "--out",
            f"{folder}/report", "--cache", f"{folder}/cache", *options]  # fmt: skip


def taken(folder, *options):
    """Return wall time [s], processor time [s], and how many drives were read from the cache."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command(folder, *options), check=True, capture_output=True, text=True, env=usual)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return wall, spent, re.findall(r"(\d+ of \d+) drives from the cache", done.stderr)[0]


def shown(name, found, *, limit=None, ratio_to=None):
    """Print a figure, with its limit in seconds of processor time, or its ratio to another figure."""
    wall, spent, kept = found
    judged = "" if limit is None else f", limit {limit:g} s: {'holds' if spent <= limit else 'EXCEEDED'}"
    if ratio_to is not None:
        ratio = spent / ratio_to[1]
        judged = f", {ratio:.2f} of that motor alone, limit {ALIKE:g}: {'holds' if ratio <= ALIKE else 'EXCEEDED'}"
    print(f"{name:42s} {wall:6.2f} s, {spent:6.2f} s of processor time, {kept} drives were kept{judged}", flush=True)


def copied(place, motors="all", occupancy=None):
    """Return a folder with scenario and catalogs that may be changed: length and motors, and occupancy where given."""
    shutil.copytree(root / "scenarios", place / "scenarios")
    shutil.copytree(root / "catalogs", place / "catalogs")
    edited(place / SCENARIO, r"^study:\n  duration: 10 s", f"study:\n  duration: {length}")
    edited(place / SCENARIO, r"^  motors: all", f"  motors: {motors}")
    if occupancy:
        edited(place / SCENARIO, r"^(  load: .*occupancy: )[^,}]+", rf"\g<1>{occupancy}")
    return place


def edited(path, pattern, text):
    """Replace the one match of a pattern in a file."""
    new, count = re.subn(pattern, text, path.read_text(), flags=re.MULTILINE)
    assert count == 1, (path, pattern)
    path.write_text(new)


with tempfile.TemporaryDirectory() as made:
    few = copied(Path(made) / "few", motors="[bldc-12n14p]")
    taken(few)  # compiles what is not compiled yet, and keeps what is compared with
    alone = taken(copied(Path(made) / "alone", motors="[bldc-12n14p]", occupancy="11 %"))
    shown("one motor at another occupancy, nothing kept", alone)
    shown("--set load.occupancy=11 on one motor", taken(few, "--set", "load.occupancy=11"), ratio_to=alone)
    edited(few / SCENARIO, r"^  motors: .*", f"  motors: [bldc-12n14p, {MOTOR}]")
    alone = taken(few)
    shown("a further motor in a study of one", alone)

    folder = copied(Path(made) / "all")
    shown("the whole study", taken(folder))
    edited(folder / SCENARIO, r"weight: 0\.35", "weight: 0.34")
    shown("again after a weight change", taken(folder), limit=LIMIT)
    edited(folder / SCENARIO, r"min: 1\.5", "min: 1.4")
    shown("again after a change of a limit", taken(folder), limit=LIMIT)
    shown("--trace of one cell", taken(folder, "--trace", *CELL), limit=LIMIT)
    path = next(file for file in (folder / "catalogs/motors").glob("*.yaml") if f"name: {MOTOR}\n" in file.read_text())
    edited(path, r"^title: \"", 'title: "changed ')
    shown("the whole study with one changed motor", taken(folder), ratio_to=alone)

    killed = copied(Path(made) / "killed")
    process = subprocess.Popen(command(killed), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while sum(1 for _ in (killed / "cache").rglob("results/*/*")) < 8 and process.poll() is None:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    shown("the rest after kill -9", taken(killed))
