"""The cause of a failed integration: an input, the step size, the speed loop, or unknown."""

from __future__ import annotations

from math import ceil, pi

import numpy as np

from torquerig.errors import TorquerigError
from torquerig.rig.assembly import Rig
from torquerig.simulation.lower import Lowered
from torquerig.simulation.step_choice import STABLE_ANGLE, rates
from torquerig.simulation.term_kinds import Terms
from torquerig.simulation.twin.linear_twin import Twin, twin_of


def why_it_failed(rig: Rig, lowered: Lowered, terms: Terms, *, sample: int, steps: int, sample_rate: float) -> str:
    """Return the cause in one clause, with a remedy; unknown where none of the causes applies.

    A speed loop that is unstable oscillates at the motor's torque limit and seldom runs away; so it is named only after
    what was given and the step have been ruled out.

    Parameters
    ----------
    sample : int
        Where a speed ceased to be finite, counted from the start of settling.
    steps : int
        Per sample.
    """
    if name := _not_a_number(lowered, terms, sample):
        return f"{name} is not finite there; mend what it is read from"
    fastest = max(rates(lowered, terms), key=lambda one: one.rate)
    turned = fastest.rate / sample_rate / steps
    if turned > STABLE_ANGLE:
        needed = ceil(fastest.rate / sample_rate / STABLE_ANGLE)
        return (
            f"the step of {1e6 / sample_rate / steps:.3g} us is too long for {fastest.what}, which turns {turned:.3g} "
            f"rad in it; {needed} or more substeps are stable"
        )
    try:
        twin = twin_of(rig, rate=sample_rate)
    except TorquerigError:
        twin = None
    if twin is not None and not twin.stable:
        return unstable(twin)
    return (
        "neither what is given, the step, nor the speed loop at its operating point explains it; look at terms that "
        "grow with speed (quadratic drag) and at a motor without a torque limit to speak of"
    )


def _not_a_number(lowered: Lowered, terms: Terms, sample: int) -> str:
    """Return the name of the first input that is not finite up to a sample; empty where all are finite."""
    given = [(term.name, terms.loads.samples[row]) for row, term in enumerate(lowered.load_terms)]
    given += [(f"the set-point of {name}", terms.drives.reference[row]) for row, name in enumerate(lowered.drive_names)]
    given += [(f"the demand of {name}", terms.drives.demand[row]) for row, name in enumerate(lowered.drive_names)]
    given += [(f"the motion {term.name}", terms.imposed.angle[row]) for row, term in enumerate(lowered.imposed_terms)]
    given += [(f"the motion {term.name}", terms.imposed.speed[row]) for row, term in enumerate(lowered.imposed_terms)]
    return next((name for name, values in given if not np.isfinite(values[: sample + 2]).all()), "")


def unstable(twin: Twin) -> str:
    """Return how an unstable speed loop swings and grows, with a remedy, in one clause."""
    roots = twin.sampled_loop.poles()
    worst = roots[roots.real.argmax()]
    crossed = [one.lower_gain for one in twin.margins() if one.lower_gain is not None]
    remedy = f"lower kp and ki to {0.5 * min(crossed):.2g} of what they are" if crossed else "lower kp and ki"
    return (
        f"the speed loop is unstable: it swings at {abs(worst.imag) / (2 * pi):.4g} Hz and grows by a factor e in "
        f"{1000 / worst.real:.3g} ms; {remedy}"
    )
