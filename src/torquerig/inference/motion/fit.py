"""The parameters of a model at the maximum of their posterior density, and Laplace's evidence."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.density import densities, fitted_density, log_density, shape_of, weights
from torquerig.inference.motion.fitted_model import Fit, PerRun, effort_scale, simulated
from torquerig.inference.motion.hypothesis import Hypothesis, Model, parameter_names
from torquerig.inference.motion.imposed_run import ImposedRun

Floats = NDArray[np.float64]

ZERO_SPREAD = 0.03  # of the rms effort: standard deviation of the zero of the effort's channel
_MOST = 6.0  # standard deviations of its prior that a parameter may move
_LONGEST = 1.5  # standard deviations in one step: the derivatives are those of one place
_RELATIVE = 0.02  # change of a number for its derivative [1]
_OUTER, _INNER = 12, 4
_CONVERGED = 0.2  # [nats]


def fitted(
    model: Model, runs: Sequence[ImposedRun], *, after: Fit | None = None, steps: int = _OUTER, bar: Fit | None = None
) -> Fit | None:  # fmt: skip
    """Return a model fitted to the frames that may be seen, or None where its rig cannot be simulated.

    Simulated parameters are first moved by least squares, then by the likelihood. A large slow residual can otherwise
    be taken for noise of a red density, and a sharp edge of a model that is not right yet weighs more than its gain.

    Parameters
    ----------
    after : Fit, optional
        A similar fit: positions and derivatives of parameters of the same name are taken from it.
    steps : int
        Steps of the simulated parameters at most in each stage; 0 only refits what is linear.
    bar : Fit, optional
        A fit that is to be bettered: where the local model does not promise that, no further step is taken.
    """
    search = _Search(model, tuple(runs), after)
    if search.base is None:
        return None
    if after is None or bar is not None:
        _climb(search, steps, None if bar is None else _white_value(bar), white=True)
    _climb(search, steps, None if bar is None else bar.log_posterior, white=False)
    return search.result()


def _climb(search: _Search, steps: int, bar: float | None, *, white: bool) -> None:
    search.white = white
    search.settle()
    for _ in range(steps):
        if not search.moving or (bar is not None and search.promise() < bar):
            break
        gain = search.step()
        if gain is None and not search.refreshed():
            break
        if gain is not None and gain < _CONVERGED:
            break


def _white_value(fit: Fit) -> float:
    """Return the log posterior of a fit if its residual were white."""
    seen = [each[run.seen].ravel() for each, run in zip(fit.residuals, fit.runs, strict=True) if run.seen.any()]
    residual = np.concatenate(seen)
    return log_density(residual, np.asarray(np.mean(residual**2))) - 0.5 * float(fit.positions @ fit.positions)


class _Search:
    """The state of one fit: where it is, and its derivatives."""

    def __init__(self, model: Model, runs: tuple[ImposedRun, ...], after: Fit | None) -> None:
        self.model, self.runs, self.white = model, runs, False
        self.scale = effort_scale(runs)
        self.fitted_runs = [row for row, run in enumerate(runs) if run.seen.any()]
        columns = {each.name: _columns(each, runs) for each in model.linear}
        self.names = parameter_names(model, runs, {name: len(one[0]) for name, one in columns.items()})
        self.moving = len(model.knobs) + (len(runs) if model.zeros else 0)
        known = {} if after is None else after.start()
        default = dict(zip((k.name for k in model.knobs), _starts(model), strict=True))
        self.at = np.array([known.get(name, default.get(name, 0.0)) for name in self.names])
        self.derivatives = self._linear(columns)
        self.fresh: set[str] = set()
        same = (
            after is not None
            and after.names[: self.moving] == self.names[: self.moving]
            and (after.moving == self.moving and np.array_equal(after.positions[: self.moving], self.at[: self.moving]))
        )
        self.base = after.base if same and after is not None else self.simulated(self.at)
        if self.base is None:
            return
        kept = {} if after is None else after.derivatives
        for row, name in enumerate(self.names[: self.moving]):
            self.derivatives[name] = kept[name] if name in kept else self._derivative(row)
        self.shape = shape_of([runs[row] for row in self.fitted_runs])
        self.nodes = np.zeros(self.shape.basis.shape[1])
        if after is not None and after.nodes.size == self.nodes.size:
            self.nodes = after.nodes
        else:
            self.nodes[: self.nodes.size - len(self.fitted_runs)] = 2 * np.log(0.1 * self.scale)
        self.settle()

    def _linear(self, columns: dict[str, list[Floats]]) -> dict[str, PerRun]:
        zero = ZERO_SPREAD * self.scale
        answer = {"effort zero": [zero * run.transformed(np.ones(run.effort.size)) for run in self.runs]}
        for each in self.model.linear:
            for number in range(len(columns[each.name][0])):
                whole = [each.scale * one[number] for one in columns[each.name]]
                if not each.local:
                    answer[f"{each.name}[{number}]"] = whole
                    continue
                for row, run in enumerate(self.runs):
                    alone = [one if at == row else np.zeros_like(one) for at, one in enumerate(whole)]
                    answer[f"{each.name}[{number}]@{run.name}"] = alone
        return answer

    def simulated(self, at: Floats) -> PerRun | None:
        """Return measured minus needed effort in frames and bins; runs without fitted frames are zero."""
        return simulated(self.model, self.runs, at, [bool(run.seen.any()) for run in self.runs])

    def _derivative(self, row: int) -> PerRun:
        assert self.base is not None
        knobs = self.model.knobs
        factor = row < len(knobs) and knobs[row].factor
        size = min(0.1, _RELATIVE / knobs[row].spread) if factor else 0.05
        other = self.at.copy()
        other[row] += size
        only = [bool(run.seen.any()) for run in self.runs]
        if row >= len(knobs):
            only = [one and at == row - len(knobs) for at, one in enumerate(only)]
        changed = simulated(self.model, self.runs, other, only)
        self.fresh.add(self.names[row])
        if changed is None:
            return [np.zeros_like(one) for one in self.base]
        return [
            (one - two) / size if used else np.zeros_like(one)
            for one, two, used in zip(self.base, changed, only, strict=True)
        ]

    def refreshed(self) -> bool:
        """Compute all derivatives again; return whether any was old."""
        old = [row for row, name in enumerate(self.names[: self.moving]) if name not in self.fresh]
        for row in old:
            self.derivatives[self.names[row]] = self._derivative(row)
        return bool(old)

    def _design(self) -> tuple[Floats, Floats]:
        """Return what the parameters change, shape (rows, parameters), and the simulated difference, in fitted rows."""
        assert self.base is not None
        rows = [(row, self.runs[row].seen) for row in self.fitted_runs]
        design = np.column_stack(
            [np.concatenate([self.derivatives[name][row][mask].ravel() for row, mask in rows]) for name in self.names]
        )
        return design, np.concatenate([self.base[row][mask].ravel() for row, mask in rows])

    def _split(self, values: Floats) -> PerRun:
        shapes = [(int(self.runs[row].seen.sum()), self.runs[row].frequencies.size) for row in self.fitted_runs]
        parts = np.split(values, np.cumsum([a * b for a, b in shapes])[:-1])
        return [part.reshape(shape) for part, shape in zip(parts, shapes, strict=True)]

    def _density(self, residual: Floats) -> Floats:
        """Estimate the density and return it for each fitted row; of the mean square where it is white."""
        if self.white:
            return np.full(residual.size, float(residual @ residual) / residual.size)
        split = self._split(residual)
        self.nodes = fitted_density(self.shape, [one**2 for one in split], self.nodes, least=self.scale)
        chosen = [self.runs[row] for row in self.fitted_runs]
        each = densities(self.shape, self.nodes, chosen, least=self.scale)
        return np.concatenate(
            [np.broadcast_to(s, one.shape).ravel() for s, one in zip(each, split, strict=True)]
        )  # fmt: skip

    def _log_posterior(self, residual: Floats, density: Floats, at: Floats) -> float:
        prior = 0.5 * float(at @ at)
        prior += 0.0 if self.white else 0.5 * float(self.nodes @ self.shape.precision @ self.nodes)
        return log_density(residual, density) - prior

    def _solved(self, *, hold: bool) -> Floats:
        """Return the positions that are best in the local model; with ``hold`` only those of linear parameters move."""
        design, base = self._design()
        free = slice(self.moving, None) if hold else slice(None)
        at, part = self.at.copy(), design[:, free]
        # the base is the simulated difference at self.at: linear parameters count from zero, others from where they are
        origin = np.where(np.arange(at.size) < self.moving, self.at, 0.0)
        for _ in range(_INNER):
            residual = base - design @ (at - origin)
            w = weights(residual, self._density(residual))
            hessian = part.T @ (part * w[:, None]) + np.eye(part.shape[1])
            at[free] += np.linalg.solve(hessian, part.T @ (w * residual) - at[free])
        return at

    def settle(self) -> None:
        """Refit the linear parameters and the density where the others are."""
        self.at = self._solved(hold=True)

    def value(self) -> float:
        """Return the log posterior where the search is."""
        design, base = self._design()
        residual = base - design[:, self.moving :] @ self.at[self.moving :]
        return self._log_posterior(residual, self._density(residual), self.at)

    def promise(self) -> float:
        """Return the log posterior that the local model has at its maximum."""
        nodes, at = self.nodes, self._solved(hold=False)
        design, base = self._design()
        origin = np.where(np.arange(at.size) < self.moving, self.at, 0.0)
        residual = base - design @ (at - origin)
        value = self._log_posterior(residual, self._density(residual), at)
        self.nodes = nodes
        return value

    def step(self) -> float | None:
        """Take a step, shortened until the posterior rises; return by how much, None where it does not."""
        assert self.base is not None
        before, nodes, old, base = self.value(), self.nodes, self.at, self.base
        wanted = self._solved(hold=False)
        change = (wanted - old)[: self.moving]
        change *= min(1.0, _LONGEST / max(float(np.abs(change).max()), 1e-12))
        for share in (1.0, 0.4, 0.1):
            at = old.copy()
            at[: self.moving] = np.clip(old[: self.moving] + share * change, -_MOST, _MOST)
            tried = self.simulated(at)
            if tried is None:
                continue
            self.base, self.at = tried, at
            self.settle()
            gain = self.value() - before
            if gain > 0:
                self._learn(at[: self.moving] - old[: self.moving], base)
                return gain
        self.base, self.at, self.nodes = base, old, nodes
        return None

    def _learn(self, change: Floats, before: PerRun) -> None:
        """Correct the derivatives by what the step really changed (Broyden 1965)."""
        assert self.base is not None
        square = float(change @ change)
        if square < 1e-12:
            return
        names = self.names[: self.moving]
        for row in self.fitted_runs:
            expected = sum((c * self.derivatives[n][row] for c, n in zip(change, names, strict=True)), start=0.0)
            error = (before[row] - self.base[row]) - expected
            for c, name in zip(change, names, strict=True):
                if c:
                    self.derivatives[name] = list(self.derivatives[name])
                    self.derivatives[name][row] = self.derivatives[name][row] + error * (c / square)
        self.fresh.clear()

    def result(self) -> Fit:
        """Return the fit where the search is."""
        design, base = self._design()
        residual = base - design[:, self.moving :] @ self.at[self.moving :]
        density = self._density(residual)
        w = weights(residual, density)
        hessian = design.T @ (design * w[:, None]) + np.eye(design.shape[1])
        value = self._log_posterior(residual, density, self.at)
        chosen = [self.runs[row] for row in self.fitted_runs]
        each = dict(zip(self.fitted_runs, densities(self.shape, self.nodes, chosen, least=self.scale), strict=True))
        mean = self.shape.basis.shape[1] - len(self.fitted_runs)
        common = [np.exp(_interpolated(self.nodes[:mean], chosen, run)) for run in self.runs]
        return Fit(
            self.model, self.runs, self.names, self.at, self.derivatives, self.base or [], self._residuals(),
            [each.get(row, common[row]) for row in range(len(self.runs))], self.nodes, hessian, value,
            value - 0.5 * float(np.linalg.slogdet(hessian)[1]),
        )  # fmt: skip

    def _residuals(self) -> PerRun:
        assert self.base is not None
        return without_linear(self.base, self.names[self.moving :], self.at[self.moving :], self.derivatives)


def without_linear(base: PerRun, names: Sequence[str], sizes: Floats, derivatives: dict[str, PerRun]) -> PerRun:
    """Return simulated differences minus the effort of the linear parameters, of each run."""
    answer = [one.copy() for one in base]
    for name, size in zip(names, sizes.tolist(), strict=True):
        for row, change in enumerate(derivatives[name]):
            answer[row] -= size * change
    return answer


def _columns(each: Hypothesis, runs: Sequence[ImposedRun]) -> list[Floats]:
    """Return the transformed columns of a hypothesis, of each run of shape (sizes, frames, bins)."""
    assert each.columns is not None
    return [np.array([run.transformed(column) for column in each.columns(run).T]) for run in runs]


def _starts(model: Model) -> list[float]:
    starts = [0.0] * len(model.nuisances)
    for each in model.additions:
        starts += each.start or [0.0] * len(each.knobs)
    return starts


def _interpolated(nodes: Floats, chosen: Sequence[ImposedRun], run: ImposedRun) -> Floats:
    octaves = [np.log2(one.frequencies) for one in chosen]
    grid = np.linspace(min(o.min() for o in octaves), max(o.max() for o in octaves), nodes.size)
    return np.interp(np.log2(run.frequencies), grid, nodes)
