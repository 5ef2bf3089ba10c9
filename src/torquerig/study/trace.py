"""Calculation of every cell of a study: catalog values, simulated metric, value function, points, verdict."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from torquerig.decide.trace import (
    CellTrace,
    Outcome,
    Steps,
    end_steps,
    point_steps,
    requirement_steps,
    sign_steps,
    value_steps,
)
from torquerig.errors import UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from torquerig.decide.cell import Cell, Origin
    from torquerig.decide.criterion import Criterion
    from torquerig.decide.eliminate import ChartRow
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study
    from torquerig.study.scoring import Decided
    from torquerig.study.verdict import Verdict


@dataclass(frozen=True, kw_only=True)
class TracedDrive:
    """The cells of one drive with one filter.

    Parameters
    ----------
    drive, combination : str
        ``combination`` is empty where the drive was not simulated or a requirement eliminates it.
    requirements, criteria : tuple of CellTrace
    origins : tuple of (Origin, tuple of str)
        Each catalog value once, with the criteria and requirements that use it.
    end : tuple of (str, str)
        Sum, rank and decision, which all cells share.
    """

    drive: str
    combination: str
    requirements: tuple[CellTrace, ...]
    criteria: tuple[CellTrace, ...]
    origins: tuple[tuple[Origin, tuple[str, ...]], ...]
    end: tuple[tuple[str, str], ...]


def traced_drives(decided: Decided, verdict: Verdict) -> tuple[TracedDrive, ...]:
    """Return every drive with its best filter, in the order of the ranking; eliminated ones last."""
    best: dict[str, str] = {}
    for name in decided.ranked():
        best.setdefault(decided.alternatives[name].drive.candidate.name, name)
    rest = {drive: "" for drive in decided.requirements.alternatives if drive not in best}
    return tuple(traced_drive(decided, verdict, drive, name) for drive, name in {**best, **rest}.items())


def traced_combinations(decided: Decided, verdict: Verdict) -> tuple[TracedDrive, ...]:
    """Return every drive with every filter, in the order of the ranking; eliminated ones last."""
    made = {name: decided.alternatives[name].drive.candidate.name for name in decided.ranked()}
    rest = [drive for drive in decided.requirements.alternatives if drive not in made.values()]
    listed = [*((drive, name) for name, drive in made.items()), *((drive, "") for drive in rest)]
    return tuple(traced_drive(decided, verdict, drive, name) for drive, name in listed)


def traced_drive(decided: Decided, verdict: Verdict, drive: str, combination: str) -> TracedDrive:
    """Return the cells of a drive, and of it with a filter where ``combination`` names one."""
    row = _row(decided, drive)
    criteria = decided.matrix.criteria if combination else ()
    standing = Outcome(
        decision=row.decision, best_share=verdict.shares.get(combination, 0.0), certainty=verdict.certainty
    )
    end = end_steps(decided.overall, combination, standing) if combination else [("decision", str(row.decision))]
    return TracedDrive(
        drive=drive,
        combination=combination,
        requirements=tuple(_requirement(decided, drive, one.name) for one in decided.requirements.criteria),
        criteria=tuple(_criterion(decided, verdict, combination, one.name) for one in criteria),
        origins=_origins(decided, drive, combination),
        end=tuple(end),
    )


def traced_cell(decided: Decided, verdict: Verdict, alternative: str, name: str) -> CellTrace:
    """Return the calculation of one cell: a criterion of a combination, or a requirement on a drive.

    Parameters
    ----------
    alternative : str
        ``HDS6A-0104A 5:1 | order_lines``; a drive alone (``HDS6A-0104A 5:1``) means its best combination.

    Raises
    ------
    UnknownNameError
        With the close matches.
    """
    drive, _, chain = alternative.partition(" | ")
    criteria = [one.name for one in decided.matrix.criteria]
    requirements = [one.name for one in decided.requirements.criteria]
    made = [one for one in decided.ranked() if decided.alternatives[one].drive.candidate.name == drive]
    chains = [decided.alternatives[one].chain for one in made]
    _check(alternative, name, drives=decided.requirements.alternatives, chains=chains, rows=(*criteria, *requirements))
    if name in requirements and (name not in criteria or not chain):
        return _requirement(decided, drive, name)
    if not made:
        raise UnknownNameError(
            f"{drive} is eliminated and has no {name!r}; the requirements on it are {', '.join(requirements)}"
        )
    return _criterion(decided, verdict, alternative if chain else made[0], name)


def check_traced(study: Study, pairs: Iterable[tuple[str, str]], drives: Sequence[Candidate]) -> None:
    """Raise UnknownNameError for a cell that the study of these drives does not have, before the simulation."""
    rows = tuple(study.settings.criteria) + tuple(study.settings.requirements)
    chains = tuple(dict.fromkeys((*study.settings.filters.names, study.settings.present.filter)))
    for alternative, name in pairs:
        _check(alternative, name, drives=[one.name for one in drives], chains=chains, rows=rows)


def _check(
    alternative: str, name: str, *, drives: Sequence[str], chains: Sequence[str], rows: Sequence[str]
) -> None:  # fmt: skip
    drive, _, chain = alternative.partition(" | ")
    if drive not in drives:
        raise UnknownNameError(f"there is no drive {drive!r} in the study; {did_you_mean(drive, drives)}")
    if name not in rows:
        raise UnknownNameError(f"the study has no criterion or requirement {name!r}; {did_you_mean(name, rows)}")
    if chain and chains and chain not in chains:
        raise UnknownNameError(f"the study has no filter {chain!r}; {did_you_mean(chain, chains)}")


def _requirement(decided: Decided, drive: str, name: str) -> CellTrace:
    criterion = next(one for one in decided.requirements.criteria if one.name == name)
    steps = (
        *_value(decided.requirements.cell(drive, name), criterion, drive),
        *requirement_steps(decided.chart, criterion, drive),
        ("decision", str(_row(decided, drive).decision)),
    )
    return CellTrace(alternative=drive, criterion=name, steps=steps)


def _criterion(decided: Decided, verdict: Verdict, combination: str, name: str) -> CellTrace:
    criterion = next(one for one in decided.matrix.criteria if one.name == name)
    drive = decided.alternatives[combination].drive.candidate.name
    standing = Outcome(
        decision=_row(decided, drive).decision,
        best_share=verdict.shares.get(combination, 0.0),
        certainty=verdict.certainty,
    )
    steps = (
        *_value(decided.matrix.cell(combination, name), criterion, combination),
        *sign_steps(decided.pugh, criterion, combination),
        *point_steps(decided.overall, criterion, combination, standing),
    )
    return CellTrace(alternative=combination, criterion=name, steps=steps)


def _value(cell: Cell, criterion: Criterion, alternative: str) -> Steps:
    """Return the steps to the value; a spread between Monte Carlo samples alone is no missing value.

    Where catalog values are listed, so are their sources.
    """
    steps = value_steps(replace(cell, source="") if cell.origins else cell, criterion, alternative)
    return steps if cell.unknown or cell.unknown_reason else [one for one in steps if one[0] != "missing"]


def _row(decided: Decided, drive: str) -> ChartRow:
    return next(row for row in decided.chart.rows if row.alternative == drive)


def _origins(decided: Decided, drive: str, combination: str) -> tuple[tuple[Origin, tuple[str, ...]], ...]:
    used: dict[str, tuple[Origin, list[str]]] = {}
    cells = [(one.name, decided.requirements.cell(drive, one.name)) for one in decided.requirements.criteria]
    if combination:
        cells = [*((one.name, decided.matrix.cell(combination, one.name)) for one in decided.matrix.criteria), *cells]
    for name, cell in cells:
        for origin in cell.origins:
            names = used.setdefault(origin.name, (origin, []))[1]
            names += [] if name in names else [name]
    return tuple((origin, tuple(names)) for origin, names in used.values())
