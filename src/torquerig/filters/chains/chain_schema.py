"""The YAML of a filter chain: a list of stages; those that remove lines are in line_stage_schema."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal, Union, get_args

from pydantic import BeforeValidator, Field, TypeAdapter

from torquerig.errors import did_you_mean
from torquerig.extensions import extensions_of
from torquerig.filters.butterworth import ButterworthLowPass, CausalButterworthLowPass
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.chains.line_stage_schema import (
    AdaptiveCancellerText,
    CombText,
    HarmonicRegressionText,
    IdealBandstopText,
    NotchBankText,
    OrderBandstopText,
    SynchronousAverageText,
    VoldKalmanText,
    WeightedLinesText,
)
from torquerig.filters.chains.renamed_chains import current_stage
from torquerig.filters.chains.stage_form import Made, StageForm
from torquerig.filters.fir_low_pass import CausalFirLowPass, FirLowPass
from torquerig.filters.hampel import Hampel
from torquerig.filters.load_inverse import LOWEST, LoadInverse
from torquerig.filters.load_response import LoadResponse
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.filters.revolution_mean import RevolutionMean
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.parameter import Parameter


class ButterworthLowPassText(StageForm):
    """The YAML of a zero-phase Butterworth low-pass."""

    type: Literal["butterworth_low_pass"]
    cutoff: Annotated[float, Parameter("Hz", "cutoff frequency", above=0)]
    order: Annotated[int, Field(ge=1, le=10)] = 4
    causal: bool = False

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the low-pass; it is the same for every drive."""
        made = CausalButterworthLowPass if self.causal else ButterworthLowPass
        return made(cutoff=self.cutoff, order=self.order), ()


class RevolutionMeanText(StageForm):
    """The YAML of a mean over turns of the output shaft."""

    type: Literal["revolution_mean"]
    turns: Annotated[float, Parameter("1", "turns of the output shaft", above=0)] = 1.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the mean for one drive."""
        return RevolutionMean(ratio=kinematics.ratio, turns=self.turns), ()


class LoadInverseText(StageForm):
    """The YAML of the load inverse; without a model of the rig it changes nothing and is listed as left out."""

    type: Literal["load_inverse"]
    retune: Annotated[float, Field(ge=0, le=0.5)] = 0.15
    lowest: Annotated[float, Parameter("Hz", "from which the spectra are fitted", above=0)] = LOWEST

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the inverse, or an empty chain where no model is known."""
        if response is None:
            return Chain(name="load_inverse", stages=()), ("load_inverse: no model of the rig is known here",)
        return LoadInverse(response=response, retune=self.retune, lowest=self.lowest), ()


class FirLowPassText(StageForm):
    """The YAML of an FIR low-pass; ``causal: true`` uses past samples only."""

    type: Literal["fir_low_pass"]
    cutoff: Annotated[float, Parameter("Hz", "gain 1/2", above=0)]
    transition: Annotated[float, Parameter("Hz", "width from pass to stop", above=0)]
    causal: bool = False

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the low-pass; it is the same for every drive."""
        made = CausalFirLowPass if self.causal else FirLowPass
        return made(cutoff=self.cutoff, transition=self.transition), ()


class HampelText(StageForm):
    """The YAML of a Hampel filter."""

    type: Literal["hampel"]
    half_window: Annotated[int, Field(ge=1, le=100)] = 10
    deviations: Annotated[float, Field(gt=0)] = 5.0

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the Hampel filter; it is the same for every drive."""
        return Hampel(half_window=self.half_window, deviations=self.deviations), ()


class MovingMeanKeptText(StageForm):
    """The YAML of a moving mean; its stages are applied to the deviation from it."""

    type: Literal["moving_mean_kept"]
    samples: Annotated[int, Field(ge=1)]
    around: list[StageText]

    def made_for(self, kinematics: Kinematics, response: LoadResponse | None = None) -> Made:
        """Return the moving mean around its stages for one drive."""
        made = [stage.made_for(kinematics, response) for stage in self.around]
        stage = MovingMeanKept(samples=self.samples, around=tuple(stage for stage, _ in made))
        return stage, tuple(word for _, left_out in made for word in left_out)


_Texts = (
    IdealBandstopText
    | HarmonicRegressionText
    | WeightedLinesText
    | OrderBandstopText
    | NotchBankText
    | ButterworthLowPassText
    | RevolutionMeanText
    | LoadInverseText
    | VoldKalmanText
    | AdaptiveCancellerText
    | CombText
    | SynchronousAverageText
    | FirLowPassText
    | HampelText
    | MovingMeanKeptText
)
_FORMS: tuple[type[StageForm], ...] = (
    *get_args(_Texts), *extensions_of("torquerig.filters", StageForm).values()
)  # fmt: skip
_TYPES = tuple(str(get_args(form.model_fields["type"].annotation)[0]) for form in _FORMS)


def _known_type(written: Any) -> Any:
    if not isinstance(written, dict):
        raise ValueError(f"{written!r} is no stage; write for example {{type: butterworth_low_pass, cutoff: 20 Hz}}")
    name = current_stage(str(written.get("type", "")))
    if name not in _TYPES:
        raise ValueError(f"the stage has no known type ({name!r}); {did_you_mean(name, _TYPES)}")
    return {**written, "type": name}


if TYPE_CHECKING:
    StageText = Annotated[_Texts, Field(discriminator="type"), BeforeValidator(_known_type)]
else:  # the forms of other packages too
    StageText = Annotated[Union[_FORMS], Field(discriminator="type"), BeforeValidator(_known_type)]  # noqa: UP007
MovingMeanKeptText.model_rebuild()
CHAINS: TypeAdapter[dict[str, list[StageText]]] = TypeAdapter(dict[str, list[StageText]])
