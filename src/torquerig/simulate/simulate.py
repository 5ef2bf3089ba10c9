"""Forwards: a rig, a duration and a seed in, a recording out."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig import __version__
from torquerig.errors import InputError, SimulationError
from torquerig.rig.rig import Rig
from torquerig.signals.recording import Recording
from torquerig.simulate import kernel
from torquerig.simulate.failure import why_it_failed
from torquerig.simulate.inputs import Span, filled, held_while_settling, start
from torquerig.simulate.lower import lower
from torquerig.simulate.outputs import Output, as_arrays, channels_of, outputs_of
from torquerig.simulate.step_choice import StepChoice, step_choice

SAMPLE_RATE = 25_000.0  # [Hz] the rig's converter
SETTLING = 1.5  # [s] the rig turns this long before the recording starts


def simulate(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, scenario: str = "", substeps: int | None = None,
) -> Recording:  # fmt: skip
    """Return what the rig's sensor records, with the truth beside it in channels marked as such.

    Parameters
    ----------
    duration : float
        Length of the recording [s].
    settling : float
        How long the rig turns before the recording starts [s]; where nothing controls or imposes a speed, it is held
        at its set-point so long.
    seed : int
        Fixes phases, load and noise, each by its own name: the same seed gives the same bytes.
    wander : float
        Relative rms of the slow wander of the speed in steady runs [1].
    substeps : int, optional
        Integration steps per sample; chosen from the fastest mode or event when not given (see ``step_choice``).

    Raises
    ------
    SimulationError
        When a speed ceases to be finite: names the node, the time and, as far as it can be told, why.
    """
    samples, unkept = round(duration * sample_rate), round(settling * sample_rate)
    span = Span(settling=unkept, samples=samples, rate=sample_rate, seed=seed, wander=wander)
    lowered = lower(rig, seed)
    if samples < 2:
        raise InputError(f"a recording of {duration:g} s at {sample_rate:g} Hz has {samples} samples; ask for more")
    if not lowered.drive_terms and not lowered.load_terms and not lowered.imposed_terms:
        raise InputError("nothing moves the rig; add a speed controller to the motor")
    lowered = held_while_settling(lowered, span)
    terms = filled(rig, lowered, span)
    outputs = outputs_of(rig, lowered)
    theta, omega = start(rig, lowered, terms)
    kept = np.empty((len(outputs), samples))
    steps = substeps or step_choice(lowered, terms, sample_rate).steps
    failed, node = kernel.integrate(theta, omega, terms, as_arrays(outputs), sample_rate, unkept, steps, kept)
    if failed >= 0:
        raise SimulationError(
            f"the speed of {lowered.nodes[node]!r} ceased to be finite {(failed - unkept) / sample_rate:.4f} s after "
            "the start of the recording: "
            + why_it_failed(rig, lowered, terms, sample=failed, steps=steps, sample_rate=sample_rate)
        )
    return recorded(
        rig, outputs, kept, rate=sample_rate, origin={"scenario": scenario, "seed": seed, "substeps": steps}
    )


def recorded(
    rig: Rig, outputs: tuple[Output, ...], kept: NDArray[np.float64], *, rate: float, origin: Mapping[str, Any]
) -> Recording:
    """Return the recording of a run: what was kept as channels, and the sensor's through its stages to the file.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
        In SI units.
    origin : mapping
        What made it; ``seed`` fixes the noise.
    """
    recording = Recording(
        sample_rate=rate,
        channels=channels_of(rig, outputs, kept),
        run=rig.run,
        origin={"torquerig": __version__, **origin},
        name=str(origin.get("scenario") or "simulation"),
    )
    for stage in rig.stages():
        recording = stage.apply(recording)
    return recording


def choice_for(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, substeps: int | None = None,
) -> StepChoice:  # fmt: skip
    """Return the steps that ``simulate`` would take, what fixed them, or how far ``substeps`` of your own reach."""
    span = Span(
        settling=round(settling * sample_rate), samples=round(duration * sample_rate), rate=sample_rate, seed=seed,
        wander=wander,
    )  # fmt: skip
    lowered = held_while_settling(lower(rig, seed), span)
    chosen = step_choice(lowered, filled(rig, lowered, span), sample_rate)
    return chosen if substeps is None else StepChoice(substeps, 1 / sample_rate / substeps, chosen.fixed_by)
