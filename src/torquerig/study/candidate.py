"""A drive of a study by its names and ratios."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from math import isclose


@dataclass(frozen=True, kw_only=True)
class ExchangedParts:
    """Names of the exchanged parts in the rig; ``stage`` is empty where the study exchanges the motor only."""

    motor: str = "motor"
    stage: str = "gearbox"


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A motor on a stage of the chain.

    Parameters
    ----------
    motor : str
        Name in the catalog (an alias stays an alias).
    gearbox : str
        Name of the exchanged stage: in the catalog, of ``study: stages:``, or in the rig (the stage as stated); empty
        where the study exchanges the motor only.
    ratio : float
        Input turns per output turn of the exchanged stage [1]; of the whole chain where no stage is exchanged.
    whole_ratio : float or None
        Motor turns per turn of the measured shaft [1]; None where it is that of the stage.
    told_apart : str
        Name of the stage, in the candidate's name where another candidate has the same motor and ratio.
    parts : ExchangedParts
        Names of the exchanged parts in the rig.
    moves_in_a_line : bool
        Whether the stage is a linear drive; its ratio is then the angle per travel [rad/m].
    """

    motor: str
    gearbox: str
    ratio: float
    whole_ratio: float | None = None
    told_apart: str = ""
    parts: ExchangedParts = field(default_factory=ExchangedParts)
    moves_in_a_line: bool = False

    @property
    def ratio_text(self) -> str:
        """The ratio for tables: ``5:1``, or ``5:1 of 12.5:1`` for a stage of a chain; ``1:1`` without a gear."""
        whole = self.ratio if self.whole_ratio is None else self.whole_ratio
        chain = "" if isclose(whole, self.ratio, rel_tol=1e-9) else f" of {self._text(whole)}"
        return f"{self._text(self.ratio)}{chain}"

    def _text(self, ratio: float) -> str:
        if not self.moves_in_a_line:
            return f"{ratio:.5g}:1"
        from torquerig.scenario.kinematics import travel_text

        return travel_text(ratio)

    @cached_property
    def name(self) -> str:
        """The name in tables: ``HDS6A-0104A 5:1``; the motor alone where nothing turns at another speed."""
        direct = not self.gearbox and self.ratio == 1
        return " ".join(word for word in (self.motor, self.told_apart, "" if direct else self.ratio_text) if word)
