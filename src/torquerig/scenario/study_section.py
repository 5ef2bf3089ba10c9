"""The study section of a scenario as a file states it: candidates, filters, rules, requirements and criteria."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    field_validator,
    model_validator,
)  # fmt: skip

from torquerig.filters.chains.renamed_chains import current_chain
from torquerig.parameter import Parameter
from torquerig.renamed import current_name
from torquerig.scenario.numbers.percent import Percent

Metric = Literal[
    "truth_error", "disturbance", "speed_reserve", "speed_use", "continuous_output_torque", "torque_reserve",
    "sensor_peak", "servo", "new_parts", "price", "residual_disturbance",
    # of metrics/sizing, over the duty cycle where the scenario states one
    "rms_torque", "peak_torque", "peak_power", "top_speed", "mean_speed", "rms_torque_use", "peak_torque_use",
    "continuous_use", "intermittent_use", "speed_limit_use", "inertia_ratio", "thermal_use", "thermal_margin",
    "gearbox_life_use", "gearbox_peak_use", "gearbox_jam_use", "gearbox_speed_use", "gearbox_no_load_use",
    "rms_current", "peak_current", "limit_current", "rms_current_use", "peak_current_use", "braking_energy",
    "regenerated_energy", "ideal_ratio", "speed_ratio", "best_ratio", "best_ratio_use", "sensor_cycle_use",
    "sensor_range_use", "sensor_overload", "sensor_overload_unlimited", "load_fidelity", "loop_fidelity", "flat_to",
]  # fmt: skip
ChainName = Annotated[str, AfterValidator(current_chain)]


def _current_metric(written: Any) -> Any:
    return (
        current_name(written, {"left_disturbance": "residual_disturbance"}, what="metric")
        if isinstance(written, str)
        else written
    )


WrittenMetric = Annotated[Metric, BeforeValidator(_current_metric)]


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Exchange(_Section):
    """The parts of the rig that the candidates replace, by name; the only ones of the rig where nothing is stated."""

    motor: str | None = None
    stage: str | None = None


class Present(_Section):
    """The present drive of the rig; the baseline of the Pugh matrix.

    ``gearbox`` is a name of the catalog, or the name of the stage in the rig for the stage as the rig states it.
    """

    motor: str
    gearbox: str | None = None
    filter: ChainName = "none"


class StatedStage(_Section):
    """A stage that the catalog does not have: the part as a rig would state it, and its price where it is known."""

    part: dict[str, Any]
    price: Annotated[float, Parameter("EUR", "price", low=0)] | None = None


class Filters(_Section):
    """Filter chains and their file, relative to the scenario."""

    file: str
    names: tuple[ChainName, ...] = Field(min_length=1)


class SpeedLoopRule(_Section):
    """Tuning rule of the speed loop, the same for every drive."""

    crossover: Annotated[float, Parameter("Hz", "crossover of the speed loop", above=0)]
    integral_corner: Annotated[float, Parameter("Hz", "corner of the integrator", low=0)]


class AllPoints(_Section):
    """The operating points of ``--all-points``."""

    occupancy: tuple[Percent, ...]
    particle_size: tuple[Annotated[float, Parameter("m", "particle size", above=0)], ...]


class RequirementRow(_Section):
    """A requirement of the elimination."""

    metric: WrittenMetric
    unit: str
    min: float | None = None
    max: float | None = None
    purpose: str

    @model_validator(mode="after")
    def _has_a_limit(self) -> RequirementRow:
        if self.min is None and self.max is None:
            raise ValueError("a requirement needs a limit; write min or max")
        return self


class Band(_Section):
    """Largest difference of two values that count as the same in the Pugh matrix."""

    absolute: float = 0.0
    relative: float = 0.0


class CriterionRow(_Section):
    """A criterion of the Pugh and Kesselring matrices."""

    metric: WrittenMetric
    unit: str
    better: Literal["more", "less", "band"]
    band: tuple[float, float] | None = None
    kind: Literal["technical", "economic"] = "technical"
    weight: Annotated[float, Field(ge=0)]
    same_within: Band = Band()
    points: dict[float, float] = Field(min_length=2)
    purpose: str


class Settings(_Section):
    """Everything under ``study:``.

    Without ``gearboxes`` the stages stay as the rig states them, without ``motors`` the motor stays the present one.
    ``sweep`` lists values of quantities of the scenario, by path, that the study is computed at too.
    """

    duration: Annotated[float, Parameter("s", "length of a run", above=0)] = 10.0
    seed: int = Field(default=1, ge=0)
    draws: int = Field(default=0, ge=0, le=1000)  # each is a run of every drive
    present: Present
    exchange: Exchange = Exchange()
    motors: Literal["all"] | tuple[str, ...] = ()
    gearboxes: tuple[str, ...] = ()
    stages: dict[str, StatedStage] = Field(default_factory=dict)
    filters: Filters
    speed_loop: SpeedLoopRule
    sensor_limit: Annotated[float, Parameter("N*m", "largest torque at the sensor", above=0)]
    all_points: AllPoints | None = None
    sweep: dict[str, tuple[int | float | str, ...]] = Field(default_factory=dict)
    requirements: dict[str, RequirementRow]
    criteria: dict[str, CriterionRow] = Field(min_length=1)

    @field_validator("sweep")
    @classmethod
    def _several_values(
        cls, sweep: dict[str, tuple[int | float | str, ...]]
    ) -> dict[str, tuple[int | float | str, ...]]:
        for path, values in sweep.items():
            if len(set(values)) < max(len(values), 2):
                raise ValueError(f"{path} needs two or more values, each once, such as [5 %, 11 %, 21 %]")
        return sweep

    @field_validator("motors", "gearboxes")
    @classmethod
    def _each_once(cls, names: str | tuple[str, ...]) -> str | tuple[str, ...]:
        if not names:
            raise ValueError("the list is empty; name at least one")
        twice = [] if isinstance(names, str) else [name for name in names if names.count(name) > 1]
        if twice:
            raise ValueError(f"{sorted(twice)[0]!r} is listed twice; keep one")
        return names
