"""A call of every command that writes JSON, on small inputs, by the name of its schema."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main

SCENARIOS = shipped_scenarios()
WEAR_RIG = str(SCENARIOS / "wear_rig.yaml")
SMALL_STUDY = (
    WEAR_RIG, "--set", "study.motors=[bldc-12n14p]", "--set", "study.gearboxes=[reference-5-1]",
    "--set", "study.draws=0", "--set", "study.duration=2s",
)  # fmt: skip
MIXTURE = """\
synthetic: a load
duration: 2 s
sample_rate: 2 kHz
seed: 5
components:
  load: {type: sine, amplitude: 0.3 N*m, frequency: 3 Hz, part: load}
  noise: {type: white_noise, rms: 0.01 N*m}
"""
QUICK: dict[str, tuple[str, ...]] = {
    "batch": ("batch", "info", "folder"),
    "cache": ("cache", "--cache", "kept"),
    "catalog-check": ("catalog", "check", str(SCENARIOS.parent / "catalogs" / "gearboxes")),
    "catalog-export": ("catalog", "export", "reference-5-1", "gear.xml"),
    "catalog-import": ("catalog", "import", "given.xml", "gearbox.yaml"),
    "catalog-list": ("catalog",),
    "catalog-new": ("catalog", "new", "motor.yaml"),
    "catalog-show": ("catalog", "show", "bldc-12n14p"),
    "diagnose-check": ("diagnose", "run.parquet", "--scenario", WEAR_RIG, "--check"),
    "differ": ("differ", "run.parquet", "run.parquet"),
    "duty": ("duty", WEAR_RIG),
    "filter": ("filter", "run.parquet"),
    "info": ("info", "run.parquet"),
    "init": ("init", "new"),
    "join": ("join", "run.parquet", "--out", "joined.csv"),
    "matrix": ("matrix", str(SCENARIOS / "matrix_example.yaml")),
    "modes": ("modes", WEAR_RIG),
    "ordermap": ("ordermap", "run.parquet"),
    "orders": ("orders", "--scenario", WEAR_RIG),
    "sheet": ("sheet", "bare.csv"),
    "simulate": ("simulate", WEAR_RIG, "--duration", "1 s", "--out", "made.parquet"),
    "synth-control": ("synth", "control", "--duration", "1 s", "--out", "control.csv"),
    "synth-effects": ("synth", "effects", WEAR_RIG, "--duration", "1 s", "--out", "effects.parquet"),
    "synth-fault": ("synth", "fault", "dropouts", "--out", "fault.parquet"),
    "synth-mixture": ("synth", "mixture", "mixture.yaml", "--out", "mixed.csv"),
    "synth-pair": ("synth", "pair", "mixture.yaml", "--out", "pair.csv"),
    "synth-sweep": ("synth", "sweep", "--duration", "1 s", "--out", "sweep.csv"),
}
SLOW: dict[str, tuple[str, ...]] = {
    "compare": ("compare", *SMALL_STUDY),
    "diagnosis": ("diagnose", "run.parquet", "--scenario", WEAR_RIG, "--workers", "1"),
    "optimise": ("optimise", *SMALL_STUDY, "--evaluations", "16"),
    "size": ("size", WEAR_RIG),
    "study": ("study", *SMALL_STUDY, "--draws", "2", "--workers", "1"),
}
FULL: dict[str, tuple[str, ...]] = {
    "compare-points": (
        "compare",
        *SMALL_STUDY,
        "--all-points",
        "--set",
        "study.all_points={occupancy: [5 %], particle_size: [0.5 mm]}",
    ),
    "reference-decision": ("reference-decision", "--draws", "0"),
    "reference-results": ("reference-results",),
}
CALLS = [
    *(pytest.param(name, call, id=name) for name, call in QUICK.items()),
    *(pytest.param(name, call, marks=pytest.mark.long, id=name) for name, call in SLOW.items()),
    *(pytest.param(name, call, marks=pytest.mark.full, id=name) for name, call in FULL.items()),
]


def make_inputs(folder: Path) -> None:
    """Write the inputs of all calls into a folder."""
    (folder / "mixture.yaml").write_text(MIXTURE, encoding="utf-8")
    rows = "\n".join(f"{number / 1000},{number % 7}" for number in range(2000))
    (folder / "bare.csv").write_text(f"time_s,torque_V\n{rows}\n", encoding="utf-8")
    (folder / "folder").mkdir()
    (folder / "folder" / "one.csv").write_text(f"time_s,torque_Nm\n{rows}\n", encoding="utf-8")
    main(["catalog", "export", "reference-5-1", str(folder / "given.xml")])
    main(["simulate", WEAR_RIG, "--duration", "4 s", "--rate", "5 kHz", "--out", str(folder / "run.parquet")])
