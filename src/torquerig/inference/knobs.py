"""The numbers of a model that may be turned, each around its nominal value by its stated spread."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import exp
from typing import Any, get_args, get_type_hints

import numpy as np
from numpy.typing import NDArray

from torquerig.mechanisms import ParticleLoad, TorqueRipple
from torquerig.parameter import Estimate, Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.numbers.tolerance import deviation

LOAD_LEVEL_SPREAD = 0.05  # the mean load of a real rig is known to a few per cent (reference rig)
_NOISE_SPREAD = 0.5  # an amplifier that is louder than its data sheet is no missing physics
_NOISE_COLOUR = 0.11  # no amplifier's noise is quite white
HIT_RISE = 0.025  # of the decay: no pulse rises at once; so short a rise cannot be seen, a longer one is found
_HIT_RISE_SPREAD = 1.2
_LOAD_SPECTRUM = {"hit_rms": 0.3, "hit_decay": 0.2, "slow_rms": 0.4, "slow_cutoff": 0.3}
HARDLY_ANY = 0.002  # of the mean: a load stated to have no hits, or no slow variation, may have both at any pace
_UNKNOWN = {"hit_rms": 1.5, "hit_decay": 1.0, "slow_rms": 1.5, "slow_cutoff": 0.7}


@dataclass(frozen=True)
class Knob:
    """One number of one part: ``value exp(spread x)``, or ``value + spread x``, at the position x.

    Parameters
    ----------
    part, field : str
        Whose number it is.
    spread : float
        One sigma of x: relative where ``factor``, else in the unit of the field.
    key : object
        Where the field is a mapping or tuple, which of its entries.
    factor : bool
        Whether x is a factor's logarithm; else it is added.
    """

    part: str
    field: str
    spread: float
    key: Any = None
    factor: bool = True

    @property
    def name(self) -> str:
        """``part.field`` or ``part.field.key``."""
        return f"{self.part}.{self.field}" + ("" if self.key is None else f".{self.key:g}")

    def value(self, rig: Rig) -> float:
        """Return the number that stands in ``rig``."""
        held = getattr(rig.part(self.part), self.field)
        return float(held if self.key is None else held[self.key])

    def turned(self, value: float, position: float) -> float:
        """Return the number at a position of the knob."""
        return value * exp(self.spread * position) if self.factor else value + self.spread * position


def declared(part: Part, field: str) -> Parameter | None:
    """Return how a part declares a number, or the entries of a mapping or tuple; None where it does not."""
    return _declared(type(part), field)  # type: ignore[arg-type]  # mypy sees no hash of the class


@cache
def _declared(kind: type[Part], field: str) -> Parameter | None:
    found = [*declarations(get_type_hints(kind, include_extras=True).get(field))]
    return found[-1] if found else None  # of a mapping the values come last


def declarations(hint: Any) -> Iterator[Parameter]:
    """Yield the declarations inside of a type: of a number, and of the entries of a tuple or mapping."""
    yield from (one for one in getattr(hint, "__metadata__", ()) if isinstance(one, Parameter))
    for inner in get_args(hint):
        if not isinstance(inner, Parameter):
            yield from declarations(inner)


def within(part: Part, field: str, value: float) -> float:
    """Return a value, or the bound of the part's declaration that it is beyond."""
    known = declared(part, field)
    return value if known is None else min(max(value, known.low), known.high)


def turned(rig: Rig, knobs: Sequence[Knob], positions: NDArray[np.float64]) -> Rig:
    """Return the rig with every knob at its position, or at the bound of what its part allows."""
    changes: dict[str, dict[str, Any]] = {}
    for knob, position in zip(knobs, positions.tolist(), strict=True):
        fields = changes.setdefault(knob.part, {})
        value = within(rig.part(knob.part), knob.field, knob.turned(knob.value(rig), position))
        if knob.key is None:
            fields[knob.field] = value
            continue
        held = getattr(rig.part(knob.part), knob.field)
        entries = fields.setdefault(knob.field, dict(held) if isinstance(held, Mapping) else dict(enumerate(held)))
        entries[knob.key] = value
    for name, fields in changes.items():
        part = rig.part(name)
        tuples = {key: tuple(v.values()) for key, v in fields.items() if isinstance(getattr(part, key), tuple)}
        rig = rig.changed(replace(part, **{**fields, **tuples}))
    return rig


