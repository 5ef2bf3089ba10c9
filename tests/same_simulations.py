"""Compare what two checkouts simulate: the same bytes for every mechanism, alone and all together, and the same modes.

For changes of the simulation's structure, which must change no result; ``same_results.py`` compares the commands::

    python tests/same_simulations.py OLD_CHECKOUT NEW_CHECKOUT

Each checkout needs this file, ``tests/mechanisms/test_every_mechanism_obeys_its_laws.py`` and its rigs. Every mechanism
is simulated on both rigs of that file, singly, side by side with other seeds, and by the exact linear path; the linear
twin gives matrices, modes and order lines. Exit code 1 where something differs; the order of sentences does not count.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np


def digests() -> dict[str, Any]:
    """Return what the checkout on the path simulates, by mechanism and way, each array as a checksum."""
    from tests.mechanisms.test_every_mechanism_obeys_its_laws import ROWS, crowded, rig
    from torquerig.errors import TorquerigError
    from torquerig.recordings.recording import Recording
    from torquerig.simulation.batch import simulate_batch
    from torquerig.simulation.linear_path import simulate_linear
    from torquerig.simulation.simulator import simulate

    def recorded(made: Recording) -> dict[str, str]:
        return {name: checksum(channel.values) for name, channel in made.channels.items()}

    def of(what: Callable[[], Any]) -> Any:
        try:
            return what()
        except TorquerigError as error:  # the linear path has not all
            return str(error)

    found: dict[str, Any] = {}
    short = {"duration": 0.1, "settling": 0.1}
    rigs = {
        f"{row.effect.kind}, {name}": made
        for row in ROWS
        for name, made in (
            ("crowded", crowded(row.effect)), ("alone", rig(*row.others, row.effect, speed_rpm=700.0)),
        )
    }  # fmt: skip
    rigs["all together"] = crowded(*(replace(row.effect, name=row.effect.kind) for row in ROWS))
    for name, made in rigs.items():
        found[f"{name}: simulated"] = of(lambda made=made: recorded(simulate(made, seed=5, **short)))
        found[f"{name}: side by side"] = of(
            lambda made=made: [recorded(one) for one in simulate_batch([made] * 3, seeds=(1, 2, 3), **short)]
        )
        found[f"{name}: linear"] = of(lambda made=made: recorded(simulate_linear(made, seed=2, **short)))
        found[f"{name}: twin"] = of(lambda made=made: twin(made))
    return found


def twin(rig: Any) -> dict[str, Any]:
    """Return checksums of a rig's linear matrices, its modes, its order lines and the sorted sentences of its twin."""
    from torquerig.simulation.linear import matrices
    from torquerig.simulation.twin.linear_twin import twin_of

    made = twin_of(rig)
    found = {f"stiffest {way}": matrices(made.lowered, stiffest=way) for way in (False, True)}
    arrays = {name: (one.mass, one.damping, one.stiffness) for name, one in found.items()}
    system = made.closed_loop
    arrays |= {"closed loop": (system.A, system.B, system.C, system.D), "sampled": (made.sampled_loop.A,)}
    return {name: [checksum(one) for one in each] for name, each in arrays.items()} | {
        "modes": [repr(mode) for mode in made.modes()],
        "lines": [repr(line) for line in made.order_lines()],
        "left out": sorted(made.point.left_out),
    }


def checksum(values: Any) -> str:
    """Return the checksum of an array's bytes."""
    return hashlib.sha256(np.ascontiguousarray(values).tobytes()).hexdigest()[:16]


def of_checkout(root: Path) -> dict[str, Any]:
    """Return the digests that a checkout makes in an interpreter of its own."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join((str(root / "src"), str(root)))}
    done = subprocess.run(
        [sys.executable, "-m", "tests.same_simulations"], cwd=root, env=environment, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    if done.returncode:
        raise SystemExit(f"{root}: {done.stderr.strip()}")
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def main(old: Path, new: Path) -> int:
    """Print what differs between two checkouts; 1 where something does."""
    before, after = (of_checkout(root.resolve()) for root in (old, new))
    differing = [name for name in sorted({*before, *after}) if before.get(name) != after.get(name)]
    sys.stdout.write("\n".join([f"{len(before)} results compared, {len(differing)} differ", *differing, ""]))
    return 1 if differing else 0


if __name__ == "__main__":
    if len(sys.argv) == 1:
        sys.stdout.write(json.dumps(digests()))
    else:
        raise SystemExit(main(*map(Path, sys.argv[1:])))
