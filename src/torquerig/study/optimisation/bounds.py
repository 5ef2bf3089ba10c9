"""What an optimisation may vary: gearboxes by name, crossover and integral corner of the speed loop within limits."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.errors import InputError

MARGIN = 0.5  # [1] modulus margin that is usually required (Maciejowski, Multivariable Feedback Design, section 1.3)


@dataclass(frozen=True, kw_only=True)
class Bounds:
    """The limits of an optimisation.

    Parameters
    ----------
    gearboxes : tuple of str
        To be tried.
    crossover, integral_corner : (float, float)
        Lowest and highest of each [Hz].
    margin : float
        Least distance of the loop gain from -1 [1].
    evaluations : int
        Simulated speed loops of each gearbox, about.

    Raises
    ------
    InputError
        For limits that are none.
    """

    gearboxes: tuple[str, ...]
    crossover: tuple[float, float]
    integral_corner: tuple[float, float]
    margin: float = MARGIN
    evaluations: int = 160

    def __post_init__(self) -> None:
        for name, (low, high) in (("crossover", self.crossover), ("integral corner", self.integral_corner)):
            if not 0 < low < high < float("inf"):
                raise InputError(f"the {name} from {low:g} to {high:g} Hz is no range; write for example 5..60")
        if not 0 < self.margin < 1:
            raise InputError(f"a margin of {self.margin:g} cannot be; write more than 0 and less than 1, such as 0.5")
