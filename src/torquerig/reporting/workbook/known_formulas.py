"""A worksheet whose formulas use functions that every version of Excel has."""

from __future__ import annotations

from xlsxwriter.worksheet import Worksheet


class KnownFormulas(Worksheet):  # type: ignore[misc]
    """A worksheet that does not look for functions of newer versions in each formula: 30 searches, 30 us.

    Where a release of the library prepares formulas elsewhere, the sheet is the same and only takes longer.
    """

    def _prepare_formula(self, formula: str, expand_future_functions: bool = False) -> str:
        return formula.removeprefix("=")
