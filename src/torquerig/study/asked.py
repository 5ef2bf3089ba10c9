"""What is missing, in the words in which a buyer can ask for it."""

from __future__ import annotations

from torquerig.study.candidates import Candidate


def in_words(missing: str, candidate: Candidate) -> str:
    """Return what a figure misses as a buyer can ask for it; ``missing`` may name fields of the drive's parts.

    The lines of a simulated motor hang on many data at once, which one measurement gives; they are asked for together.
    Motor and gearbox are named, so that the same words mean the same datum wherever they stand.
    """
    if "motor.ripple." in missing:
        return f"measured cogging and ripple of {candidate.motor}"
    fields: dict[str, list[str]] = {}
    for one in missing.split(", "):
        part, _, field = one.partition(".")
        owner = {"motor": candidate.motor, "gear": candidate.gearbox, "gearbox": candidate.gearbox}.get(part, "")
        fields.setdefault(owner, []).append(field.replace("_", " ") if owner else one)
    told = [f"{', '.join(names)} of {owner}" if owner else ", ".join(names) for owner, names in fields.items()]
    return ", ".join(told)
