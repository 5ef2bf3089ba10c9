"""A scenario and the catalog entries that it names as files in other units of torque and time.

Every quantity with a unit is scaled as its kind of quantity is; angles, lengths, amperes, euros and kelvins are kept.
Ohms, henries and volts of a motor follow from its power and its amperes; volts of a sensor are kept.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from tests.scaled_rigs import Scale
from torquerig.units import UNITS

# powers of torque and speed
_KINDS = {
    "torque": (1, 0), "force": (1, 0), "inertia": (1, -2), "mass": (1, -2), "speed": (0, 1), "linear speed": (0, 1),
    "frequency": (0, 1), "rate": (0, 1), "time": (0, -1), "angular acceleration": (0, 2), "acceleration": (0, 2),
    "torsional stiffness": (1, 0), "linear stiffness": (1, 0), "rotary damping": (1, -1), "linear damping": (1, -1),
    "quadratic drag": (1, -2), "linear quadratic drag": (1, -2), "sensitivity": (-1, 0), "force sensitivity": (-1, 0),
    "torque constant": (1, 0), "torque constant (per rms ampere)": (1, 0), "power": (1, 1), "energy": (1, 0),
    "flux linkage": (1, 0), "resistance": (1, 1), "inductance": (1, 0), "thermal resistance": (-1, -1),
}  # fmt: skip
_OF_A_MOTOR = {"voltage": (1, 1)}
_NUMBER = re.compile(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?) (\S+)")
SHELVES = ("motors", "gearboxes", "sensors", "couplings")


def scaled_document(value: Any, scale: Scale, *, of_motor: bool = False) -> Any:
    """Return nested data with every text that is a number with a unit scaled, and the limits of criteria too."""
    if isinstance(value, Mapping):
        found = {key: scaled_document(one, scale, of_motor=of_motor) for key, one in value.items()}
        return _criterion(found, scale) if "metric" in found else found
    if isinstance(value, list):
        return [scaled_document(one, scale, of_motor=of_motor) for one in value]
    written = _NUMBER.fullmatch(value) if isinstance(value, str) else None
    if written is None:
        return value
    number, unit = written.groups()
    return f"{float(number) * factor(unit, scale, of_motor=of_motor)!r} {unit}"


def factor(unit: str, scale: Scale, *, of_motor: bool = False) -> float:
    """Return by what a number with this unit is multiplied [1]."""
    powers = _KINDS | (_OF_A_MOTOR if of_motor else {})
    torque, speed = next(
        (powers[kind] for kind, symbols in UNITS.items() if unit in symbols and kind in powers), (0, 0)
    )
    return float(scale.torque**torque * scale.speed**speed)


def _criterion(written: Mapping[str, Any], scale: Scale) -> dict[str, Any]:
    """Return a requirement or criterion whose bare numbers are in its ``unit``."""
    by = factor(str(written.get("unit")), scale)
    found = dict(written)
    for key in ("min", "max"):
        if key in found:
            found[key] = found[key] * by
    if "points" in found:
        found["points"] = {key * by: one for key, one in found["points"].items()}
    if "absolute" in found.get("same_within", {}):
        found["same_within"] = {"absolute": found["same_within"]["absolute"] * by}
    return found


def write_twin(folder: Path, scenario: Path, catalogs: Path, scale: Scale, *, entries: tuple[str, ...]) -> Path:
    """Write ``scenario`` and the catalog ``entries`` scaled below ``folder``, and return the path of the scenario.

    The scaled entries are in ``folder / "catalogs"``, from where they replace the shipped ones of the same name.
    """
    for shelf in SHELVES:
        for name in entries:
            source = catalogs / shelf / f"{name}.yaml"
            if source.is_file():
                data = scaled_document(_read(source), scale, of_motor=shelf == "motors")
                _write(folder / "catalogs" / shelf / source.name, data)
    for name in (scenario.name, "filters.yaml"):
        _write(folder / name, scaled_document(_read(scenario.with_name(name)), scale))
    return folder / scenario.name


def _read(path: Path) -> Any:
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def _write(path: Path, data: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(yaml.safe_dump(data, sort_keys=False), encoding="utf-8")
