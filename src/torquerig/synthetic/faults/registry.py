"""All faults that can be drawn, in one order, and their form in YAML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import BeforeValidator, Field

from torquerig.errors import did_you_mean
from torquerig.recordings.recording import Recording, random_for
from torquerig.synthetic.faults.alias import Alias
from torquerig.synthetic.faults.clipping import Clipping
from torquerig.synthetic.faults.coarse_stamps import CoarseStamps
from torquerig.synthetic.faults.doubled_counts import DoubledCounts
from torquerig.synthetic.faults.drawn_fault import DrawnFault
from torquerig.synthetic.faults.drift import Drift
from torquerig.synthetic.faults.dropouts import Dropouts
from torquerig.synthetic.faults.duplicate_samples import DuplicateSamples
from torquerig.synthetic.faults.gain_changes import GainChanges
from torquerig.synthetic.faults.held_samples import HeldSamples
from torquerig.synthetic.faults.hum import Hum
from torquerig.synthetic.faults.late_stamps import LateStamps
from torquerig.synthetic.faults.lost_counts import LostCounts
from torquerig.synthetic.faults.mean_steps import MeanSteps
from torquerig.synthetic.faults.missing_samples import MissingSamples
from torquerig.synthetic.faults.quantised import Quantised
from torquerig.synthetic.faults.repeated_samples import RepeatedSamples
from torquerig.synthetic.faults.sample_jumps import SampleJumps
from torquerig.synthetic.faults.slips import Slips
from torquerig.synthetic.faults.spikes import Spikes
from torquerig.synthetic.faults.stuck_value import StuckValue
from torquerig.synthetic.faults.sweep_line import SweepLine
from torquerig.synthetic.faults.telegraph_noise import TelegraphNoise
from torquerig.synthetic.faults.wrapped_angle import WrappedAngle
from torquerig.synthetic.faults.wrong_counts_per_turn import WrongCountsPerTurn
from torquerig.synthetic.faults.wrong_rate import WrongRate
from torquerig.synthetic.faults.wrong_scale import WrongScale
from torquerig.synthetic.faults.wrong_sign import WrongSign

FAULTS: tuple[type[DrawnFault], ...] = (
    Dropouts, Spikes, StuckValue, HeldSamples, RepeatedSamples, Clipping, Quantised, Hum, Alias, SweepLine, Drift,
    TelegraphNoise, GainChanges, MeanSteps, SampleJumps, Slips, WrongScale, WrongSign, LostCounts, DoubledCounts,
    WrappedAngle, WrongCountsPerTurn, LateStamps, CoarseStamps, MissingSamples, DuplicateSamples, WrongRate,
)  # fmt: skip
"""Of the torque, then of the encoder, then of the times."""

BY_NAME: Mapping[str, type[DrawnFault]] = {str(each.__dataclass_fields__["type"].default): each for each in FAULTS}


def _known_type(written: Any) -> Any:
    if isinstance(written, DrawnFault):
        return written
    if not isinstance(written, dict):
        raise ValueError(f"{written!r} is no fault; write for example {{type: spikes, height: 0.5 N*m}}")
    if str(written.get("type")) not in BY_NAME:
        name = str(written.get("type", ""))
        raise ValueError(f"the fault has no known type ({name!r}); {did_you_mean(name, BY_NAME)}")
    return written


if TYPE_CHECKING:
    AnyFault = DrawnFault
else:
    AnyFault = Annotated[reduce(or_, FAULTS), Field(discriminator="type"), BeforeValidator(_known_type)]
"""A fault as a mapping with its type and parameters."""


def with_faults(recording: Recording, faults: Sequence[DrawnFault], *, seed: int) -> Recording:
    """Return the recording with the faults one after the other, and their truth.

    Parameters
    ----------
    recording : Recording
    faults : sequence of DrawnFault
    seed : int
        Random seed; each fault has its own generator, by its place and type.

    Returns
    -------
    Recording
        Its ``origin`` holds the faults and the seed. ``undisturbed_NAME`` are the channels before the first fault.
    """
    made = recording
    for number, fault in enumerate(faults):
        made = fault.apply(made, random_for(seed, f"fault {number} {fault.type}"))
    # an origin that has faults already is that of a file with faults of its own
    before = {"from": recording.origin} if "faults" in recording.origin else recording.origin
    described = [fault.described() for fault in faults]
    return replace(made, origin={**before, "faults": described, "faults_seed": seed}) if faults else recording
