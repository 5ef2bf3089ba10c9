"""Compare the results of two checkouts: the same bytes of tables and recordings, the same numbers of a diagnosis.

For moves and renames, which must change no result::

    python tests/same_results.py OLD_CHECKOUT NEW_CHECKOUT [--practice FOLDER]

Each command runs in both checkouts in a folder of its own, with the ``src`` of that checkout first on the path. Exit
code 1 where a result differs. Texts may differ: of a diagnosis only numbers and names of mechanisms are compared.
``--practice`` names a folder with ``*.parquet`` runs of one wear rig; without it no diagnosis is made.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

COMMANDS: dict[str, tuple[list[str], tuple[str, ...]]] = {
    "compare": (["compare", "{root}/scenarios/wear_rig.yaml", "--out", "study"],
                ("study/combinations.csv", "study/shares.csv")),
    "simulate": (["simulate", "{root}/scenarios/wear_rig.yaml", "--out", "run.parquet"], ("run.parquet",)),
    "simulate_branch": (["simulate", "{root}/scenarios/two_stage_branch.yaml", "--out", "branch.parquet"],
                        ("branch.parquet",)),
    "filter": (["filter", "run.parquet", "--chain", "order_lines", "--out", "clean.parquet"], ("clean.parquet",)),
}  # fmt: skip
TEXTS = {"explanation", "metric", "schema", "provenance", "next_experiment", "model"}


def run(root: Path, folder: Path, practice: Path | None) -> dict[str, str]:
    """Run all commands of one checkout in ``folder`` and return a digest per result."""
    digests: dict[str, str] = {}
    for name, (arguments, results) in COMMANDS.items():
        torquerig(root, folder, [word.format(root=root) for word in arguments], name)
        for result in results:
            digests[result] = hashlib.sha256((folder / result).read_bytes()).hexdigest()
    if practice is not None:
        runs = [str(path) for path in sorted(practice.glob("*.parquet"))]
        scenario = str(root / "scenarios" / "wear_rig.yaml")
        torquerig(root, folder, ["diagnose", *runs, "--scenario", scenario, "--json", "diagnosis.json"], "diagnose")
        numbers = json.dumps(without_texts(json.loads((folder / "diagnosis.json").read_text())), sort_keys=True)
        digests["diagnosis.json"] = hashlib.sha256(numbers.encode()).hexdigest()
    return digests


def torquerig(root: Path, folder: Path, arguments: list[str], name: str) -> None:
    """Run one command line with the sources of ``root``."""
    environment = os.environ | {"PYTHONPATH": str(root / "src"), "MPLBACKEND": "Agg"}
    done = subprocess.run([sys.executable, "-m", "torquerig", *arguments], cwd=folder, env=environment,
                          capture_output=True, text=True, check=False)  # fmt: skip
    if done.returncode != 0:
        raise SystemExit(f"{root}: {name} failed with exit code {done.returncode}: {done.stderr.strip()}")


def without_texts(value: Any) -> Any:
    """Return a JSON value without its sentences."""
    if isinstance(value, dict):
        return {key: without_texts(part) for key, part in value.items() if key not in TEXTS}
    return [without_texts(part) for part in value] if isinstance(value, list) else value


def main() -> None:
    """Print a line per result; exit 1 where one differs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--practice", type=Path)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
        practice = given.practice.resolve() if given.practice else None
        old = run(given.old.resolve(), Path(first), practice)
        new = run(given.new.resolve(), Path(second), practice)
    for name, digest in old.items():
        print(f"{'same   ' if new[name] == digest else 'DIFFERS'}  {name}")
    sys.exit(int(old != new))


if __name__ == "__main__":
    main()
