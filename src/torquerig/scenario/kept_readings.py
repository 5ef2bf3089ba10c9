"""What was read and no seed changes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Any

from torquerig.catalog.chosen_draws import ChosenDraws


@dataclass(frozen=True)
class KeptReadings:
    """Readings that drew nothing, by name; a reading that draws is repeated for each seed.

    A reading is watched at its first seed. One that draws nothing there depends on no seed, for the seed acts by its
    draws only.
    """

    unchanged: dict[Hashable, Any] = field(default_factory=dict)
    drawn: set[Hashable] = field(default_factory=set)

    def once(self, name: Hashable, seed: int, read: Callable[[int], Any]) -> Any:
        """Return what ``read`` returns for a seed: from the first call where it draws nothing, else read again.

        An error of ``read`` is passed on and nothing is kept.
        """
        if name in self.unchanged:
            return self.unchanged[name]
        if name in self.drawn:
            return read(seed)
        watched = ChosenDraws(seed, seed.quantiles) if isinstance(seed, ChosenDraws) else ChosenDraws(seed)
        found = read(watched)
        if isinstance(seed, ChosenDraws):
            seed.drawn.update(watched.drawn)
        if watched.drawn:
            self.drawn.add(name)
        else:
            self.unchanged[name] = found
        return found
