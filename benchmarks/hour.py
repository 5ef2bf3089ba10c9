"""An hour at 25 kHz (90 million samples) through ``torquerig filter``: seconds, times real time, and peak memory.

Run with ``python benchmarks/hour.py``; ``--minutes 6`` for a quick look, ``--format tdms``, ``--chain NAME`` (several
compare chains of one pass). The file is made block by block in a folder that is removed afterwards. Each run is a child
process of its own, so that its peak memory (``ru_maxrss``) is its own; next to it stands a run of the chain ``none``:
reading and telling alone.
"""

from __future__ import annotations

import argparse
import resource
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from child import cost_of

from torquerig.recordings.files.block_writing import write_blocks
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, BLOCK = 25_000.0, 2**20
SPEED = 1000 * 2 * np.pi / 60
# motor orders of a 12-slot 14-pole drive at 5:1, each 0.05 N m
ORDERS = (0.2, 0.4, 1.0, 2.0, 6.0, 7.0, 12.0, 14.0, 16.8, 28.0, 33.6, 42.0)
COUNTS = 16384


def blocks(samples: int) -> Iterator[Recording]:
    """Give a wear rig's torque and encoder: load, twelve lines under 0.5 % of speed wander, noise."""
    rng = np.random.default_rng(1)
    for first in range(0, samples, BLOCK):
        count = min(BLOCK, samples - first)
        time_s = (first + np.arange(count)) / RATE
        angle = SPEED * (time_s + 0.005 * 3 * np.sin(time_s / 3))
        torque = 1.0 + 0.1 * np.sin(2 * np.pi * 0.3 * time_s) + 0.05 * rng.standard_normal(count)
        for order in ORDERS:
            torque += 0.05 * np.cos(order * angle)
        yield Recording(
            sample_rate=RATE,
            channels={
                "torque_V": Channel(values=torque, quantity="torque", unit="V"),
                "encoder_count": Channel(
                    values=np.floor(angle * (COUNTS / (2 * np.pi))), quantity="motor_angle", unit="count",
                    si_per_unit=2 * np.pi / COUNTS,
                ),
            },
            run=Run(motor="bldc-12n14p", gear_ratio=5.0, speed=SPEED),
            origin={"benchmark": "hour"},
        )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--format", choices=("parquet", "tdms", "csv", "mat"), action="append")
    parser.add_argument("--chain", action="append", help="default: what the command itself takes")
    parser.add_argument("--out", action="store_true", help="write the filtered recording too (one chain)")
    parser.add_argument("--info", action="store_true", help="torquerig info instead")
    options = parser.parse_args()
    samples = int(options.minutes * 60 * RATE)
    for ending in options.format or ("tdms", "parquet"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"hour.{ending}"
            write_blocks(blocks(samples), path)
            print(f"{samples / 1e6:.1f} M samples, 2 channels, {path.stat().st_size / 1e6:.0f} MB of {ending}")
            chains = [word for name in options.chain or () for word in ("--chain", name)]
            wanted = {"chain none": ["filter", str(path), "--chain", "none"], "filter": ["filter", str(path), *chains]}
            if options.out:
                wanted["filter"] += ["--out", str(Path(folder) / f"out.{ending}")]
            if options.info:
                wanted = {"info": ["info", str(path)]}
            for name, arguments in wanted.items():
                cost = cost_of(arguments)
                times = samples / RATE / cost.seconds
                print(
                    f"{name:>10}: {cost.seconds:6.1f} s ({cost.processor:.1f} s of processor), {times:5.0f} x real "
                    f"time, peak {cost.megabytes:.0f} MB"
                )
            print(cost.told)
    print(f"(this process: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB)")


if __name__ == "__main__":
    main()
