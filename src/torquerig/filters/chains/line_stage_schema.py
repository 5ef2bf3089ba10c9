"""The YAML of the stages that remove lines, each line named by its cause."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from torquerig.filters.adaptive_canceller import AdaptiveCanceller
from torquerig.filters.chains.filter_chain import select_lines
from torquerig.filters.chains.stage_form import Lines, Made, StageForm
from torquerig.filters.comb import CausalComb, Comb
from torquerig.filters.harmonic_regression import HarmonicRegression
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.load_response import LoadResponse
from torquerig.filters.notch_bank import CausalNotchBank, NotchBank
from torquerig.filters.order_bandstop import OrderBandstop
from torquerig.filters.synchronous_average import SynchronousAverage
from torquerig.filters.vold_kalman import VoldKalman
from torquerig.filters.weighted_lines import WeightedLines
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.parameter import Parameter


class IdealBandstopText(StageForm):
    """The YAML of an ideal band-stop."""

    type: Literal["ideal_bandstop"]
    lines: Lines
    half_width: Annotated[float, Parameter("Hz", "half of each band", above=0)] = 0.5

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the band-stop for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return IdealBandstop(lines=lines, half_width=self.half_width), left_out


class HarmonicRegressionText(StageForm):
    """The YAML of a harmonic regression."""

    type: Literal["harmonic_regression"]
    lines: Lines
    block: Annotated[float, Parameter("s", "length of a block", above=0)] = 4.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the regression for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return HarmonicRegression(lines=lines, block=self.block), left_out


class WeightedLinesText(StageForm):
    """The YAML of fitted lines that are subtracted with weights by their level above the load."""

    type: Literal["weighted_lines"]
    lines: Lines
    block: Annotated[float, Parameter("s", "length of a block", above=0)] = 30.0
    changing_block: Annotated[float, Parameter("s", "length of a block in runs that are not steady", above=0)] = 4.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the stage for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return WeightedLines(lines=lines, block=self.block, changing_block=self.changing_block), left_out


class OrderBandstopText(StageForm):
    """The YAML of a band-stop over the angle."""

    type: Literal["order_bandstop"]
    lines: Lines
    half_width: Annotated[float, Parameter("1/rev", "half of each band, in orders of the output shaft", above=0)] = 0.05

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the band-stop for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return OrderBandstop(lines=lines, half_width=self.half_width), left_out


class NotchBankText(StageForm):
    """The YAML of a bank of notches; ``causal: true`` applies it forwards only, at the set-point."""

    type: Literal["notch_bank"]
    lines: Lines
    half_width: Annotated[float, Parameter("Hz", "half of each notch at -3 dB", above=0)] = 0.5
    causal: bool = False

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the notches for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        made = CausalNotchBank if self.causal else NotchBank
        return made(lines=lines, half_width=self.half_width), left_out


class VoldKalmanText(StageForm):
    """The YAML of a Vold-Kalman filter."""

    type: Literal["vold_kalman"]
    lines: Lines
    half_width: Annotated[float, Parameter("1/rev", "half of each band, in orders of the output shaft", above=0)] = 0.05

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the filter for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return VoldKalman(lines=lines, half_width=self.half_width), left_out


class AdaptiveCancellerText(StageForm):
    """The YAML of an adaptive canceller; it is causal."""

    type: Literal["adaptive_canceller"]
    lines: Lines
    half_width: Annotated[float, Parameter("Hz", "half of each notch at -3 dB", above=0)] = 0.25

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the canceller for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return AdaptiveCanceller(lines=lines, half_width=self.half_width), left_out


class CombText(StageForm):
    """The YAML of a comb; each line is a fundamental, and ``causal: true`` uses past samples only."""

    type: Literal["comb"]
    lines: Lines
    periods: Annotated[int, Field(ge=1)] = 10
    causal: bool = False

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the comb for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        made = CausalComb if self.causal else Comb
        return made(lines=lines, periods=self.periods), left_out


class SynchronousAverageText(StageForm):
    """The YAML of a synchronous average; the angle is estimated from ``lines`` where no channel gives it."""

    type: Literal["synchronous_average"]
    lines: Annotated[Lines, Field(default_factory=dict)]

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the average for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return SynchronousAverage(ratio=kinematics.ratio, lines=lines), left_out
