"""What each open value of an entry costs: the range of the figures that decide, over its interval."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from torquerig.catalog.checking.figures import DecisiveFigure, figures_of, with_value
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import Sample, nominal
from torquerig.machines.winding import winding_pairs
from torquerig.parameter import Estimate
from torquerig.units import in_unit

MATTERS = 0.05  # [1] a range below 5 % of the figure decides nothing: same_within of the shipped studies is 10 %


@dataclass(frozen=True)
class Cost:
    """What one open value costs.

    Parameters
    ----------
    field, known, evidence : str
        The value, its interval as a table shows it, and its tag.
    figure : str
        The figure that it widens or leaves open, with its range; empty where it moves none of them.
    decides : str
        The criterion or command that needs the figure.
    ratio : float
        Largest over smallest value of the figure [1]; inf where it stays open.
    """

    field: str
    known: str
    evidence: str
    figure: str
    decides: str
    ratio: float


def costs(entry: Entry) -> list[Cost]:
    """Return what the open values of ``entry`` cost: the unknown ones, then by the range of the figure."""
    sample: Sample[Entry] = nominal(entry)
    known = dict(estimates(entry))
    found = [
        *_left_open(entry, known),
        *(one for field, value in known.items() for one in _widened(sample, field, value)),
    ]
    if isinstance(entry, Motor):
        found += [*_uncounted(entry), *_orders(entry)]
    return sorted(found, key=lambda one: -one.ratio)


def _left_open(entry: Entry, known: dict[str, Estimate]) -> Iterator[Cost]:
    needed: dict[str, list[DecisiveFigure]] = {}
    for figure in figures_of(entry):
        for field in figure.needs:
            if field in known and known[field].unknown:
                needed.setdefault(field, []).append(figure)
    for field, figures in needed.items():
        names, decides = (", ".join(dict.fromkeys(words)) for words in zip(*_words(figures), strict=True))
        yield Cost(field, "?", "", f"cannot be computed: {names}", decides, float("inf"))


def _words(figures: Iterable[DecisiveFigure]) -> Iterator[tuple[str, str]]:
    return ((figure.name, figure.decides) for figure in figures)


def _uncounted(entry: Motor) -> Iterator[Cost]:
    """Yield the shares of ripple that are unknown, so that the torque lines are computed without them."""
    of_magnets = ("cogging_native", "cogging_tolerance", "six_pulse_ripple")
    shares = ("rotor_slot_ripple",) if entry.kind == "induction" else of_magnets
    lines = next(one for one in figures_of(entry) if "ripple" in one.needs)
    for share in shares if entry.ripple.known_lines is None else ():
        if getattr(entry.ripple, share).unknown:
            figure = f"{lines.name}: too small, computed without it"
            yield Cost(f"ripple.{share}", "?", "", figure, lines.decides, float("inf"))


def _widened(sample: Sample[Entry], field: str, value: Estimate) -> Iterator[Cost]:
    """Yield the figure that an interval widens most."""
    if value.unknown or value.documented or field in ("pole_pairs", "slots", "rotor_bars"):
        return
    ranges = []
    for figure in figures_of(sample.entry):
        if not _computable(figure, sample):
            continue
        ends = sorted(figure.compute(with_value(sample, field, end)) for end in value.bounds)
        ranges.append((ends[1] / ends[0] if ends[0] > 0 else float("inf"), ends, figure))
    widest = max(ranges, key=lambda one: one[0], default=None)
    if widest is None or widest[0] < 1 + MATTERS or widest[1][1] == widest[1][0]:
        return
    ratio, (low, high), figure = widest
    shown = f"{figure.name}: {_shown(low, figure.unit)}..{_shown(high, figure.unit)} {figure.unit}"
    yield Cost(field, value.shown(), value.evidence, shown, figure.decides, min(ratio, 1e6))


def _shown(value: float, unit: str) -> str:
    counted = value if unit == "rad/s^2" else in_unit(value, unit)
    text = f"{counted:.3g}"
    return f"{float(text):.0f}" if "e+" in text and counted < 1e7 else text


def _computable(figure: DecisiveFigure, sample: Sample[Entry]) -> bool:
    return all(field in sample.values for field in figure.needs if field != "ripple")


def _orders(entry: Motor) -> Iterator[Cost]:
    """Yield what open pole pairs and slots cost: every order of cogging and ripple follows from them."""
    if entry.kind == "induction":
        return
    pairs = winding_pairs(
        [int(one) for one in entry.pole_pairs.choices or (entry.pole_pairs.nominal(),)],
        [int(one) for one in entry.slots.choices or (entry.slots.nominal(),)],
    )
    if len(pairs) < 2:
        return
    shown = f"{entry.pole_pairs.shown()} pole pairs, {entry.slots.shown()} slots".replace("? ", "")
    evidence = (entry.slots if entry.pole_pairs.documented else entry.pole_pairs).evidence
    figure, decides = f"orders of cogging and ripple: {len(pairs)} sets", "lines to be filtered (orders, filter)"
    yield Cost("pole_pairs, slots", shown, evidence, figure, decides, float(len(pairs)))
