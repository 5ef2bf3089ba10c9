"""Names of missing values, in the words of a question to the maker."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.study.candidate import Candidate


def missing_data_text(missing: str, candidate: Candidate) -> str:
    """Return the missing values of a figure as text; ``missing`` may name fields of the drive's parts.

    The lines of a simulated motor depend on many values, which one measurement gives; they get one common name. Motor
    and gearbox are named, so that equal texts mean the same value everywhere.
    """
    motor, stage = candidate.parts.motor, candidate.parts.stage
    if f"{motor}.ripple." in missing:
        return f"measured cogging and ripple of {candidate.motor}"
    fields: dict[str, list[str]] = {}
    for one in missing.split(", "):
        part, _, field = one.partition(".")
        owner = {motor: candidate.motor, stage: candidate.gearbox}.get(part, "")
        fields.setdefault(owner, []).append(field.replace("_", " ") if owner else one)
    texts = [f"{', '.join(names)} of {owner}" if owner else ", ".join(names) for owner, names in fields.items()]
    return ", ".join(texts)
