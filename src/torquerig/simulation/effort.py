"""Limits of a run: its samples and its integration steps, refused before anything is integrated."""

from __future__ import annotations

from math import ceil, floor, log10, pi

from torquerig.errors import InputError, SimulationError
from torquerig.simulation.inputs import Span
from torquerig.simulation.lower import Lowered
from torquerig.simulation.step_choice import Rate, StepChoice

MOST_SAMPLES = 10_000_000  # of a run with its settling; they take about 1 GB, and 400 s at 25 kHz
MOST_STEPS = 1e7  # [1/s] 400 a sample at 25 kHz: a second of the rig takes some ten seconds


def refuse_long(span: Span) -> None:
    """Raise InputError with the largest duration where the samples of a run would fill the memory."""
    samples = span.settling + span.samples
    if samples > MOST_SAMPLES:
        longest = (MOST_SAMPLES - span.settling) / span.rate
        raise InputError(
            f"a run of {samples / span.rate:.6g} s at {span.rate:g} Hz has {samples} samples, too many for the memory; "
            + (f"ask for at most {longest:.4g} s" if longest > 0 else "choose a lower sample rate")
        )


def refuse_stiff(choice: StepChoice, lowered: Lowered, rate: float) -> None:
    """Raise SimulationError with the largest sensible value where a run needs steps without end.

    Parameters
    ----------
    rate : float
        Samples per second [Hz].
    """
    most = max(1, ceil(MOST_STEPS / rate))
    if choice.steps <= most:
        return
    fixed = choice.fixed_by
    factor = choice.steps / most
    raise SimulationError(
        f"the rig needs {choice.steps:.3g} integration steps a sample for {fixed.what}, and {most} are the most: its "
        f"fastest motion is beyond {MOST_STEPS * fixed.allowed / (2 * pi):.3g} Hz; {_remedy(fixed, lowered, factor)}"
    )


def _remedy(fixed: Rate, lowered: Lowered, factor: float) -> str:
    """Return what to change: a rate grows with the root of stiffness / inertia, else with the number itself."""
    if fixed.spring is None:
        return f"lower what drives it (damping, gain, torque), or raise the inertia there, by a factor of {factor:.2g}"
    place = lowered.spring_names.index(fixed.spring)
    highest = _not_above(float(lowered.arrays.springs.stiffness[place]) / factor**2)
    return (
        f"lower the stiffness of {fixed.spring!r} to at most {highest:.2g} N*m/rad, or raise the inertia "
        f"beside it by a factor of {factor**2:.2g}"
    )


def _not_above(value: float) -> float:
    """Return a value > 0 rounded down to two digits, so that what is printed can be followed."""
    digit = 10.0 ** (floor(log10(value)) - 1)
    return floor(value / digit) * digit
