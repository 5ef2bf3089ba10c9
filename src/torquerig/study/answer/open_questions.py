"""Requirements on the winner of a study that a missing value leaves open, as questions."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.study.rated_drives import feasible_combinations

if TYPE_CHECKING:
    from torquerig.study.scoring import Decided


@dataclass(frozen=True, kw_only=True)
class OpenQuestion:
    """One missing value that decides whether the winner meets a requirement.

    Parameters
    ----------
    missing : str
        The missing value: ``whether M1 is a servo motor``, ``maximum speed of M1``.
    requirement, rule : str
        Name of the requirement, and its formula with the limit.
    is_of_present_parts : bool
        Whether the value belongs to parts that are on the rig: their owner can answer it without a purchase.
    remaining : tuple of str
        Combinations that no requirement eliminates and that do not depend on this value, the best first.
    """

    missing: str
    requirement: str
    rule: str
    is_of_present_parts: bool
    remaining: tuple[str, ...]

    def sentence(self) -> str:
        """Return the question as a sentence."""
        yes_or_no = re.fullmatch(r"whether (\S+) is (.+)", self.missing)
        if yes_or_no:
            return f"is {yes_or_no[1]} {yes_or_no[2]}?"
        return f"what is the {self.missing}? The requirement is {self.rule}."

    def condition(self) -> str:
        """Return the condition under which the winner stays: ``M1 is a servo motor``."""
        return self.missing.removeprefix("whether ") if self.missing.startswith("whether ") else f"{self.rule} holds"


def open_questions(decided: Decided, winner: str) -> tuple[OpenQuestion, ...]:
    """Return the open requirements on the drive of a combination, in the order of the elimination."""
    drive = decided.alternatives[winner].drive
    row = next(one for one in decided.chart.rows if one.alternative == drive.candidate.name)
    present = decided.alternatives[decided.baseline].drive.candidate
    found = []
    for remark in row.remarks:
        if not remark.missing:
            continue
        drives = _drives_with(decided, remark.missing)
        remaining = tuple(
            name for name in feasible_combinations(decided)
            if decided.alternatives[name].drive.candidate.name not in drives
        )  # fmt: skip
        found.append(
            OpenQuestion(
                missing=remark.missing, requirement=remark.criterion, rule=remark.rule,
                is_of_present_parts=_names_only(remark.missing, (present.motor, present.gearbox)), remaining=remaining,
            )
        )  # fmt: skip
    return tuple(found)


def _drives_with(decided: Decided, missing: str) -> set[str]:
    """Return the drives for which this missing value leaves a requirement open."""
    return {row.alternative for row in decided.chart.rows if missing in row.missing}


def _names_only(missing: str, parts: tuple[str, ...]) -> bool:
    """Return whether each value in a list of missing values belongs to one of these parts."""
    values = missing.split(", ")
    return all(any(re.search(rf"(of|whether) {re.escape(part)}\b", one) for part in parts if part) for one in values)
