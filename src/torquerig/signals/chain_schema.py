"""How a filter chain is written in YAML: a list of stages, each with its type and values, lines named by cause."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, TypeAdapter

from torquerig.errors import did_you_mean
from torquerig.parameter import Parameter
from torquerig.signals.chain import Chain, select_lines
from torquerig.signals.filters.butterworth import ButterworthLowPass
from torquerig.signals.filters.harmonic_regression import HarmonicRegression
from torquerig.signals.filters.ideal_bandstop import IdealBandstop
from torquerig.signals.filters.load_inverse import LoadInverse
from torquerig.signals.filters.moving_mean import MovingMeanKept
from torquerig.signals.filters.notch_bank import CausalNotchBank, NotchBank
from torquerig.signals.filters.order_bandstop import OrderBandstop
from torquerig.signals.filters.revolution_mean import RevolutionMean
from torquerig.signals.filters.weighed_lines import WeighedLines
from torquerig.signals.kinematics import FAMILIES, Family, Kinematics
from torquerig.signals.load_response import LoadResponse
from torquerig.signals.stage import Stage

_HIGHEST_HARMONIC = 100
_RANGE = re.compile(r"^\s*(\d+)\s*(?:\.\.\s*(\d+)\s*)?$")

Made = tuple[Stage, tuple[str, ...]]


def _harmonics(written: Any) -> tuple[int, ...]:
    texts = written if isinstance(written, list) else [written]
    numbers: set[int] = set()
    for text in texts:
        match = None if isinstance(text, bool) else _RANGE.match(str(text))
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
        if not 1 <= first <= last <= _HIGHEST_HARMONIC:
            raise ValueError(
                f"{text!r} names no harmonics; write for example 1..4, or 2, or [1, 3]; 1 is the fundamental"
            )
        numbers.update(range(first, last + 1))
    if not numbers:
        raise ValueError("no harmonics are named; write for example 1..4")
    return tuple(sorted(numbers))


def _family_names(written: Any) -> Any:
    if not isinstance(written, dict) or not written:
        raise ValueError(
            f"lines are named by cause; write for example {{motor: 1..4}}; known are {', '.join(FAMILIES)}"
        )
    for name in written:
        if name not in FAMILIES:
            raise ValueError(f"no lines have the cause {name!r}; {did_you_mean(str(name), FAMILIES)}")
    return written


Harmonics = Annotated[tuple[int, ...], BeforeValidator(_harmonics)]
Lines = Annotated[dict[Family, Harmonics], BeforeValidator(_family_names)]


class _StageText(BaseModel, ABC):
    model_config = ConfigDict(extra="forbid", frozen=True)

    @abstractmethod
    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the stage for one drive, and what of its lines that drive does not have.

        ``response`` is what a model of the rig says the sensor makes of the load, where there is one.
        """


class IdealBandstopText(_StageText):
    """The YAML of an ideal band-stop."""

    type: Literal["ideal_bandstop"]
    lines: Lines
    half_width: Annotated[float, Parameter("Hz", "half of each band", above=0)] = 0.5

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the band-stop for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return IdealBandstop(lines=lines, half_width=self.half_width), left_out


class HarmonicRegressionText(_StageText):
    """The YAML of a harmonic regression."""

    type: Literal["harmonic_regression"]
    lines: Lines
    block: Annotated[float, Parameter("s", "length of a block", above=0)] = 4.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the regression for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return HarmonicRegression(lines=lines, block=self.block), left_out


class WeighedLinesText(_StageText):
    """The YAML of fitted lines that are subtracted by as much as they stand out."""

    type: Literal["weighed_lines"]
    lines: Lines
    block: Annotated[float, Parameter("s", "length of a block", above=0)] = 30.0
    changing_block: Annotated[float, Parameter("s", "length of a block in runs that are not steady", above=0)] = 4.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the stage for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return WeighedLines(lines=lines, block=self.block, changing_block=self.changing_block), left_out


class OrderBandstopText(_StageText):
    """The YAML of a band-stop over the angle."""

    type: Literal["order_bandstop"]
    lines: Lines
    half_width: Annotated[float, Parameter("1/rev", "half of each band, in orders of the output shaft", above=0)] = 0.05

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the band-stop for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        return OrderBandstop(lines=lines, half_width=self.half_width), left_out


class NotchBankText(_StageText):
    """The YAML of a bank of notches; ``causal: true`` runs it forwards only, at the set-point."""

    type: Literal["notch_bank"]
    lines: Lines
    half_width: Annotated[float, Parameter("Hz", "half of each notch at -3 dB", above=0)] = 0.5
    causal: bool = False

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the notches for one drive."""
        lines, left_out = select_lines(kinematics, self.lines)
        made = CausalNotchBank if self.causal else NotchBank
        return made(lines=lines, half_width=self.half_width), left_out


class ButterworthLowPassText(_StageText):
    """The YAML of a zero-phase Butterworth low-pass."""

    type: Literal["butterworth_low_pass"]
    cutoff: Annotated[float, Parameter("Hz", "cutoff frequency", above=0)]
    order: Annotated[int, Field(ge=1, le=10)] = 4

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the low-pass; it is the same for every drive."""
        return ButterworthLowPass(cutoff=self.cutoff, order=self.order), ()


class RevolutionMeanText(_StageText):
    """The YAML of a mean over turns of the output shaft."""

    type: Literal["revolution_mean"]
    turns: Annotated[float, Parameter("1", "turns of the output shaft", above=0)] = 1.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the mean for one drive."""
        return RevolutionMean(ratio=kinematics.ratio, turns=self.turns), ()


class LoadInverseText(_StageText):
    """The YAML of the rig's response taken back; without a model of the rig it changes nothing and says so."""

    type: Literal["load_inverse"]
    retune: Annotated[float, Field(ge=0, le=0.5)] = 0.15

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the inverse, or an empty chain where no model is known."""
        if response is None:
            return Chain(name="load_inverse", stages=()), ("load_inverse: no model of the rig is known here",)
        return LoadInverse(response=response, retune=self.retune), ()


class MovingMeanKeptText(_StageText):
    """The YAML of a rolling mean that is kept aside while other stages work."""

    type: Literal["moving_mean_kept"]
    samples: Annotated[int, Field(ge=1)]
    around: list[StageText]

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the rolling mean around its stages for one drive."""
        made = [stage.made_for(kinematics, response) for stage in self.around]
        stage = MovingMeanKept(samples=self.samples, around=tuple(stage for stage, _ in made))
        return stage, tuple(word for _, left_out in made for word in left_out)


_Texts = (
    IdealBandstopText
    | HarmonicRegressionText
    | WeighedLinesText
    | OrderBandstopText
    | NotchBankText
    | ButterworthLowPassText
    | RevolutionMeanText
    | LoadInverseText
    | MovingMeanKeptText
)
_TYPES = tuple(str(get_args(text.model_fields["type"].annotation)[0]) for text in get_args(_Texts))


def _known_type(written: Any) -> Any:
    if not isinstance(written, dict):
        raise ValueError(f"{written!r} is no stage; write for example {{type: butterworth_low_pass, cutoff: 20 Hz}}")
    if written.get("type") not in _TYPES:
        name = str(written.get("type", ""))
        raise ValueError(f"the stage has no known type ({name!r}); {did_you_mean(name, _TYPES)}")
    return written


StageText = Annotated[_Texts, Field(discriminator="type"), BeforeValidator(_known_type)]
MovingMeanKeptText.model_rebuild()
CHAINS: TypeAdapter[dict[str, list[StageText]]] = TypeAdapter(dict[str, list[StageText]])
