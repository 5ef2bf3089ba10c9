"""What leads to another winner: open requirements, missing values and weights."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.decide.flips import FlipWeight, nearest_flips

if TYPE_CHECKING:
    from torquerig.study.rated_drives import RatedDrives

MOST_WEIGHTS = 3  # weights that are named; the page's sliders show all


def what_would_change(rated: RatedDrives) -> tuple[str, ...]:
    """Return the decisive missing values and the nearest changes of a weight that lead to another winner, as sentences.

    The most useful missing value comes first, then the smallest change of a weight.
    """
    values = tuple(f"{_capital(fact.sentence())}." for fact in rated.facts if fact.decisive)
    several = len(rated.overall.alternatives) > 1
    flips = [flip for flip in nearest_flips(rated.overall) if flip.flip is not None] if several else []
    weights = tuple(_weight_sentence(flip) for flip in flips[:MOST_WEIGHTS])
    if not values and not weights:
        return ("No missing value and no weight alone changes the answer.",)
    return (*values, *weights)


def _weight_sentence(flip: FlipWeight) -> str:
    assert flip.flip is not None
    direction = "below" if flip.flip < flip.weight else "above"
    return (
        f"Weight of {flip.criterion} {direction} {flip.flip:.3g} (now {flip.weight:.3g}): "
        f"{flip.other.replace(' | ', ' with ')} wins."
    )


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
