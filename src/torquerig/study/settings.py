"""The settings of a study, and which of its metrics need a simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.scenario.sections import read_study_section
from torquerig.scenario.study_section import (
    AllPoints,
    Band,
    CriterionRow,
    Filters,
    Metric,
    Present,
    RequirementRow,
    Settings,
    SpeedLoopRule,
)  # fmt: skip

if TYPE_CHECKING:
    from torquerig.document import Document

__all__ = [
    "SIMULATED", "AllPoints", "Band", "CriterionRow", "Filters", "Metric", "Present", "RequirementRow", "Settings",
    "SpeedLoopRule", "metrics_of", "read_settings",
]  # fmt: skip

SIMULATED: tuple[Metric, ...] = ("truth_error", "disturbance", "residual_disturbance")


def metrics_of(settings: Settings) -> frozenset[Metric]:
    """Return every metric that a requirement or criterion of the study uses."""
    return frozenset(row.metric for rows in (settings.requirements, settings.criteria) for row in rows.values())


def read_settings(document: Document) -> Settings:
    """Return the study of a scenario; InputError with file, line and key where there is none or it cannot be used."""
    if not isinstance(document.data, dict) or "study" not in document.data:
        raise InputError(f"{document.path}: there is no study: section to compare; copy the one of wear_rig.yaml")
    return read_study_section(document)
