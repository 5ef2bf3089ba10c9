"""A figure over all open values of the catalog, and the value whose interval changes it most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product

from torquerig.metrics.figure import Figure
from torquerig.parameter import Estimate

Values = Mapping[str, float]
MOST_OPEN = 8  # [1] 256 corners; further values, which change the figure least, stay at their middle


def over_intervals(
    data: Mapping[str, Estimate], figure: Callable[[Values], float], *, unit: str = "1", source: str = ""
) -> Figure:
    """Return the figure at the stated values, and its lowest and highest over all corners of the intervals.

    Valid where the figure is monotone in each value. A stated value without an interval counts as exact. Where one of
    the open values has no stated value, only the interval is given. ``missing`` lists the values by their effect on the
    figure, the largest first.

    Parameters
    ----------
    data : mapping of str to Estimate
        By name: ``rotor inertia of HDS6A-0104A``.
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


def exact_value(value: float) -> Estimate:
    """Return an exact value."""
    return Estimate(value, evidence="REF")
