"""A study computed at several values of quantities of its scenario, such as the occupancy or the speed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.document import Document, parse_document
from torquerig.errors import InputError
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import Study, open_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.settings import read_settings
from torquerig.study.verdict import Verdict, verdict

if TYPE_CHECKING:
    from torquerig.catalog.shelves import Catalog
    from torquerig.study.results import DriveResult, StudyRuns

Axes = Mapping[str, tuple[str, ...]]
"""The values of each swept quantity, as the scenario states it."""
MOST_POINTS = 40  # each is a run of every drive: an hour, and a page of 10 MB


@dataclass(frozen=True)
class SweptPoint:
    """A computed point: its values by quantity, and the study there with one sample of each drive."""

    values: Mapping[str, str]
    runs: StudyRuns

    @cached_property
    def decided(self) -> Decided:
        """The matrices at this point."""
        return decide(self.runs)

    @cached_property
    def verdict(self) -> Verdict:
        """What to do at this point."""
        return verdict(self.decided)

    @property
    def text(self) -> str:
        """``load.occupancy 5 %, operating_point.output_speed 200 rpm``."""
        return ", ".join(f"{key} {value}" for key, value in self.values.items())


def sweep_axes(document: Document, written: Sequence[str] = ()) -> Axes:
    """Return what a study sweeps: ``sweep:`` of its scenario, and each ``PATH=VALUE,VALUE`` of ``written``.

    Raises
    ------
    InputError
        For fewer than two values, a value that is no number or text, or too many points.
    """
    axes = {key: tuple(map(str, values)) for key, values in read_settings(document).sweep.items()}
    for one in written:
        key, equals, text = one.partition("=")
        if not equals or not key.strip():
            raise InputError(
                f"--sweep {one}: not of the form path=value,value; write for example --sweep load.occupancy=5,11,21"
            )
        axes[key.strip()] = _values(text, one)
    count = prod(map(len, axes.values()))
    if count > MOST_POINTS:
        sizes = " x ".join(f"{len(values)} of {key}" for key, values in axes.items())
        raise InputError(
            f"the sweep has {count} points ({sizes}), at most {MOST_POINTS} are possible; list fewer values"
        )
    return axes


def _values(text: str, written: str) -> tuple[str, ...]:
    listed = parse_document(f"[{text.strip().removeprefix('[').removesuffix(']')}]", Path("value")).data
    if len(set(map(str, listed))) < 2 or any(isinstance(one, dict | list) or one is None for one in listed):
        raise InputError(
            f"--sweep {written}: needs two or more different values, such as load.occupancy=5,11,21 or "
            "operating_point.output_speed=100 rpm,200 rpm"
        )
    return tuple(map(str, dict.fromkeys(listed)))


def sweep(
    document: Document, catalog: Catalog, axes: Axes, *, run: Callable[[Study, str], StudyRuns]
) -> tuple[SweptPoint, ...]:
    """Return every combination of the values of ``axes``, each computed; nothing is interpolated.

    Each point has one Monte Carlo sample of a drive, the nominal one, under the same random load.

    Parameters
    ----------
    document : Document
        The scenario with its edits.
    run : callable
        Computes a study, given with a title of the point for its progress.
    """
    points = [dict(zip(axes, values, strict=True)) for values in product(*axes.values())] if axes else []
    studies = [_study(document, catalog, values) for values in points]  # every one is read before the first is run
    made = []
    for number, (values, study) in enumerate(zip(points, studies, strict=True), start=1):
        made.append(SweptPoint(values, run(study, f"point {number} of {len(points)}")))
    return tuple(made)


def _study(document: Document, catalog: Catalog, values: Mapping[str, str]) -> Study:
    study = open_study(
        overridden(document, [f"{key}={value}" for key, value in values.items()], option="sweep"), catalog
    )
    return Study(study.document, study.settings.model_copy(update={"draws": 0}), study.catalog, study.filters)


def least_error(drive: DriveResult) -> tuple[str, float] | None:
    """Return the filter with the least reading error and that error; None where the drive was not simulated."""
    known = {name: one.truth_error.value for name, one in drive.chains.items() if one.truth_error.value is not None}
    return min(known.items(), key=lambda one: one[1], default=None)
