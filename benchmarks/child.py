"""A ``torquerig`` command as a process of its own, with what it cost."""

from __future__ import annotations

import subprocess
import sys
import time
from dataclasses import dataclass

_CODE = (
    "import resource, sys; from torquerig.cli import main; main(sys.argv[1:]); "
    "used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]; "
    "print(sum(each.ru_utime + each.ru_stime for each in used), max(each.ru_maxrss for each in used), file=sys.stderr)"
)


@dataclass(frozen=True)
class Cost:
    """Seconds on the clock, of processor with all workers, peak memory of the largest process [MB], and the text."""

    seconds: float
    processor: float
    megabytes: float
    told: str


def cost_of(arguments: list[str]) -> Cost:
    """Return what the command ``torquerig arguments`` cost; it ends the benchmark where the command fails."""
    start = time.perf_counter()
    run = subprocess.run([sys.executable, "-c", _CODE, *arguments], capture_output=True, text=True, check=False)
    seconds = time.perf_counter() - start
    if run.returncode:
        raise SystemExit(run.stderr)
    unit = 1 if sys.platform == "darwin" else 1024
    processor, peak = run.stderr.split()[-2:]
    return Cost(seconds, float(processor), int(peak) * unit / 1e6, run.stdout)
