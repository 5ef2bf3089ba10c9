"""Ratio and mesh orders of a worm and its wheel, from starts and teeth."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.errors import InputError

MOST_STARTS = 12  # worms have 1 to 6 starts; with more they are crossed helical gears


@dataclass(frozen=True)
class Worm:
    """A worm of ``starts`` threads that drives a wheel.

    Parameters
    ----------
    starts, wheel : int
        Threads of the worm, 1 to 12, and teeth of the wheel, more than ``starts``.

    Raises
    ------
    InputError
        When there is no such pair.

    Notes
    -----
    One turn of the worm moves the wheel by ``starts`` teeth (any text on machine elements, as Shigley, ch. 13).
    """

    starts: int
    wheel: int

    def __post_init__(self) -> None:
        if not 1 <= self.starts <= MOST_STARTS or self.wheel <= self.starts:
            raise InputError(
                f"a worm of {self.starts} starts on a wheel of {self.wheel} teeth does not exist; write 1 to "
                f"{MOST_STARTS} starts, and more teeth than starts"
            )

    @property
    def ratio(self) -> float:
        """Turns of the worm per turn of the wheel [1]."""
        return self.wheel / self.starts

    @property
    def reverses(self) -> bool:
        """Whether the wheel turns backwards; the axes cross, so that the part says it, not the teeth."""
        return False

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the worm [1/rev]."""
        return float(self.starts)

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the wheel [1/rev]."""
        return float(self.wheel)

    @property
    def spoken(self) -> str:
        """The pair in words."""
        return f"worm of {self.starts} start{'s' * (self.starts > 1)} on a wheel of {self.wheel} teeth"
