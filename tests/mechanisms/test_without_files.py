"""A mechanism is its file: without it the rest works, and a diagnosis knows one name less."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import torquerig

GONE = (
    "gear_mesh", "commutation_ripple", "cogging", "blade_pass", "mains_interference", "pwm_aliasing",
    "torsional_mode", "sensor_bandwidth", "bearing_defect", "quadratic_drag", "stribeck_friction", "sensor_drift",
    "clipping", "quantization", "signal_dropout", "backlash",
)  # fmt: skip
EVERY_MODULE = """
import importlib, pkgutil, torquerig
from torquerig import mechanisms
for found in pkgutil.walk_packages(torquerig.__path__, "torquerig."):
    if not found.name.endswith("__main__"):
        importlib.import_module(found.name)
print(torquerig.__path__[0], *sorted(mechanisms.__all__))
"""


@pytest.mark.long
def test_every_module_imports_without_the_files_of_all_that_a_diagnosis_names(tmp_path: Path) -> None:
    copy = tmp_path / "torquerig"
    shutil.copytree(torquerig.__path__[0], copy, ignore=shutil.ignore_patterns("__pycache__"))
    for name in GONE:
        (copy / "mechanisms" / f"{name}.py").unlink()
    made = subprocess.run(
        [sys.executable, "-c", EVERY_MODULE], env={**os.environ, "PYTHONPATH": str(tmp_path)}, cwd=tmp_path,
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert made.returncode == 0, made.stderr
    where, *left = made.stdout.split()
    assert Path(where) == copy
    words = {name.replace("_", "") for name in GONE}
    assert "ParticleLoad" in left
    assert not words & {name.lower() for name in left}
