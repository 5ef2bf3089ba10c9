"""Sheets, column heads and settings of the Excel form of a matrix, for writing and for reading."""

from __future__ import annotations

from typing import Final

CRITERIA, FACTS, SETTINGS, SOURCES = "Criteria", "Facts", "Settings", "Sources"
"""The sheets that are read back; all others are calculated from them."""

KNOT, POINTS = "value {}", "points {}"
"""Heads of the columns of a value function, numbered from 1."""

CRITERION_HEADS: Final = (
    "criterion", "unit", "better", "weight", "kind", "requirement min", "requirement max", "in question",
    "band low", "band high", "same within", "same within share", "purpose",
)  # fmt: skip
NEEDED_OF_CRITERIA: Final = ("criterion", "weight")

FACT_HEAD: Final = "alternative"
LOW, HIGH = "{} low", "{} high"

SOURCE_HEADS: Final = (
    "alternative", "criterion", "source", "evidence", "note", "missing", "fact", "metric", "origins", "by hand value",
    "by hand points", "reason",
)  # fmt: skip
NEXT, WITHIN = "; ", " | "
"""Between two origins of a cell, and between name, value, evidence and source of one."""
NEEDED_OF_SOURCES: Final = ("alternative", "criterion")

SETTING_KEYS: Final = (
    "name", "baseline", "scale min", "scale max", "goal", "goal words", "draws", "seed", "uncertainty scores",
    "uncertainty weights", "cost criterion", "permissible cost",
)  # fmt: skip

OLD_NAMES: Final = {
    "demand min": "requirement min", "demand max": "requirement max", "datum": "baseline",
    "doubt scores": "uncertainty scores", "doubt weights": "uncertainty weights",
}  # fmt: skip
"""Heads and settings that files of earlier versions have, and the names that they have now."""
