"""How many of 100 random rigs agree with 16 times finer steps, or warn: ``python -m benchmarks.random_rigs --first 0``.

A rig passes where the torque of its sensor differs by at most 1e-3 of its rms over a second, or where the run warns of
its step. ``--first`` is the seed of the first rig. Where the run or its finer one fails with an error, that is counted
by itself. Prints each rig that differs, warns or fails, and the counts.
"""

from __future__ import annotations

from argparse import ArgumentParser
from collections import Counter

from tests.simulation.test_step_watch import ALLOWED, agree_or_warn
from torquerig.errors import SimulationError

RIGS = 100


def verdict(seed: int) -> tuple[str, str]:
    """Return what became of one rig, and its figure."""
    try:
        change, warned = agree_or_warn(seed)
    except SimulationError as error:
        return "fails, or its finer run does", str(error)[:90]
    if change <= ALLOWED:
        return ("agrees, with a warning" if warned else "agrees"), f"{change:.1e}"
    return ("differs, with a warning" if warned else "DIFFERS SILENTLY"), f"{change:.1e}"


if __name__ == "__main__":
    options = ArgumentParser()
    options.add_argument("--first", type=int, default=0)
    first = options.parse_args().first
    counts: Counter[str] = Counter()
    for seed in range(first, first + RIGS):
        what, figure = verdict(seed)
        counts[what] += 1
        if what != "agrees":
            print(f"rig {seed:3d}: {what} ({figure})", flush=True)
    print(dict(counts))
