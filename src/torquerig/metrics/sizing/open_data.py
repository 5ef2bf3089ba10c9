"""A figure over all that the catalog leaves open, and the datum whose interval moves it most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product

from torquerig.metrics.figure import Figure
from torquerig.parameter import Estimate

Values = Mapping[str, float]
MOST_OPEN = 8  # [1] 256 corners; what moves a figure least is then kept at its middle


def over(
    data: Mapping[str, Estimate], figure: Callable[[Values], float], *, unit: str = "1", source: str = ""
) -> Figure:
    """Return the figure at the stated values, and its lowest and highest over every corner of what is open.

    Sound where the figure rises or falls with each datum alone. A stated value without an interval counts as exact;
    without a stated value in one of the data that are open, only the interval is given. ``missing`` names first the
    datum whose own interval moves the figure most.

    Parameters
    ----------
    data : mapping of str to Estimate
        By a name that a buyer can ask for: ``rotor inertia of HDS6A-0104A``.
    figure : callable
        From values [SI] by the same names to the figure [unit].
    """
    rests_on = tuple((name, known) for name, known in data.items() if known.source or known.unknown)
    unknown = [name for name, known in data.items() if known.unknown]
    if unknown:
        return Figure(unit=unit, source=source, missing=", ".join(unknown), rests_on=rests_on)
    middle = {name: known.nominal() for name, known in data.items()}
    ends = {name: known.bounds for name, known in data.items() if not known.documented}
    ends = {name: (low, high) for name, (low, high) in ends.items() if low < high}
    if not ends:
        return Figure(value=figure(middle), unit=unit, source=source, rests_on=rests_on)
    swing = {name: _swing(figure, middle, name, pair) for name, pair in ends.items()}
    order = sorted((name for name in ends if swing[name] > 0), key=lambda name: -swing[name])
    if not order:
        return Figure(value=figure(middle), unit=unit, source=source, rests_on=rests_on)
    kept = order[:MOST_OPEN]
    corners = [figure({**middle, **dict(zip(kept, one, strict=True))}) for one in product(*(ends[n] for n in kept))]
    stated = all(data[name].value is not None for name in order)
    nominal = figure(middle)
    return Figure(
        value=nominal if stated else None, low=min(*corners, nominal), high=max(*corners, nominal), unit=unit,
        source=source, missing=", ".join(order), rests_on=rests_on,
    )  # fmt: skip


def _swing(figure: Callable[[Values], float], middle: Values, name: str, ends: tuple[float, float]) -> float:
    low, high = (figure({**middle, name: end}) for end in ends)
    return abs(high - low)


def exactly(value: float) -> Estimate:
    """Return a value without doubt."""
    return Estimate(value, evidence="REF")
