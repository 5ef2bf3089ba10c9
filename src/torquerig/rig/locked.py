"""Shafts that are fixed to the frame: what may not act on them, and that they do not turn."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.errors import InputError
from torquerig.rig.terms import GROUND, BristleFriction, Drive, Friction, ImposedMotion, Inertia, Spring, Term


def refuse_locked(terms: Sequence[Term], *, speed: float) -> None:
    """Raise InputError for what acts on a locked shaft, or turns one that a spring ties to the frame.

    Inertia and friction of a locked shaft are taken as they are: they rest.

    Parameters
    ----------
    speed : float
        The set-point of the run [rad/s].
    """
    for term in terms:
        if getattr(term, "on", None) == GROUND and not isinstance(term, Friction | BristleFriction):
            raise InputError(
                f"{getattr(term, 'name', 'an effect')}: it acts on a shaft that is locked to the frame, where it "
                "changes nothing; name a part in front of the locked end, or put a coupling between"
            )
    tied = _tied(terms)
    for term in terms:
        holds = isinstance(term, Drive) and term.holds_speed and term.on in tied
        imposes = isinstance(term, ImposedMotion) and term.motion is None and term.on in tied
        if speed and (holds or imposes):
            raise InputError(
                f"{getattr(term, 'name', 'the drive')}: the set-point is {speed:.4g} rad/s, but the shaft ends at a "
                "locked end and cannot turn; state motor_speed: 0 rpm, or leave out the part of kind ground"
            )


def _tied(terms: Sequence[Term]) -> set[str]:
    """Return the nodes that springs link to the frame."""
    springs = [term for term in terms if isinstance(term, Spring)]
    tied = {GROUND} & {node for term in terms if not isinstance(term, Inertia) for node in term.nodes}
    while True:
        more = {node for one in springs if {one.a, one.b} & tied for node in (one.a, one.b)} - tied
        if not more:
            return tied
        tied |= more