def nuisance_knobs(rig: Rig, uncertain: Mapping[str, Estimate], *, occupancies: Sequence[float]) -> tuple[Knob, ...]:
    """Return what must be fitted before anything is called missing.

    Everything that the scenario calls uncertain, every line's amplitude, the load's level at each occupancy that was
    run, and the shape of the load's spectrum. What the scenario states goes before what is assumed of every rig.
    """
    stated = [knob for name, estimate in uncertain.items() if (knob := stated_knob(rig, name, estimate)) is not None]
    found: dict[str, Knob] = {}
    for knob in (*stated, *_of_every_rig(rig, occupancies)):
        found.setdefault(knob.name, knob)
    return tuple(found.values())


def stated_knob(rig: Rig, name: str, estimate: Estimate) -> Knob | None:
    """Return the knob of an uncertain number by its name ``part.field`` or ``part.field.key``; None where none is."""
    part = next((one.name for one in rig.parts if name.startswith(f"{one.name}.") and _held(rig, one.name, name)), None)
    held = None if part is None else _held(rig, part, name)
    if part is None or held is None or not deviation(estimate):
        return None
    field, key = held
    if estimate.rel_sd:
        least = _NOISE_SPREAD if field == "noise_rms" else 0.0
        return Knob(part, field, max(estimate.rel_sd, least), key=key)
    return Knob(part, field, deviation(estimate), key=key, factor=False)


def unvaried(rig: Rig, uncertain: Mapping[str, Estimate]) -> tuple[str, ...]:
    """Return one sentence about the uncertain numbers of a scenario that no fit moves; none where there are none."""
    names = [name for name, estimate in uncertain.items() if stated_knob(rig, name, estimate) is None]
    if not names:
        return ()
    said = f"The diagnosis does not vary {', '.join(names)}: it fits numbers of parts and effects only, and "
    return (said + "takes the conditions of the runs from the recordings.",)


def _held(rig: Rig, part: str, name: str) -> tuple[str, Any] | None:
    """Return the field and the key, where ``name`` is a number of the part."""
    field, _, inner = name.removeprefix(f"{part}.").partition(".")
    held = getattr(rig.part(part), field, None)
    if not inner:
        return (field, None) if isinstance(held, float) else None
    entries = dict(held) if isinstance(held, Mapping) else dict(enumerate(held)) if isinstance(held, tuple) else {}
    return next(((field, key) for key, value in entries.items() if f"{key:g}" == inner and value is not None), None)


def _of_every_rig(rig: Rig, occupancies: Sequence[float]) -> list[Knob]:
    knobs = [
        Knob(sensor.name, "noise_colour", _NOISE_COLOUR, factor=False) for sensor in rig.parts_of(AmplifiedTorqueSensor)
    ]
    for ripple in rig.parts_of(TorqueRipple):
        if ripple.amplitude_rel_sd:
            knobs += [
                Knob(ripple.name, "amplitudes", ripple.amplitude_rel_sd, key=order) for order in ripple.amplitudes
            ]
    for load in rig.parts_of(ParticleLoad):
        if load.hit_rise > 0:
            knobs.append(Knob(load.name, "hit_rise", _HIT_RISE_SPREAD))
        hits, slow = (_UNKNOWN if rms <= HARDLY_ANY else _LOAD_SPECTRUM for rms in (load.hit_rms, load.slow_rms))
        spreads = {field: (hits if field.startswith("hit") else slow)[field] for field in _LOAD_SPECTRUM}
        knobs += [Knob(load.name, field, spread) for field, spread in spreads.items()]
        stated = load.mean_by_occupancy_percent
        knobs += [
            Knob(load.name, "mean_by_occupancy_percent", LOAD_LEVEL_SPREAD, key=percent)
            for percent in sorted(set(occupancies))
            if percent in stated
        ]
    return knobs


def with_free_load(rig: Rig) -> Rig:
    """Return the rig whose particle loads have numbers that can be turned, too small to matter where none are stated.

    Those are the time over which a hit rises, and how much hits and slow variation are: no load is quite even.
    """
    for load in rig.parts_of(ParticleLoad):
        free = replace(
            load, hit_rise=load.hit_rise or HIT_RISE * load.hit_decay, hit_rms=load.hit_rms or HARDLY_ANY,
            slow_rms=load.slow_rms or HARDLY_ANY,
        )  # fmt: skip
        rig = rig if free == load else rig.changed(free)
    return rig
