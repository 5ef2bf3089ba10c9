"""A filter chain with its lines shifted by some orders of the output shaft, otherwise unchanged."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from torquerig.filters.adaptive_canceller import AdaptiveCanceller
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.harmonic_regression import HarmonicRegression
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.filters.notch_bank import CausalNotchBank, NotchBank
from torquerig.filters.order_bandstop import OrderBandstop
from torquerig.filters.vold_kalman import VoldKalman
from torquerig.filters.weighted_lines import WeightedLines

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.stage import Stage

_LineByLine = (
    AdaptiveCanceller | HarmonicRegression | IdealBandstop | CausalNotchBank | NotchBank | OrderBandstop | VoldKalman
    | WeightedLines
)  # fmt: skip


def shifted_line(line: KinematicLine, orders: float) -> KinematicLine:
    """Return ``line`` shifted by ``orders`` of the output shaft [1/rev]."""
    ratio = line.output_order / line.motor_order
    return replace(line, motor_order=line.motor_order + orders / ratio, output_order=line.output_order + orders)


def shifted_chain(chain: Chain, orders: float) -> Chain:
    """Return ``chain`` with the lines of all stages that remove separate lines shifted by ``orders`` [1/rev].

    Stages without lines, such as low-passes, are not changed. Nor are combs and synchronous averages, which have a
    tooth at every harmonic; for them the torque is shifted instead (``order_shift``).
    """
    return replace(chain, stages=tuple(_moved(stage, orders) for stage in chain.stages))


def shiftable_lines(chain: Chain) -> tuple[KinematicLine, ...]:
    """Return the distinct lines that :func:`shifted_chain` shifts."""
    return tuple(dict.fromkeys(line for stage in chain.stages for line in _movable(stage)))


def widest_half_width(chain: Chain) -> tuple[float, float]:
    """Return the widest half band of the stages with lines, in Hz and in output orders; 0 where none states one."""
    widths = [width for stage in chain.stages for width in _half_widths(stage)]
    return max((hertz for hertz, _ in widths), default=0.0), max((orders for _, orders in widths), default=0.0)


def _moved(stage: Stage, orders: float) -> Stage:
    if isinstance(stage, _LineByLine):
        return replace(stage, lines=tuple(shifted_line(line, orders) for line in stage.lines))
    if isinstance(stage, MovingMeanKept):
        return replace(stage, around=tuple(_moved(one, orders) for one in stage.around))
    return stage


def _movable(stage: Stage) -> tuple[KinematicLine, ...]:
    if isinstance(stage, _LineByLine):
        return stage.lines
    return tuple(line for one in getattr(stage, "around", ()) for line in _movable(one))


def _half_widths(stage: Stage) -> list[tuple[float, float]]:
    if isinstance(stage, OrderBandstop | VoldKalman):
        return [(0.0, stage.half_width)]
    if isinstance(stage, IdealBandstop | NotchBank | CausalNotchBank | AdaptiveCanceller):
        return [(stage.half_width, 0.0)]
    return [width for one in getattr(stage, "around", ()) for width in _half_widths(one)]
