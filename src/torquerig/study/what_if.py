"""Differences between an edited study and the original one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.study.results import DriveResult, StudyRuns


@dataclass(frozen=True, kw_only=True)
class Change:
    """One drive before and after an edit; ``None`` where it was not simulated.

    ``error`` is the smallest reading error over the study's filters, ``chain`` the filter that gives it.
    """

    before: str
    after: str
    chain_before: str
    chain_after: str
    error_before: float | None
    error_after: float | None
    disturbance_before: float | None
    disturbance_after: float | None


def changes(original: StudyRuns, edited: StudyRuns) -> tuple[Change, ...]:
    """Return every drive of the edited study with the same motor and gearbox of the original one."""
    known = {(drive.candidate.motor, drive.candidate.gearbox): drive for drive in original.drives}
    found = []
    for drive in edited.drives:
        before = known.get((drive.candidate.motor, drive.candidate.gearbox))
        chain_before, error_before = _best(before)
        chain_after, error_after = _best(drive)
        found.append(
            Change(
                before=before.candidate.name if before else "-",
                after=drive.candidate.name,
                chain_before=chain_before,
                chain_after=chain_after,
                error_before=error_before,
                error_after=error_after,
                disturbance_before=before.disturbance.value if before else None,
                disturbance_after=drive.disturbance.value,
            )
        )
    return tuple(found)


def _best(drive: DriveResult | None) -> tuple[str, float | None]:
    errors = {} if drive is None else {name: result.truth_error.value for name, result in drive.chains.items()}
    known = {name: error for name, error in errors.items() if error is not None}
    if not known:
        return "-", None
    best = min(known, key=lambda name: known[name])
    return best, known[best]
