"""A rig lowered for one sample rate: condensed where its modes are far above the recorded band."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi, sqrt

from torquerig.rig.assembly import Rig
from torquerig.rig.terms import GROUND, ImposedMotion, Inertia, Spring, Term
from torquerig.simulation import kernel
from torquerig.simulation.condensation.accuracy import Accuracy, accuracy, fastest_motion
from torquerig.simulation.condensation.partial_systems import ShaftLine, is_drag
from torquerig.simulation.condensation.reduction import reduced
from torquerig.simulation.lower import Lowered, lower, lower_terms
from torquerig.simulation.outputs import outputs_of

FAR = 8.0  # [1] mode over the top of the band from which a rig is condensed; the loop steps up to 42 times a sample
LIMITS = (4.0, 6.0, 9.0, 13.5, 20.0, 30.0, 45.0, 70.0)  # [1] partial frequencies over the band that are left out, tried
TOLERANCE = 5e-3  # [1] largest change of a response below the band: the class of a good torque sensor is 0.1 to 0.5 %


@dataclass(frozen=True)
class Condensation:
    """What was left out of a rig, and what that changes below the recorded band.

    Parameters
    ----------
    masses : tuple of int
        Inertias before and after.
    left_out : tuple of str
        One clause for each step.
    """

    accuracy: Accuracy
    masses: tuple[int, int]
    left_out: tuple[str, ...]

    def sentence(self) -> str:
        """Return what was condensed and the error in the band."""
        error, (before, after) = self.accuracy, self.masses
        band, (fast, slow) = f"{error.band:.4g} Hz", error.fastest
        return (
            f"condensed: {before} inertias to {after}, because motions up to {fast:.4g} Hz are far above the recorded "
            f"band of {band} (now up to {slow:.4g} Hz); below {band} the natural frequencies move by at most "
            f"{100 * error.shift:.2g} %, and the response of the reading by {100 * error.response:.2g} % (rms)"
        )


def lower_for(rig: Rig, seed: int, *, rate: float) -> Lowered:
    """Return the rig as arrays for ``rate`` samples a second [Hz]; ``lower`` where no mode is far above the band.

    The band ends at half the rate. Where the fastest mode is beyond ``FAR`` times that, small masses and stiff springs
    are condensed (``reduction``) as far as ``TOLERANCE`` allows; ``condensation`` of the result says so.
    """
    terms = rig.terms()
    band = rate / 2
    if _bound(terms) < FAR * band:
        return lower(rig, seed)
    full = lower(rig, seed)
    if fastest_motion(full) < FAR * band:
        return full
    outputs = outputs_of(rig, full)
    springs = frozenset(full.spring_names[one.row] for one in outputs if one.kind == kernel.SPRING_TORQUE)
    rows = {one.row for one in outputs if one.kind in (kernel.ANGLE, kernel.SPEED, kernel.OPPOSING_TORQUE)}
    nodes = frozenset((*full.nodes, GROUND)[row] for row in rows)
    line = ShaftLine(terms, nodes, springs, {}, {})
    acting = sorted({*_acting(terms), *nodes} - {GROUND})
    for limit in LIMITS:
        small = reduced(line, 2 * pi * limit * band)
        if len(small.left_out) == 0:
            break
        made = lower_terms(small.terms, seed)
        made = replace(made, joined=small.joined, series=small.series)
        error = accuracy(full, made, band=band, acting=acting, read=sorted(springs) or full.spring_names)
        if error.response <= TOLERANCE:
            masses = (len(full.nodes), len(made.nodes))
            return replace(made, condensation=Condensation(error, masses, small.left_out))
    return full


def _bound(terms: tuple[Term, ...]) -> float:
    """Return a bound on all motions [Hz]: no eigenvalue of K or C beyond twice its diagonal (Gershgorin)."""
    inertias: dict[str, float] = defaultdict(float)
    stiffnesses: dict[str, float] = defaultdict(float)
    dampings: dict[str, float] = defaultdict(float)
    for term in terms:
        if isinstance(term, Inertia):
            inertias[term.node] += term.inertia
        elif isinstance(term, Spring):
            for node, square in ((term.a, term.ratio**2), (term.b, 1.0)):
                stiffnesses[node] += term.stiffness / square
                dampings[node] += term.damping / square
    held = {term.on for term in terms if isinstance(term, ImposedMotion) and not term.released}
    moving = [node for node in stiffnesses if inertias[node] > 0 and node != GROUND and node not in held]
    square = 2 * max((stiffnesses[node] / inertias[node] for node in moving), default=0.0)
    half = max((dampings[node] / inertias[node] for node in moving), default=0.0)
    return (half + sqrt(half**2 + square)) / (2 * pi)


def _acting(terms: tuple[Term, ...]) -> Iterator[str]:
    """Yield the nodes on which torques act from outside or by something that is not linear."""
    for term in terms:
        if not (isinstance(term, Inertia | Spring) or is_drag(term)):
            yield from term.nodes
