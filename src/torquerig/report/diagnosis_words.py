"""A diagnosis in sentences: the verdict, a place, what kind of line stands there, how likely chance is."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnose.diagnosis import Diagnosis, Finding, Mismatch
from torquerig.report.layout import plain

_SMALLEST = 1e-12
_SHAFT = {"output_shaft": "output shaft", "motor_shaft": "motor shaft"}
WORDS = {
    "adequate": "adequate",
    "missing_physics": "missing physics",
    "unexplained": "unexplained",
}


def mechanism_text(name: str) -> str:
    """Return a mechanism's name as it is said."""
    return name.replace("_", " ")


def verdict_sentence(diagnosis: Diagnosis, left: Sequence[Mismatch]) -> str:
    """Return the verdict as one sentence; ``left`` is what the completed model still misses."""
    fit = diagnosis.fit
    named = " and ".join(_named(finding) for finding in diagnosis.findings)
    falls = f"the misfit on data that no fit has seen falls from {plain(fit.before)} to {plain(fit.after)}"
    if diagnosis.verdict == "adequate":
        return (
            "Nothing is missing that these recordings can show: with its own numbers fitted, the model's misfit on "
            f"data that no fit has seen is {plain(fit.before)}, where a true model has about 1."
        )
    if diagnosis.verdict == "missing_physics":
        them = "it" if len(diagnosis.findings) == 1 else "them"
        return f"The model lacks {named}; with {them} {falls}, where a true model has about 1."
    where = f"what is left stands {place_text(left[0])}" if left else "what is left is in the samples themselves"
    if not diagnosis.findings:
        return f"Something is missing that no mechanism of the library explains: {where}."
    rest = f"but that is not all, and no mechanism of the library explains the rest: {where}"
    return f"The model lacks {named}, and {falls}; {rest}."


def _named(finding: Finding) -> str:
    named = mechanism_text(finding.mechanism)
    if finding.equivalent_to:
        named += f" (or {', or '.join(map(mechanism_text, finding.equivalent_to))}, which these recordings cannot tell)"
    return named


def place_text(mismatch: Mismatch) -> str:
    """Return where a mismatch stands, as one reads it aloud."""
    at, width = plain(mismatch.at, 5), mismatch.width
    if mismatch.domain == "order":
        return f"at order {at} of the {_SHAFT.get(mismatch.axis, mismatch.axis)}"
    if mismatch.domain == "frequency" and width < 0.02 * mismatch.at:
        return f"at {at} Hz"
    if mismatch.domain == "frequency":
        low = max(mismatch.at - 0.5 * width, mismatch.at**2 / (mismatch.at + 0.5 * width))
        return f"from {plain(low)} to {plain(low + width)} Hz"
    return (
        f"in the {'slow torque' if mismatch.domain in ('speed', 'level') else mismatch.domain} at {at} {mismatch.axis}"
    )


def kind_text(mismatch: Mismatch) -> str:
    """Return the neutral term for a mismatch: what it is fixed to."""
    if mismatch.domain == "order":
        return f"periodic in the angle of the {_SHAFT.get(mismatch.axis, mismatch.axis)}"
    if mismatch.domain == "frequency":
        return "fixed in frequency" if mismatch.width < 0.02 * mismatch.at else "a band of the spectrum"
    return {"speed": "goes with the speed", "level": "mean of a run", "time": "transient"}.get(
        mismatch.domain, "distribution of the values"
    )


def chance_text(p_value: float) -> str:
    """Return a probability for a table, the smallest as a bound."""
    return f"< {_SMALLEST:.0e}" if p_value < _SMALLEST else f"{p_value:.1g}"
