"""A rig prepared for integration: arrays, inputs at every sample, step size, initial state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from torquerig.errors import InputError, SimulationError
from torquerig.rig.assembly import Rig
from torquerig.simulation.arrays import Floats
from torquerig.simulation.condensation.lowered_for import lower_for
from torquerig.simulation.effort import refuse_long, refuse_stiff
from torquerig.simulation.failure import why_it_failed
from torquerig.simulation.inputs import Draws, Span, filled, held_while_settling, start
from torquerig.simulation.lower import Lowered
from torquerig.simulation.measured_places import Output
from torquerig.simulation.outputs import outputs_of
from torquerig.simulation.step_choice import step_choices
from torquerig.simulation.term_kinds import Terms


@dataclass(frozen=True)
class Ready:
    """A rig in the layout of the kernel.

    Parameters
    ----------
    steps : int
        Integration steps per sample.
    steps_without_impacts : int
        The same where the flanks of gaps neither meet nor part.
    origin : mapping
        The origin that is written to the recording.
    """

    rig: Rig
    span: Span
    lowered: Lowered
    terms: Terms
    outputs: tuple[Output, ...]
    steps: int
    steps_without_impacts: int
    origin: Mapping[str, Any]

    def start(self) -> tuple[Floats, Floats]:
        """Return the angles [rad] and speeds [rad/s] to start from, shape (nodes + 1,), fresh each time."""
        return start(self.rig, self.lowered, self.terms)

    def failure(self, sample: int, node: int) -> SimulationError:
        """Return the error with node and time at which a speed ceased to be finite, and the cause where known."""
        after = (sample - self.span.settling) / self.span.rate
        why = why_it_failed(
            self.rig, self.lowered, self.terms, sample=sample, steps=self.steps, sample_rate=self.span.rate
        )
        return SimulationError(
            f"the speed of {self.lowered.nodes[node]!r} ceased to be finite {after:.4f} s after the start of the "
            f"recording: {why}"
        )


def ready(
    rig: Rig, span: Span, *, scenario: str = "", substeps: int | None = None, most_steps: int | None = None,
    lowered: Lowered | None = None, draws: Draws | None = None,
) -> Ready:  # fmt: skip
    """Return a rig ready for the span; InputError where there is nothing to record or nothing moves.

    SimulationError where it needs more than ``most_steps`` integration steps a sample, or more than any run may take.

    Parameters
    ----------
    lowered : Lowered, optional
        The rig as ``lower_for`` returns it for this span, where that is done already.
    draws : Draws, optional
        Where random loads are kept for other runs.
    """
    if lowered is None:
        lowered = lower_for(rig, span.seed if span.phase_seed is None else span.phase_seed, rate=span.rate)
    if span.samples < 2:
        length = span.samples / span.rate
        raise InputError(f"a recording of {length:g} s at {span.rate:g} Hz has {span.samples} samples; ask for more")
    if not lowered.drive_terms and not lowered.load_terms and not lowered.imposed_terms:
        raise InputError("nothing moves the rig; add a speed controller to the motor")
    refuse_long(span)
    lowered = held_while_settling(lowered, span)
    terms = filled(rig, lowered, span, draws)
    choice, without_impacts = step_choices(lowered, terms, span.rate)
    if substeps is None and most_steps is None:
        refuse_stiff(choice, lowered, span.rate)
    steps = substeps or choice.steps
    if most_steps is not None and steps > most_steps:
        raise SimulationError(f"the rig needs {steps} integration steps a sample, more than the {most_steps} allowed")
    origin = {"scenario": scenario, "seed": span.seed, "substeps": steps}
    if span.phase_seed is not None:
        origin["phase_seed"] = span.phase_seed
    if lowered.condensation is not None:
        origin["condensed"] = lowered.condensation.sentence()
    fewer = min(steps, without_impacts.steps)
    return Ready(rig, span, lowered, terms, outputs_of(rig, lowered), steps, fewer, origin)
