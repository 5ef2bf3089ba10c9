"""Which runs of a batch can be stepped together."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.assembly import Rig
from torquerig.simulation.condensation.lowered_for import lower_for
from torquerig.simulation.inputs import Draws, Span, filled, held_while_settling
from torquerig.simulation.kernel.lanes import LANES
from torquerig.simulation.lower import Lowered
from torquerig.simulation.measured_places import Output
from torquerig.simulation.outputs import TRUE_OUTPUTS, outputs_of
from torquerig.simulation.shared_waves import can_share_waves
from torquerig.simulation.step_choice import step_choice, step_without_impacts
from torquerig.simulation.term_kinds import KINDS, Terms


@dataclass(frozen=True, kw_only=True)
class BatchRun:
    """A rig, the span of its run, and the rig as arrays; made by ``of``.

    Parameters
    ----------
    staged : bool
        Whether what is measured goes through its measuring chains; False where only its true values are needed.
    """

    rig: Rig
    span: Span
    lowered: Lowered
    staged: bool = True

    @classmethod
    def of(cls, rig: Rig, span: Span, *, staged: bool = True) -> BatchRun:
        """Return the run with its rig lowered, as ``simulate`` lowers it."""
        lowered = lower_for(rig, span.seed if span.phase_seed is None else span.phase_seed, rate=span.rate)
        return cls(rig=rig, span=span, lowered=held_while_settling(lowered, span), staged=staged)

    @cached_property
    def likeness(self) -> Hashable:
        """The structure that rigs must share to be integrated together: all whole numbers and kinds of laws."""
        shared = tuple(
            (array.shape, _shared(array, decides=decides).tobytes()) for array, decides in _arrays(self.lowered)
        )
        return self.lowered.nodes, self.outputs, shared

    @cached_property
    def likeness_but_for_waves(self) -> Hashable:
        """The same without the waves, where those can be given one structure; see ``shared_waves``."""
        if not can_share_waves(self.lowered.arrays):
            return self.likeness
        shared = tuple(
            (array.shape, _shared(array, decides=decides).tobytes()) for array, decides in _but_for_waves(self.lowered)
        )
        return self.lowered.nodes, self.outputs, shared

    @property
    def number_of_waves(self) -> int:
        """How many cosines an evaluation computes."""
        waves = self.lowered.arrays.waves
        return int(waves.ladder[-1]) + waves.first.size

    @cached_property
    def probable_steps(self) -> int:
        """The integration steps per sample at the first set-point, most often those of the whole run."""
        return step_choice(self.lowered, self._at_first(Draws()), self.span.rate).steps

    def steps_without_impacts(self, draws: Draws) -> int:
        """Return the same where the flanks of gaps neither meet nor part; ``draws`` holds loads for other runs."""
        return step_without_impacts(self.lowered, self._at_first(draws), self.span.rate).steps

    def _at_first(self, draws: Draws) -> Terms:
        return filled(self.rig, self.lowered, replace(self.span, settling=0, samples=2, wander=0.0), draws)

    @cached_property
    def outputs(self) -> tuple[Output, ...]:
        """The outputs that are kept: all, or the true measured value and the true load where nothing is staged."""
        return outputs_of(self.rig, self.lowered)[: None if self.staged else TRUE_OUTPUTS]


def alike(runs: Sequence[BatchRun]) -> list[list[int]]:
    """Return the rows of runs that are alike and have one step, in parts of about the same size that fit the lanes."""
    found: dict[Hashable, list[int]] = {}
    for row, run in enumerate(runs):
        found.setdefault((run.likeness, run.probable_steps), []).append(row)
    return [
        [int(row) for row in part] for rows in found.values() for part in np.array_split(rows, -(-len(rows) // LANES))
    ]


def _arrays(lowered: Lowered) -> list[tuple[NDArray[Any], bool]]:
    """Return all arrays of a rig, each with whether its zeros decide what is computed."""
    arrays = [(array, False) for array in lowered.arrays.waves]
    for kind in KINDS:
        rows = getattr(lowered.arrays, kind.field)
        arrays += [(array, name in kind.deciding) for name, array in rows._asdict().items()]
    return arrays


def _but_for_waves(lowered: Lowered) -> list[tuple[NDArray[Any], bool]]:
    """Return the arrays of a rig that ``with_shared_waves`` does not replace."""
    arrays = lowered.arrays
    replaced = {id(array) for array in (*arrays.waves, *arrays.harmonics)}
    replaced |= {id(array) for name, array in arrays.springs._asdict().items() if name.startswith("e_")}
    replaced |= {id(array) for name, array in arrays.drives._asdict().items() if name.startswith("r_")}
    return [(array, decides) for array, decides in _arrays(lowered) if id(array) not in replaced]


def _shared(array: NDArray[Any], *, decides: bool) -> NDArray[Any]:
    if array.dtype != np.float64:
        return array
    return array == 0 if decides else array[:0]
