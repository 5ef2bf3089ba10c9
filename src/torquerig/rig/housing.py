"""The housing of a motor that stands on a reaction torque sensor: what acts between it and the rotor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.rig.terms import GROUND, BristleFriction, Drive, Friction, HarmonicTorque, Term


def against_housing(terms: Sequence[Term], *, rotor: str, housing: str) -> tuple[Term, ...]:
    """Return the terms of a motor, its controller or an effect in it, with the frame's share on the housing.

    Parameters
    ----------
    terms : sequence of Term
        Those between the rotor and the frame (drive, harmonic torque, friction) are changed, all others kept.
    rotor, housing : str
        Nodes.
    """
    return tuple(
        replace(term, against=housing)
        if isinstance(term, Drive | HarmonicTorque | Friction | BristleFriction)
        and term.on == rotor
        and term.against == GROUND
        else term
        for term in terms
    )
