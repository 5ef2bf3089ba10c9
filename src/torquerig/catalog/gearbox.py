"""Schema of a gearbox file: one reduction between motor and torque sensor."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from torquerig.catalog.entry import UNKNOWN, Entry, Evidenced, Record
from torquerig.errors import InputError
from torquerig.orders.kinematics.teeth import Planetary, Spur, Teeth
from torquerig.orders.kinematics.worm import Worm
from torquerig.parameter import Estimate, Parameter

Count = Annotated[int, Field(ge=1, strict=True)]


class ToothSet(Record):
    """Tooth counts of one stage: sun and ring (output at the carrier), or pinion and wheel (gears or toothed belt).

    Raises
    ------
    ValueError
        When the set is neither of the two, or its planets cannot be assembled.
    """

    sun: Count | None = None
    planet: Count | None = None
    ring: Count | None = None
    planets: Count | None = None
    pinion: Count | None = None
    wheel: Count | None = None

    @model_validator(mode="after")
    def _exists(self) -> Self:
        try:
            self.stage()
        except InputError as error:
            raise ValueError(str(error)) from None
        return self

    def stage(self) -> Teeth:
        """Return the stage for the order calculation; InputError where there is no such stage."""
        if self.sun and self.ring and not (self.pinion or self.wheel):
            return Planetary(self.sun, self.ring, self.planets)
        if self.pinion and self.wheel and not (self.sun or self.ring or self.planet or self.planets):
            return Spur(self.pinion, self.wheel)
        raise InputError("a tooth set is either sun and ring (with planet and planets) or pinion and wheel")


class ToothSets(Evidenced):
    """Possible tooth counts of a single-stage gearbox: one set where they are known, else several."""

    one_of: tuple[ToothSet, ...] = Field(min_length=1)


class Gearbox(Entry):
    """One gearbox.

    Raises
    ------
    ValueError
        When a tooth set cannot be assembled or gives another ratio than the stated one, and where a worm lacks its
        starts, wheel teeth, lead angle or the inertia of its wheel, or another kind has them.
    """

    kind: Literal["planetary", "spur", "belt", "worm"]
    ratio: Annotated[float, Parameter("1", "motor turns per output turn", above=1)]
    stages: Count = 1
    teeth: ToothSets | None = None
    starts: Count | None = None
    wheel_teeth: Count | None = None
    lead_angle: Annotated[Estimate, Parameter("deg", "lead angle of a worm", above=0, high=60)] = UNKNOWN

    nominal_torque: Annotated[Estimate, Parameter("N*m", "continuous output torque (T2N)", above=0)] = UNKNOWN
    peak_torque: Annotated[Estimate, Parameter("N*m", "largest output torque (T2a)", above=0)] = UNKNOWN
    max_input_speed: Annotated[Estimate, Parameter("rpm", "largest input speed", above=0)] = UNKNOWN

    input_inertia: Annotated[Estimate, Parameter("kg*m^2", "inertia at the input (J1)", above=0)]
    output_inertia: Annotated[Estimate, Parameter("kg*m^2", "inertia of a worm's wheel", above=0)] = UNKNOWN
    stiffness: Annotated[Estimate, Parameter("N*m/rad", "torsional stiffness at the output", above=0)]
    damping: Annotated[Estimate, Parameter("N*m*s/rad", "torsional damping at the output", low=0)]
    efficiency: Annotated[Estimate, Parameter("1", "efficiency", above=0, high=1)]
    no_load_torque: Annotated[Estimate, Parameter("N*m", "torque at the input without load", low=0)] = UNKNOWN
    backlash: Annotated[Estimate, Parameter("arcmin", "full gap at the output", low=0)]
    transmission_error: Annotated[Estimate, Parameter("arcmin", "peak-to-peak error of the output angle", low=0)] = (
        UNKNOWN
    )

    price: Annotated[Estimate, Parameter("EUR", "price", low=0)] = UNKNOWN

    @model_validator(mode="after")
    def _teeth_give_the_ratio(self) -> Self:
        for stage in self.tooth_sets():
            if abs(stage.ratio / self.ratio - 1) > 0.02:
                raise ValueError(
                    f"the {stage.spoken} gives a ratio of {stage.ratio:.4g}, but ratio is {self.ratio:g}; "
                    "correct one of them"
                )
        return self

    @model_validator(mode="after")
    def _worm_has_its_numbers(self) -> Self:
        known = {name: getattr(self, name) for name in ("lead_angle", "output_inertia")}
        numbers = {"starts": self.starts, "wheel_teeth": self.wheel_teeth}
        numbers |= {name: None if one.unknown else one for name, one in known.items()}
        if self.kind != "worm":
            stated = [name for name, one in numbers.items() if one is not None]
            if stated:
                raise ValueError(f"{' and '.join(stated)} belong to a gearbox of kind worm, and this is {self.kind}")
            return self
        missing = [name for name, one in numbers.items() if one is None]
        if missing:
            raise ValueError(f"a worm needs {' and '.join(missing)}: from them follow its orders and whether it locks")
        if self.teeth is not None:
            raise ValueError("a worm has starts and wheel_teeth, and no teeth:; remove teeth")
        worm = self.worm()
        if worm is not None and abs(worm.ratio / self.ratio - 1) > 0.02:
            raise ValueError(f"the {worm.spoken} gives a ratio of {worm.ratio:.4g}, but ratio is {self.ratio:g}; "
                             "correct one of them")  # fmt: skip
        return self

    def worm(self) -> Worm | None:
        """Return starts and wheel of a worm gear; None for another kind, ValueError where there is no such pair."""
        if self.starts is None or self.wheel_teeth is None:
            return None
        try:
            return Worm(self.starts, self.wheel_teeth)
        except InputError as error:
            raise ValueError(str(error)) from None

    def tooth_sets(self) -> tuple[Teeth, ...]:
        """Return the possible stages of the gearbox; empty where the tooth counts are unknown."""
        return () if self.teeth is None else tuple(teeth.stage() for teeth in self.teeth.one_of)
