"""A diagnosis in sentences: the verdict, a place, what kind of line stands there, how likely chance is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.diagnosis.outcome import Diagnosis, Finding, Mismatch
from torquerig.reporting.layout import plain

_SMALLEST = 1e-12
_STROKE = ("m", "rad")  # where the motion was measured, and is no count of turns
_SHAFT = {"output_shaft": "output shaft", "motor_shaft": "motor shaft"}
_ANGLE = {axis: f"angle of the {shaft}" for axis, shaft in _SHAFT.items()}
WORDS = {
    "adequate": "adequate",
    "missing_physics": "missing physics",
    "unexplained": "unexplained",
}


@dataclass(frozen=True, kw_only=True)
class Yardstick:
    """How the misfit on held-out data is said.

    Parameters
    ----------
    name : str
        What falls.
    percent : bool
        Whether it is a share, said in per cent.
    of : str
        Of what, behind the number.
    true : str
        What a true model has, as a clause.
    placeless : str
        What is said of an unexplained rest that stands at no place.
    """

    name: str
    percent: bool = False
    of: str = ""
    true: str = ""
    placeless: str = "what is left is in the samples themselves"

    def said(self, value: float) -> str:
        """Return a misfit as it is said."""
        return f"{plain(100 * value)} %" if self.percent else plain(value)


FEATURES = Yardstick(name="misfit on data that no fit has seen", true=", where a true model has about 1")
EFFORT = Yardstick(
    name="error on data that no fit has seen", percent=True, of=" of the effort",
    placeless="what speaks against the model stands at no place, but in the remarks",
)  # fmt: skip


def mechanism_text(name: str) -> str:
    """Return a mechanism's name as it is said."""
    return name.replace("_", " ")


def verdict_sentence(diagnosis: Diagnosis, left: Sequence[Mismatch], *, yardstick: Yardstick = FEATURES) -> str:
    """Return the verdict as one sentence; ``left`` is what the completed model still misses."""
    fit, name = diagnosis.fit, yardstick.name
    named = " and ".join(_named(finding) for finding in diagnosis.findings)
    before, after = yardstick.said(fit.before), yardstick.said(fit.after)
    falls = f"the {name} falls from {before} to {after}{yardstick.of}"
    if before == after:  # faults of samples, which are kept from fits and judgement
        falls = f"the {name} is {after}{yardstick.of}, as without"
    if diagnosis.verdict == "adequate":
        return (
            f"Nothing is missing that these recordings can show: with its own numbers fitted, the model's {name} is "
            f"{yardstick.said(fit.before)}{yardstick.of}{yardstick.true}."
        )
    if diagnosis.verdict == "missing_physics":
        them = "it" if len(diagnosis.findings) == 1 else "them"
        return f"The model lacks {named}; with {them} {falls}{yardstick.true}."
    where = f"what is left stands {place_text(left[0])}" if left else yardstick.placeless
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
    if mismatch.domain == "order" and mismatch.axis in _SHAFT:
        return f"at order {at} of the {_SHAFT[mismatch.axis]}"
    if mismatch.domain == "order":
        return f"at {at} {mismatch.axis} of the motion"
    if mismatch.domain == "frequency" and width < 0.02 * mismatch.at:
        return f"at {at} Hz"
    if mismatch.domain == "frequency":
        low = max(mismatch.at - 0.5 * width, mismatch.at**2 / (mismatch.at + 0.5 * width))
        return f"from {plain(low)} to {plain(low + width)} Hz"
    return _of_the_level(mismatch, at)


def _of_the_level(mismatch: Mismatch, at: str) -> str:
    if mismatch.axis in _STROKE:
        return f"where the motion passes {at} {mismatch.axis}"
    if mismatch.axis == "m/s":
        return f"in the mean force at {at} m/s"
    what = "slow torque" if mismatch.domain in ("speed", "level") else mismatch.domain
    return f"in the {what} at {at} {mismatch.axis}"


def kind_text(mismatch: Mismatch) -> str:
    """Return the neutral term for a mismatch: what it is fixed to."""
    if mismatch.domain == "order":
        return f"periodic in the {_ANGLE.get(mismatch.axis, 'position')}"
    if mismatch.domain == "frequency":
        return "fixed in frequency" if mismatch.width < 0.02 * mismatch.at else "a band of the spectrum"
    if mismatch.axis in _STROKE:
        return "comes again at a place of the stroke"
    return {"speed": "goes with the speed", "level": "mean of a run", "time": "transient"}.get(
        mismatch.domain, "distribution of the values"
    )


def chance_text(p_value: float) -> str:
    """Return a probability for a table, the smallest as a bound."""
    return f"< {_SMALLEST:.0e}" if p_value < _SMALLEST else f"{p_value:.1g}"
