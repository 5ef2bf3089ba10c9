"""Designs of a sensitivity study: which quantiles of the open values are computed, each drive only where it changes."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.cases import Case
from torquerig.catalog.chosen_draws import ChosenDraws
from torquerig.errors import InputError
from torquerig.study.monte_carlo.drawn_study import DrawnStudy

Floats = NDArray[np.float64]
Method = Literal["sobol", "morris"]
LEVELS = 4  # of a Morris design, as its author recommends
PROBED = (0.02, 0.98)  # quantiles at which a value that changes nothing of a rig is recognised


@dataclass(frozen=True)
class Design:
    """The quantiles of all open values in each row, for all drives.

    Parameters
    ----------
    method : {"sobol", "morris"}
    names : tuple of str
        Of the columns: open values that change the rig of at least one drive.
    of_drive : mapping of str to tuple of str
        Those that change the rig of each drive.
    quantiles : ndarray, shape (rows, names)
        [0..1]
    """

    method: Method
    names: tuple[str, ...]
    of_drive: Mapping[str, tuple[str, ...]]
    quantiles: Floats

    @property
    def problem(self) -> dict[str, Any]:
        """The problem as SALib states it."""
        return problem_of(self.names)

    @cached_property
    def plan(self) -> str:
        """The part of a store's identity; a Sobol design of more rows continues one of fewer."""
        rows = "" if self.method == "sobol" else f" of {len(self.quantiles)} rows"
        return f"{self.method}{rows}: {', '.join(self.names)}"

    def cases(self, drawn: DrawnStudy) -> list[Case]:
        """Return the cases: of each drive one for each combination of its values, where it first appears."""
        seed, drives = drawn.study.settings.seed, list(self.of_drive)
        return [
            Case(
                number=int(row) * len(drives) + at,
                values={"drive": name, "draw": int(row), "quantiles": self._stated(name, int(row))},
                seed=seed,
            )
            for at, name in enumerate(drives)
            for row in sorted(set(self.source(name).tolist()))
        ]

    def source(self, drive: str) -> NDArray[np.int64]:
        """Return for each row the first row in which the drive has the same values, shape (rows,)."""
        columns = [self.names.index(name) for name in self.of_drive[drive]]
        _, first, inverse = np.unique(self.quantiles[:, columns], axis=0, return_index=True, return_inverse=True)
        return np.asarray(first[inverse.ravel()], dtype=np.int64)

    def filled(self, tables: Mapping[str, Floats]) -> dict[str, Floats]:
        """Return the tables (drives, rows) with every row: where a drive does not change, its value is repeated."""
        sources = [self.source(name) for name in self.of_drive]
        rows = len(self.quantiles)
        return {
            column: np.array([_to_length(table[at], rows)[source] for at, source in enumerate(sources)])
            for column, table in tables.items()
        }

    def _stated(self, drive: str, row: int) -> str:
        return json.dumps(
            {name: float(self.quantiles[row, self.names.index(name)]) for name in self.of_drive[drive]}
        )  # fmt: skip


def design_of(drawn: DrawnStudy, method: Method, count: int) -> Design:
    """Return a design of ``count`` base points (Sobol) or trajectories (Morris).

    Sobol: rows A, the K rows AB_i with one value from B, and B, for each base point (Saltelli et al. 2010, Computer
    Physics Communications 181, 259-270). Morris: one value changes from row to row (Morris 1991, Technometrics 33).

    Raises
    ------
    InputError
        Where nothing is open, or ``count`` does not suit the method.
    """
    if method == "sobol" and count & (count - 1):
        lower = 1 << (count.bit_length() - 1)
        raise InputError(f"--draws {count}: a Sobol design needs a power of two; write {lower} or {2 * lower}")
    of_drive = {name: tuple(_effective(drawn, name)) for name in drawn.drives}
    names = tuple(dict.fromkeys(name for listed in of_drive.values() for name in listed))
    if not names:
        raise InputError("the data sheets leave nothing open that changes a drive; there is no sensitivity to compute")
    return Design(method, names, of_drive, _sampled(method, names, count, seed=drawn.study.settings.seed))


def problem_of(names: tuple[str, ...]) -> dict[str, Any]:
    """Return the problem of quantiles as SALib states it."""
    return {"num_vars": len(names), "names": list(names), "bounds": [[0.0, 1.0]] * len(names)}


def _sampled(method: Method, names: tuple[str, ...], count: int, *, seed: int) -> Floats:
    if method == "sobol":
        from SALib.sample import sobol

        return np.asarray(sobol.sample(problem_of(names), count, calc_second_order=False, seed=seed))
    from SALib.sample.morris import sample

    return np.asarray(sample(problem_of(names), count, num_levels=LEVELS, seed=seed))


def _effective(drawn: DrawnStudy, drive: str) -> Iterator[str]:
    """Yield the open values of a drive that change its rig; a price, for one, does not."""
    seed = drawn.study.settings.seed
    for name in drawn.unknown[drive]:
        rigs = [drawn.scenario(drive, seed=ChosenDraws(seed, {name: at})).rig for at in PROBED]
        if rigs[0] != rigs[1]:
            yield name


def _to_length(values: Floats, rows: int) -> Floats:
    return np.pad(values, (0, max(0, rows - values.size)), constant_values=np.nan)[:rows]
