"""Torque constant of a motor from Kt, Ke or kV as printed, and what contradicts it.

The entry counts the torque constant per rms ampere of a phase (pmsm, sine), or per ampere of the DC link (bldc,
six-step). All factors follow from the power balance T w = sum of e i. With the flux linkage psi of p pole pairs, a sine
has p psi as the phase peak of Ke and Kt = 3/2 p psi per peak ampere; line-to-line values are sqrt(3) times those of a
phase. A six-step motor has Kt = Ke line-to-line peak. Its other factors lie between those of a sine and of the ideal
trapezoid of 120 degrees, whose rms is sqrt(7)/3 of the peak of a phase, and sqrt(20)/3 line-to-line.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import log, pi, sqrt

from torquerig.catalog.printed.figure import Figure
from torquerig.catalog.printed.reading_of import Factor, Reading, factor, readings, span

AGREEMENT = 0.10  # [1] Ke is measured cold and idle, Kt warm and loaded: magnets lose 0.1..0.2 %/K, iron saturates

SINE_EMF = (
    factor("line rms", sqrt(3), "sqrt(3)"),
    factor("line peak", sqrt(1.5), "sqrt(3/2)"),
    factor("line dc", sqrt(1.5), "sqrt(3/2)"),
    factor("phase rms", 3.0, "3"),
    factor("phase peak", 3 / sqrt(2), "3/sqrt(2)"),
)
SIX_STEP_EMF = (
    factor("line peak", 1.0, "1"),
    factor("line dc", 1.0, "1"),
    factor("line rms", (3 / sqrt(5), sqrt(2)), "1.34..1.41 (trapezoid..sine)"),
    factor("phase peak", (sqrt(3), 2.0), "1.73..2 (sine..trapezoid)"),
    factor("phase rms", (6 / sqrt(7), sqrt(6)), "2.27..2.45 (trapezoid..sine)"),
)
SINE_TORQUE = (
    factor("rms", 1.0, "1"),
    factor("peak", sqrt(2), "sqrt(2)"),
    factor("dc", (sqrt(1.5), sqrt(1.5) * pi / 3), "1.22..1.28"),
)
SIX_STEP_TORQUE = (factor("dc", 1.0, "1"), factor("peak", 1.0, "1"), factor("rms", sqrt(2 / 3), "sqrt(2/3)"))
NAMES = {"torque_constant": "Kt", "voltage_constant": "Ke", "speed_constant": "kV"}
CAUSES = (
    (sqrt(2), "sqrt(2): peak against rms"),
    (sqrt(3), "sqrt(3): line-to-line against one phase"),
    (sqrt(1.5), "sqrt(3/2): line-to-line rms against the peak of one phase"),
    (sqrt(6), "sqrt(6): line-to-line peak against the rms of one phase"),
    (2.0, "2: peak-to-peak against amplitude, or poles against pole pairs"),
    (60 / (2 * pi), "60/(2 pi): per rpm against per rad/s"),
    (1000.0, "1000: per rpm against per 1000 rpm, or m against none"),
    (1000 * 60 / (2 * pi), "1000 x 60/(2 pi): per 1000 rpm against per rad/s"),
)  # fmt: skip


@dataclass(frozen=True)
class TorqueConstant:
    """The torque constant over the readings that remain, and the conversion in words.

    ``contradiction`` is empty where all printed values agree for some reading.
    """

    low: float
    high: float
    words: str
    key: str
    contradiction: str = ""


def factors_of(key: str, *, six_step: bool) -> tuple[Factor, ...]:
    """Return the readings of Kt, Ke or kV (as Ke) of one kind of motor."""
    if key == "torque_constant":
        return SIX_STEP_TORQUE if six_step else SINE_TORQUE
    return SIX_STEP_EMF if six_step else SINE_EMF


def current_factors(*, six_step: bool) -> tuple[Factor, ...]:
    """Return what a printed ampere is worth in amperes of the torque constant."""
    return tuple(
        factor(" ".join(one.words), (1 / one.high, 1 / one.low), "1" if one.formula == "1" else f"1/({one.formula})")
        for one in factors_of("torque_constant", six_step=six_step)
    )


def emf_range(key: str, figure: Figure) -> tuple[float, float]:
    """Return the printed range of Kt [N m/A], Ke [V s/rad], or kV as Ke; UnitError where the unit is another."""
    if key == "torque_constant":
        return figure.ratio("N*m", "A")
    if key == "voltage_constant":
        return figure.ratio("V", "rad/s", like="flux linkage")
    low, high = replace(figure, low=_hobby(figure.low), high=_hobby(figure.high)).ratio("rad/s", "V")
    return 1 / high, 1 / low


def _hobby(text: str) -> str:
    """Return ``190 KV``, as motors of models are named, as ``190 rpm/V``."""
    return re.sub(r"^([\d.]+)\s*[kK][vV]$", r"\1 rpm/V", text)


def torque_constant(figures: Mapping[str, Figure], *, six_step: bool, pole_pairs: Sequence[int] = ()) -> TorqueConstant:
    """Return the torque constant that the printed values of ``figures`` give together.

    Where one of them has several readings, those that agree with the others within 10 % remain. The range covers what
    remains of the figure with the fewest readings.
    """
    found = {
        key: readings(_of_branch(figure), emf_range(key, figure), factors_of(key, six_step=six_step))
        for key, figure in figures.items()
    }
    agreeing = [choice for choice in product(*found.values()) if _agree(choice)]
    if not agreeing:
        return TorqueConstant(0.0, 0.0, "", "", _contradiction(figures, found, pole_pairs))
    kept = {key: _distinct(choice[at] for choice in agreeing) for at, key in enumerate(found)}
    best = min(kept, key=lambda key: (_width(kept[key]), list(NAMES).index(key)))
    low, high = span(kept[best])
    return TorqueConstant(low, high, _words(best, figures, found, kept), best)


def _of_branch(figure: Figure) -> Figure:
    """Return a voltage per phase of a delta winding without that word: a branch has the voltage between two lines."""
    return replace(figure, words=figure.words - {"phase"}) if {"phase", "delta"} <= figure.words else figure


def _agree(choice: Iterable[Reading]) -> bool:
    held = list(choice)
    return max(one.low for one in held) <= min(one.high for one in held) * (1 + AGREEMENT)


def _distinct(found: Iterable[Reading]) -> list[Reading]:
    return list(dict.fromkeys(found))


def _width(found: Iterable[Reading]) -> float:
    low, high = span(found)
    return round(log(high / low), 9)


def _words(
    best: str, figures: Mapping[str, Figure], found: Mapping[str, list[Reading]], kept: Mapping[str, list[Reading]]
) -> str:
    """Return where the constant comes from: ``Ke 27.8 V/krpm line-to-line rms, times sqrt(3)``."""
    distinct = _distinct_values(kept[best])
    how = " or ".join(one.conversion for one in distinct)
    words = f"{NAMES[best]} {figures[best].text}, {how}"
    if len(distinct) > 1:
        words += "; the sheet does not say which, so the interval covers all"
    elif len(_distinct_values(found[best])) > 1:
        words += ", the reading that agrees with the other value"
    others = [f"{NAMES[key]} {figures[key].text}" for key in figures if key != best]
    return words + (f"; {' and '.join(others)} agrees within {AGREEMENT * 100:.0f} %" if others else "")


def _distinct_values(found: Iterable[Reading]) -> list[Reading]:
    return list({(one.low, one.high): one for one in reversed(list(found))}.values())[::-1]


def _contradiction(figures: Mapping[str, Figure], found: Mapping[str, list[Reading]], pole_pairs: Sequence[int]) -> str:
    """Return both values that differ most beyond agreement, and the usual cause of such a factor."""
    keys = list(found)
    pairs = [(one, other) for at, one in enumerate(keys) for other in keys[at + 1 :]]
    gaps = {pair: min(product(found[pair[0]], found[pair[1]]), key=lambda two: _gap(*two)) for pair in pairs}
    pair = max(gaps, key=lambda pair: _gap(*gaps[pair]))
    one, other = gaps[pair]
    ratio = max(one.low / other.high, other.low / one.high)
    said = [
        f"{NAMES[key]} {figures[key].text} gives {_shown(reading)}"
        for key, reading in zip(pair, (one, other), strict=True)
    ]
    return f"{said[0]}, but {said[1]}; {likely_cause(ratio, pole_pairs)}"


def _gap(one: Reading, other: Reading) -> float:
    return max(one.low / other.high, other.low / one.high)


def _shown(reading: Reading) -> str:
    middle = sqrt(reading.low * reading.high)
    return f"{middle:.3g} N*m/A" if middle >= 1e-3 else f"{middle:.3e} N*m/A"


def likely_cause(ratio: float, pole_pairs: Sequence[int] = ()) -> str:
    """Return the usual cause of a ratio between two values that ought to agree, with the remedy."""
    known = [
        *CAUSES,
        *((float(pairs), f"{pairs}: per electrical against per mechanical radian") for pairs in pole_pairs),
    ]
    size, cause = min(known, key=lambda one: abs(log(ratio / one[0])))
    if abs(log(ratio / size)) > AGREEMENT:
        return f"they differ by a factor of {ratio:.3g}, which no mix-up of units explains; check both on the sheet"
    return f"they differ by a factor of {ratio:.3g}, about {cause}; correct the words or the unit of one of them"
