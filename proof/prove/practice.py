"""Practice recordings: a folder with one folder per rig, and ``answers.yaml``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from proof.errors import ProofError
from proof.library import CLASSES

ANSWERS = "answers.yaml"


def practice_cases(folder: Path) -> dict[str, Path]:
    """Return the folder of each rig by its name.

    Raises
    ------
    ProofError
        If the folder holds no rigs or no answers.
    """
    if not (folder / ANSWERS).is_file():
        raise ProofError(f"{folder / ANSWERS}: not found; --practice needs a folder of rigs with {ANSWERS}")
    cases = {path.name: path for path in sorted(folder.iterdir()) if any(path.glob("*.parquet"))}
    if not cases:
        raise ProofError(f"{folder}: no folder with recordings (.parquet) in it")
    return cases


def practice_answers(folder: Path) -> dict[str, dict[str, Any]]:
    """Return the answers in the form of the sealed ones, by the name of the rig."""
    stated = yaml.safe_load((folder / ANSWERS).read_text(encoding="utf-8"))
    return {name: _answer(row["left_out"]) for name, row in stated.items()}


def _answer(left_out: dict[str, dict[str, Any]]) -> dict[str, Any]:
    effects = [_effect(name, stated) for name, stated in left_out.items()]
    outside = any(not effect["in_library"] for effect in effects)
    return {
        "verdict": "unexplained" if outside else "missing_physics" if effects else "adequate",
        "wrong_parameters": False,
        "effects": effects,
        "plan": "practice",
    }


def _effect(name: str, stated: dict[str, Any]) -> dict[str, Any]:
    known = name in CLASSES
    return {
        "mechanism": name,
        "in_library": known,
        "size": 0.5,
        "also_right": [],
        "parameters": _PARAMETERS.get(name, dict)(stated) if known else {},
    }


def _mesh(stated: dict[str, Any]) -> dict[str, float]:
    return {"order_output": stated["teeth"], "transmission_error_rad": stated["amplitudes_rad"][0]}


def _mains(stated: dict[str, Any]) -> dict[str, float]:
    return {"frequency_Hz": 50.0 * stated["grid"], "amplitude_V": stated["amplitudes_V"][0]}


def _blades(stated: dict[str, Any]) -> dict[str, float]:
    return {"order_output": stated["blades"], "amplitude_Nm": stated["amplitude_Nm"]}


def _gap(stated: dict[str, Any]) -> dict[str, float]:
    return {"gap_arcmin": stated["arcmin"]}


_PARAMETERS = {"gear_mesh": _mesh, "mains_interference": _mains, "blade_pass": _blades, "backlash": _gap}
