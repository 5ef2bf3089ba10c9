"""The YAML of a stage in general: its type and values, with lines named by cause and harmonic."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict

from torquerig.errors import did_you_mean
from torquerig.filters.chains.renamed_chains import current_family
from torquerig.filters.load_response import LoadResponse
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.line_families import FAMILIES, Family
from torquerig.recordings.stage import Stage

_HIGHEST_HARMONIC = 100
_RANGE = re.compile(r"^\s*(\d+)\s*(?:\.\.\s*(\d+)\s*)?$")

Made = tuple[Stage, tuple[str, ...]]


def _harmonics(written: Any) -> tuple[int, ...]:
    texts = written if isinstance(written, list) else [written]
    numbers: set[int] = set()
    for text in texts:
        match = None if isinstance(text, bool) else _RANGE.match(str(text))
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
        if not 1 <= first <= last <= _HIGHEST_HARMONIC:
            raise ValueError(
                f"{text!r} names no harmonics; write for example 1..4, or 2, or [1, 3]; 1 is the fundamental"
            )
        numbers.update(range(first, last + 1))
    if not numbers:
        raise ValueError("no harmonics are named; write for example 1..4")
    return tuple(sorted(numbers))


def _family_names(written: Any) -> Any:
    if not isinstance(written, dict) or not written:
        raise ValueError(
            f"lines are named by cause; write for example {{motor: 1..4}}; known are {', '.join(FAMILIES)}"
        )
    current = {current_family(str(name)): harmonics for name, harmonics in written.items()}
    for name in current:
        if name not in FAMILIES:
            raise ValueError(f"no lines have the cause {name!r}; {did_you_mean(name, FAMILIES)}")
    if len(current) < len(written):
        raise ValueError(f"a cause has its old and its present name; keep one of {', '.join(map(str, written))}")
    return current


Harmonics = Annotated[tuple[int, ...], BeforeValidator(_harmonics)]
Lines = Annotated[dict[Family, Harmonics], BeforeValidator(_family_names)]


class StageForm(BaseModel, ABC):
    """The YAML of one stage, from which the stage for one drive is made."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @abstractmethod
    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the stage for one drive, and those of its lines that the drive does not have.

        ``response`` is the rig's response from load to sensor, where a model is known.
        """
