"""One value of an entry that was converted from a data sheet, with the conversion in words."""

from __future__ import annotations

from dataclasses import dataclass

MARK = "as printed: "
"""Start of the note of a converted value; ``torquerig catalog show`` lists these notes."""


@dataclass(frozen=True)
class Converted:
    """A converted value.

    Parameters
    ----------
    field : str
        Dotted field of the entry: ``ripple.cogging_native``.
    low, high : float
        Range [SI]; equal where the sheet states one number without ambiguity.
    unit : str
        SI unit of the field.
    words : str
        The conversion: ``Ke 27.8 V/krpm line-to-line rms, times sqrt(3)``.
    key : str
        Key of ``as_printed`` from which it comes.
    """

    field: str
    low: float
    high: float
    unit: str
    words: str
    key: str

    def scaled(self, by: float) -> tuple[float, float]:
        """Return the range times ``by``."""
        return self.low * by, self.high * by
