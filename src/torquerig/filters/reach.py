"""The reach of a stage: the overlap of blocks that it needs."""

from __future__ import annotations

from functools import singledispatch
from math import pi
from typing import TYPE_CHECKING, Any

from torquerig.errors import RecordingError
from torquerig.filters.butterworth import ButterworthLowPass
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.harmonic_regression import HarmonicRegression
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.filters.revolution_mean import RevolutionMean
from torquerig.recordings.set_point import set_point_speed
from torquerig.recordings.stage import LocalStage

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

# an ideal band-stop's response decays as 1 / (2 pi^2 half_width reach): 0.5 % of a line at ten times 1 / half_width
_BANDSTOP_REACH = 10.0
# the slowest pole of a fourth-order low-pass decays by 1 / e in 0.42 / cutoff: 1e-10 after ten periods of the cutoff
_LOW_PASS_REACH = 10.0
# a block, and half of one on either side, whose amplitudes are interpolated with it
_REGRESSION_REACH = 1.5


def reach_of(stage: Any, head: Recording) -> float:
    """Return the reach of a stage [s]: that of its method ``reach``, else one listed here.

    Parameters
    ----------
    stage : Stage
        A filter or a chain; the reaches of consecutive stages are added.
    head : Recording
        The first block of the recording.

    Raises
    ------
    RecordingError
        For a stage without a reach, which needs the whole recording at once.
    """
    return stage.reach(head) if isinstance(stage, LocalStage) else _known(stage, head)


@singledispatch
def _known(stage: Any, head: Recording) -> float:
    raise RecordingError(
        f"{head.name}: {type(stage).__name__} needs the whole recording at once and cannot work in blocks; "
        "cut the recording, or remove that stage"
    )


@_known.register(Chain)
def _(stage: Chain, head: Recording) -> float:
    return sum(reach_of(one, head) for one in stage.stages)


@_known.register(IdealBandstop)
def _(stage: IdealBandstop, head: Recording) -> float:
    return _BANDSTOP_REACH / stage.half_width


@_known.register(ButterworthLowPass)
def _(stage: ButterworthLowPass, head: Recording) -> float:
    return _LOW_PASS_REACH / stage.cutoff


@_known.register(MovingMeanKept)
def _(stage: MovingMeanKept, head: Recording) -> float:
    return stage.samples / head.sample_rate + sum(reach_of(one, head) for one in stage.around)


@_known.register(RevolutionMean)
def _(stage: RevolutionMean, head: Recording) -> float:
    speed = abs(set_point_speed(head, "means over turns"))
    return stage.turns * stage.ratio * 2 * pi / speed


@_known.register(HarmonicRegression)
def _(stage: HarmonicRegression, head: Recording) -> float:
    return _REGRESSION_REACH * stage.block
