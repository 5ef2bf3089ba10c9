"""How far a speed loop is from instability, in figures and words."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

UNSTABLE = "its speed loop is unstable"
USUAL = 0.5  # [1] modulus margin that is usually required (Maciejowski, Multivariable Feedback Design, section 1.3)


@dataclass(frozen=True, kw_only=True)
class LoopMargin:
    """How far a speed loop is from instability.

    Parameters
    ----------
    stable : bool
        Whether the sampled loop is stable at the set-point.
    modulus : float
        Least distance of the loop gain from -1 [1]; a disturbance is amplified by at most its inverse.
    at : float
        Where [Hz].
    mode : float
        The first elastic mode of the shafts [Hz]; infinite where no shaft twists.
    crossover : float
        Of the study's rule [Hz].
    rate : float
        Samples of the controller per second [Hz].
    """

    stable: bool
    modulus: float
    at: float
    mode: float
    crossover: float
    rate: float

    @property
    def fault(self) -> str:
        """Why the drive cannot be simulated; empty where its loop is stable."""
        if self.stable:
            return ""
        return f"{UNSTABLE} ({self._terms}); lower study: speed_loop: crossover"

    @property
    def doubt(self) -> str:
        """What a narrow margin does, in words; empty where the margin is as usual."""
        if not self.stable or self.modulus >= USUAL:
            return ""
        return (
            f"its speed loop amplifies disturbances by up to {1 / self.modulus:.2g} at {self.at:.3g} Hz, usual is at "
            f"most {1 / USUAL:g} ({self._terms}); lower study: speed_loop: crossover"
        )

    @property
    def _terms(self) -> str:
        mode = f", first torsional mode {self.mode:.3g} Hz" if self.mode < inf else ""
        return f"crossover {self.crossover:g} Hz{mode}, {self.rate:g} Hz sample rate"
