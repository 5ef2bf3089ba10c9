"""Resistance and inductance of one phase of the equivalent star winding, from what is printed.

Between two terminals of a star are two phases in series. A delta winding has 2/3 of a branch between two terminals and
is equivalent to a star with 1/3 of a branch as its phase, so half the value between terminals holds for both.
"""

from __future__ import annotations

from torquerig.catalog.printed.converted import Converted
from torquerig.catalog.printed.figure import Figure
from torquerig.catalog.printed.reading_of import factor, readings, span

PHASE = (
    factor("line star", 0.5, "1/2"),
    factor("line delta", 0.5, "1/2"),
    factor("phase star", 1.0, "1"),
    factor("phase delta", 1 / 3, "1/3"),
)
COPPER, COLD = 0.00393, 20.0  # [1/K] IEC 60028, [C] the temperature of the entry's resistance
UNITS = {"resistance": "ohm", "inductance": "H"}


def phase_value(key: str, figure: Figure, *, winding: str | None) -> Converted:
    """Return ``phase_resistance`` or ``phase_inductance`` over the readings of ``figure``.

    Parameters
    ----------
    key : str
        ``resistance`` or ``inductance``.
    winding : str or None
        ``star`` or ``delta`` where the sheet says so.
    """
    if winding and not figure.words & {"star", "delta"}:
        factors = tuple(one for one in PHASE if winding in one.words)
    else:
        factors = PHASE
    cold = (
        1 + COPPER * ((figure.celsius if figure.celsius is not None else COLD) - COLD) if key == "resistance" else 1.0
    )
    printed = figure.quantity(UNITS[key])
    found = readings(figure, (printed[0] / cold, printed[1] / cold), factors)
    low, high = span(found)
    distinct = list(dict.fromkeys((one.factor.formula, _spoken(one.factor.words)) for one in found))
    words = f"{figure.text}, " + " or ".join(f"times {formula} ({said})" for formula, said in distinct)
    words += f", over {cold:.4g} for {COLD:g} C" if cold != 1 else ""
    if high > low * (1 + 1e-12) and len({formula for formula, _ in distinct}) > 1:
        words += "; the sheet does not say which, so the interval covers all"
    return Converted(f"phase_{key}", low, high, UNITS[key], f"{key} {words}", key)


def inductance_from_time_constant(figure: Figure, resistance: tuple[float, float]) -> Converted:
    """Return ``phase_inductance`` from the electrical time constant L / R and the resistance of one phase [ohm]."""
    low, high = figure.quantity("s")
    return Converted(
        "phase_inductance", low * resistance[0], high * resistance[1], "H",
        f"electrical time constant {figure.text}, times the resistance of one phase", "electrical_time_constant",
    )  # fmt: skip


def _spoken(words: frozenset[str]) -> str:
    return "line-to-line" if "line" in words else f"per phase, {'delta' if 'delta' in words else 'star'}"
