"""Simulation: from a rig, a duration and a random seed to a recording."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation import kernel
from torquerig.simulation.condensation.lowered_for import lower_for
from torquerig.simulation.inputs import Span, filled, held_while_settling
from torquerig.simulation.lost_friction import friction_lost
from torquerig.simulation.measured_places import Output, through_chains
from torquerig.simulation.motor_limit import limits_reached
from torquerig.simulation.outputs import as_arrays, channels_of, true_channels
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.sampling import SAMPLE_RATE, SETTLING
from torquerig.simulation.step_choice import StepChoice, step_choice
from torquerig.simulation.step_watch import watched
from torquerig.version import __version__


def simulate(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, scenario: str = "", substeps: int | None = None, most_steps: int | None = None,
    phase_seed: int | None = None,
) -> Recording:  # fmt: skip
    """Return the simulated recording of the rig's sensor, with truth channels.

    Parameters
    ----------
    duration : float
        Length of the recording [s].
    settling : float
        How long the rig turns before the recording starts [s]; where nothing controls or imposes a speed, it is held
        at its set-point so long.
    seed : int
        Fixes phases, load and noise, each by its own name: the same seed gives the same bytes.
    phase_seed : int, optional
        Fixes the phases instead of ``seed``: another machine under the same load.
    wander : float
        Relative rms of the slow wander of the speed in steady runs [1].
    substeps : int, optional
        Integration steps per sample, taken unchecked; when not given, chosen from the fastest mode or event
        (``step_choice``) and checked (``step_watch``).
    most_steps : int, optional
        The largest permitted number of steps.

    Raises
    ------
    SimulationError
        When it needs more steps than that, or when a speed ceases to be finite: names the node, the time and, where
        known, the cause.
    """
    span = Span.of(
        duration=duration, settling=settling, rate=sample_rate, seed=seed, wander=wander, phase_seed=phase_seed
    )
    run = ready(rig, span, scenario=scenario, substeps=substeps, most_steps=most_steps)
    return checked(run) if substeps is None and most_steps is None else stepped(run)


def checked(run: Ready) -> Recording:
    """Return what ``stepped`` returns; what is doubtful of it is under ``warnings`` of its origin, a sentence each."""
    kept = np.empty((len(run.outputs), run.span.samples))
    watch, failed, node = watched(run, kept)
    if failed >= 0:
        raise run.failure(failed, node)
    warnings = [*watch.sentences(), *limits_reached(run, kept), *friction_lost(run, kept)]
    origin = {**run.origin, "warnings": warnings} if warnings else run.origin
    return recorded(run.rig, run.outputs, kept, rate=run.span.rate, origin=origin)


def stepped(run: Ready, *, staged: bool = True) -> Recording:
    """Return the recording of a rig that is ready; SimulationError where a speed ceases to be finite."""
    kept = np.empty((len(run.outputs), run.span.samples))
    span, outputs = run.span, as_arrays(run.outputs)
    failed, node = kernel.integrate(*run.start(), run.terms, outputs, span.rate, span.settling, run.steps, kept)
    if failed >= 0:
        raise run.failure(failed, node)
    return recorded(run.rig, run.outputs, kept, rate=span.rate, origin=run.origin, staged=staged)


def recorded(
    rig: Rig, outputs: tuple[Output, ...], kept: NDArray[np.float64], *, rate: float, origin: Mapping[str, Any],
    staged: bool = True,
) -> Recording:  # fmt: skip
    """Return the recording of a run: what was kept as channels, and each sensor's through its stages to the file.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
        In SI units.
    origin : mapping
        What made it; ``seed`` fixes the noise.
    staged : bool
        False for the true values alone.
    """
    recording = Recording(
        sample_rate=rate,
        channels=channels_of(rig, outputs, kept, rate=rate) if staged else true_channels(outputs, kept, rate=rate),
        run=rig.run,
        origin={"torquerig": __version__, **origin},
        name=str(origin.get("scenario") or "simulation"),
    )
    return through_chains(rig, recording) if staged else recording


def choice_for(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, substeps: int | None = None,
) -> StepChoice:  # fmt: skip
    """Return the steps that ``simulate`` takes and their reason; or the accuracy of given ``substeps``."""
    span = Span.of(duration=duration, settling=settling, rate=sample_rate, seed=seed, wander=wander)
    lowered = held_while_settling(lower_for(rig, seed, rate=sample_rate), span)
    chosen = step_choice(lowered, filled(rig, lowered, span), sample_rate)
    return chosen if substeps is None else StepChoice(substeps, 1 / sample_rate / substeps, chosen.fixed_by)
