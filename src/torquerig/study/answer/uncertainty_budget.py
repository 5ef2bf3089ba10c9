"""Measurement uncertainty of one torque reading on the recommended drive, as a budget in the form of the GUM.

Source: JCGM 100:2008 (GUM), 4.2 and 4.3 (types A and B), 5.1.2 (combination), 6.2 (expansion); chapter 8 (steps).
Items that neither the scenario nor the catalog states are listed as not known. They are not taken as zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.metrics.random_error import BLOCKS
from torquerig.study.answer.uncertainty_item import Item

if TYPE_CHECKING:
    from torquerig.study.results import ChainResult, DriveResult, StudyRuns

COVERAGE = 2.0  # [1] k: about 95 % of a normal distribution (GUM 6.3.3)


@dataclass(frozen=True, kw_only=True)
class UncertaintyBudget:
    """The contributions to the uncertainty of one reading, and their combination.

    Parameters
    ----------
    drive, chain : str
        What the budget is for.
    unit : str
        Of all uncertainties: N*m, or N in a line.
    items : tuple of Item
    """

    drive: str
    chain: str
    unit: str
    items: tuple[Item, ...]

    @property
    def combined(self) -> float:
        """The combined standard uncertainty of all known items, taken as independent [unit]."""
        return sqrt(sum(one.standard**2 for one in self.items if one.is_counted and one.standard is not None))

    @property
    def expanded(self) -> float:
        """The expanded uncertainty, k = 2 [unit]."""
        return COVERAGE * self.combined

    @property
    def not_known(self) -> tuple[str, ...]:
        """Names of the items that neither the scenario nor the catalog states."""
        return tuple(one.name for one in self.items if one.standard is None)

    def sentence(self) -> str:
        """Return the result and what it leaves out, in sentences of at most 25 words."""
        unit = self.unit.replace("*", " ")
        known = f"One reading is uncertain by ±{self.expanded:.2g} {unit} (k = {COVERAGE:g})."
        if not self.not_known:
            return known
        return f"{known} This leaves out {len(self.not_known)} items that are not known: {', '.join(self.not_known)}."


def uncertainty_budget(drive: DriveResult, chain: str, runs: StudyRuns) -> UncertaintyBudget:
    """Return the budget of one reading at the operating point of a study, of a simulated drive with one filter.

    The reading error is the rms of a random error. Where that rms has a standard uncertainty itself, the variance of
    the error is the sum of both squares (law of total variance): random load and open catalog data are such items.
    """
    from torquerig.study.answer.sensor_limits import sensor_items

    result = drive.chains[chain]
    items = (_filter_item(result), _load_item(result), _catalog_item(result, runs), *sensor_items(drive, runs))
    return UncertaintyBudget(drive=drive.candidate.name, chain=chain, unit=drive.disturbance.unit, items=items)


def _filter_item(result: ChainResult) -> Item:
    return Item(
        name="filter", kind="B", standard=result.truth_error.value,
        basis="reading error: rms of filtered reading minus true load; remaining lines, removed load, sensor noise",
        source=result.truth_error.source,
    )  # fmt: skip


def _load_item(result: ChainResult) -> Item:
    return Item(
        name="random load", kind="A", standard=result.random_error,
        basis=f"standard error of the reading error from {BLOCKS} blocks of the record, {BLOCKS - 1} degrees of "
        "freedom",
        source="simulated record of the first sample",
        remedy="" if result.random_error is not None else "the record is too short; set a longer study: duration",
    )  # fmt: skip


def _catalog_item(result: ChainResult, runs: StudyRuns) -> Item:
    error, samples = result.truth_error, 1 + runs.study.settings.draws
    name, source = "open catalog data", f"{samples} Monte Carlo samples of the catalog's intervals"
    if samples < 2 or error.low is None or error.high is None:
        if not error.missing:
            return Item(name=name, kind="B", standard=0.0, basis="no value of this drive is open", source="catalog")
        remedy = "one sample has no spread; set study: draws to 4 or more"
        return Item(name=name, kind="B", standard=None, basis="", source=source, remedy=remedy)
    return Item(
        name=name, kind="B", standard=(error.high - error.low) / mean_range(samples), source=source,
        basis="range of the reading error over the samples (open values, phases of the lines) over the mean range of "
        "a normal distribution",
    )  # fmt: skip


def mean_range(samples: int) -> float:
    """Return the mean range of samples of a normal distribution over its standard deviation [1]: 2.326 for five.

    The factor d2 of control charts: the integral of ``1 - F^n - (1 - F)^n``, F the normal distribution. Source:
    Tippett, Biometrika 17 (1925) 364-387.
    """
    from scipy.special import ndtr

    x = np.linspace(-9.0, 9.0, 3601)  # beyond 9 standard deviations the integrand is below 1e-15 for any n up to 1000
    below = ndtr(x)
    return float(np.trapezoid(1 - below**samples - (1 - below) ** samples, x))
