"""What is shown and written of a diagnosis."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

from torquerig.reporting.diagnosis.page_answer import DiagnosisAnswer
from torquerig.rig.assembly import Rig


class LinesOf(Protocol):
    """The answer for the terminal, from the diagnosis in the contract's form."""

    def __call__(self, data: Mapping[str, Any]) -> list[str]:
        """Return the lines."""


class PageOf(Protocol):
    """The page, from the diagnosis in the contract's form."""

    def __call__(self, data: Mapping[str, Any], *, command: str, model: str | None) -> str:
        """Return the HTML; ``command`` reproduces it, ``model`` is the file of the completed scenario."""


@dataclass(frozen=True)
class Diagnosed:
    """A diagnosis.

    Parameters
    ----------
    data : dict
        In the contract's form, without ``model`` and ``provenance``.
    completed : Rig or None
        The rig with what was found; None where nothing was.
    sentence : str
        The verdict in sentences.
    answer : callable
        Returns what a reader sees first.
    lines, page : callable
        All three are computed when they are needed.
    """

    data: dict[str, Any]
    completed: Rig | None
    sentence: str
    answer: Callable[[], DiagnosisAnswer]
    lines: LinesOf
    page: PageOf
