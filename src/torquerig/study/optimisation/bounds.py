"""What an optimisation may vary: gearboxes by name or by ratio, the speed loop and numbers of filters within limits."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.errors import InputError
from torquerig.study.optimisation.scaled_gearbox import RatioBounds
from torquerig.study.optimisation.varied_number import VariedNumber

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
    numbers : tuple of VariedNumber
        Of the filters.
    ratio : RatioBounds or None
        Limits of a continuous ratio in place of the gearboxes.
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
    numbers: tuple[VariedNumber, ...] = ()
    ratio: RatioBounds | None = None
    margin: float = MARGIN
    evaluations: int = 160

    def __post_init__(self) -> None:
        named = [(one.chain, one.stage, one.key) for one in self.numbers]
        twice = next((one.name for one, name in zip(self.numbers, named, strict=True) if named.count(name) > 1), None)
        if twice is not None:
            raise InputError(f"--vary names {twice} twice; keep one")
        for name, (low, high) in (("crossover", self.crossover), ("integral corner", self.integral_corner)):
            if not 0 < low < high < float("inf"):
                raise InputError(f"the {name} from {low:g} to {high:g} Hz is no range; write for example 5..60")
        if not 0 < self.margin < 1:
            raise InputError(f"a margin of {self.margin:g} cannot be; write more than 0 and less than 1, such as 0.5")
