"""The parts of a rig that a study exchanges: one motor, and one stage of the chain (gear, belt or worm) or none."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from torquerig.errors import InputError, did_you_mean
from torquerig.study.candidate import ExchangedParts

if TYPE_CHECKING:
    from torquerig.document import Document
    from torquerig.study.settings import Settings

STAGE_KINDS = ("belt", "gear", "planetary_gear", "fixed_axis_gear", "linear_drive", "worm_gear")
"""The kinds of parts between two speeds, as a scenario writes them; their classes take 0.2 s to import."""
_WORDS = {"motor": "motor", "stage": "gear, belt, worm or linear drive"}


def exchanged_parts(document: Document, settings: Settings) -> ExchangedParts:
    """Return the exchanged parts: those that ``study: exchange:`` names, else the only ones of the rig.

    Raises
    ------
    InputError
        Where the rig has several motors or stages and none is named, or a named part is none of them.
    """
    rig = _parts(document)
    motor = _chosen(document, _of_kinds(rig, ("motor",)), settings.exchange.motor, "motor")
    if not (settings.gearboxes or settings.exchange.stage):
        return ExchangedParts(motor=motor, stage="")
    return ExchangedParts(
        motor=motor, stage=_chosen(document, _of_kinds(rig, STAGE_KINDS), settings.exchange.stage, "stage")
    )


def present_stage(document: Document, settings: Settings) -> str:
    """Return the present gearbox: as stated, else the catalog entry or the name of the rig's stage; empty without."""
    stage, stated = exchanged_parts(document, settings).stage, settings.present.gearbox
    if stage:
        return stated or str(_parts(document)[stage].get("catalog", stage))
    if stated is not None:
        raise InputError(
            f"{document.place(('study', 'present', 'gearbox'))}: the study exchanges no stage, so {stated!r} has no "
            "place; list gearboxes, or leave this key out"
        )
    return ""


def pinned_ratio(document: Document, stage: str) -> float | None:
    """Return the ratio that the rig states next to a gear's catalog entry, which fixes the gearbox; else None."""
    written = _parts(document)[stage] if stage else {}
    if "ratio" not in written or "catalog" not in written:
        return None
    ratio, place = written["ratio"], document.place(("rig", stage, "ratio"))
    if isinstance(ratio, bool) or not isinstance(ratio, int | float) or ratio == 0:
        raise InputError(f"{place}: {ratio!r} is no ratio; write the motor turns per output turn, such as 5")
    return float(ratio)


def _parts(document: Document) -> Mapping[str, Mapping[str, Any]]:
    rig = document.data.get("rig", {})
    if not isinstance(rig, dict):
        raise InputError(f"{document.place(('rig',))}: a scenario needs a mapping named rig: with one entry per part")
    return {str(name): part for name, part in rig.items() if isinstance(part, dict)}


def _of_kinds(rig: Mapping[str, Mapping[str, Any]], kinds: Sequence[str]) -> tuple[str, ...]:
    return tuple(name for name, part in rig.items() if part.get("kind") in kinds)


def _chosen(document: Document, names: tuple[str, ...], stated: str | None, key: str) -> str:
    """Return the stated part, or the only one; InputError otherwise."""
    word = _WORDS[key]
    if stated is not None:
        if stated not in names:
            raise InputError(
                f"{document.place(('study', 'exchange', key))}: {stated!r} is no {word} of the rig; "
                f"{did_you_mean(stated, names)}"
            )
        return stated
    if len(names) == 1:
        return names[0]
    if not names and key == "stage":
        raise InputError(
            f"{document.place(('study', 'gearboxes'))}: the rig has no {word} to exchange; leave gearboxes out, and "
            "the study exchanges the motor only"
        )
    if not names:
        raise InputError(f"{document.place(('rig',))}: a study exchanges a motor, and the rig has none; add one")
    raise InputError(
        f"{document.place(('study',))}: the rig has {len(names)} parts that the study could exchange as its {key} "
        f"({', '.join(names)}); name one with exchange: {{{key}: {names[0]}}}"
    )
