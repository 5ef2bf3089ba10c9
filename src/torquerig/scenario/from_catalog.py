"""What a catalog entry gives a part: its fields, the lines it brings along, and which values had to be assumed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, TypeVar

from torquerig.catalog.drawing import Drawn, drawn, drawn_teeth
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.lines import RippleLine, ripple_lines
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog
from torquerig.errors import InputError, UnknownNameError
from torquerig.units import in_unit, written_quantity

AnyEntry = TypeVar("AnyEntry", bound=Entry)


@dataclass(frozen=True, kw_only=True)
class Filled:
    """The data of one part before it is validated, and of the effects that come with it."""

    name: str
    values: Mapping[str, Any]
    uncertainties: Mapping[str, float] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)
    effects: tuple[Filled, ...] = ()


# kind of part -> field of the part, field of the catalog entry, SI unit
FIELDS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "motor": (
        ("inertia", "rotor_inertia", "kg*m^2"),
        ("viscous", "viscous_friction", "N*m*s/rad"),
        ("coulomb", "coulomb_friction", "N*m"),
        ("torque_limit", "peak_torque", "N*m"),
        ("current_loop_bandwidth", "current_loop_bandwidth", "Hz"),
    ),
    "gear": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("efficiency", "efficiency", "1"),
        ("input_inertia", "input_inertia", "kg*m^2"),
        ("backlash", "backlash", "rad"),
    ),
    "torque_sensor": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("inertia", "inertia", "kg*m^2"),
        ("sensitivity", "sensitivity", "V/(N*m)"),
        ("bandwidth", "bandwidth", "Hz"),
        ("noise_rms", "noise", "V"),
        ("converter_range", "adc.range", "V"),
    ),
    "coupling": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("inertia", "inertia", "kg*m^2"),
    ),
}

GROUPS = {
    "motor": "mechanical",
    "cogging": "cogging",
    "cogging_as_published": "cogging",
    "cogging_tolerance_slots": "cogging",
    "cogging_tolerance_poles": "cogging",
    "electrical": "electrical",
    "six_pulse": "electrical",
}
"""Which share of the sensor's reading a family of lines is counted to."""


def filled_from_catalog(catalog: Catalog, entry: str, *, kind: str, name: str, seed: int, place: str) -> Filled:
    """Return the data of the part ``name`` from the catalog entry ``entry``.

    Raises
    ------
    InputError
        When the kind of part has no catalog, or the entry is unknown; starts with ``place``.
    """
    shelves: dict[str, Callable[[str], Entry]] = {
        "motor": catalog.motor,
        "gear": catalog.gearbox,
        "torque_sensor": catalog.sensor,
        "coupling": catalog.coupling,
    }
    if kind not in shelves:
        raise InputError(f"{place}.catalog: a {kind} has no catalog; state its values and leave catalog: out")
    try:
        found = shelves[kind](entry)
    except UnknownNameError as error:
        raise InputError(f"{place}.catalog: {error}") from None
    copy = copy_of(found, seed)
    values: dict[str, Any] = {"kind": kind}
    uncertainties, assumed = {}, {}
    known = dict(estimates(found))
    for target, source, unit in FIELDS[kind]:
        if source not in copy.values:
            continue
        values[target] = written_quantity(copy.values[source], unit)
        if known[source].rel_sd:
            uncertainties[target] = known[source].rel_sd
        if source in copy.assumed:
            value = in_unit(copy.values[source], known[source].unit)
            unit_shown = "" if known[source].unit == "1" else f" {known[source].unit}"
            assumed[target] = f"{value:.4g}{unit_shown} of {copy.assumed[source].known}"
    effects: tuple[Filled, ...] = ()
    if isinstance(found, Motor):
        counts = {key: copy.count(key) for key in ("pole_pairs", "slots") if key in copy.values}
        values |= {"model": found.name, **counts}
        assumed |= {key: f"{counts[key]} of {copy.assumed[key].known}" for key in counts if key in copy.assumed}
        effects = tuple(_motor_effects(replace_entry(copy, found), name))
        assumed |= {key: f"{copy.values[key]:.3g} of {text.known}" for key, text in copy.assumed.items()
                    if key.startswith("ripple.") and not found.ripple.known_lines}  # fmt: skip
    if isinstance(found, Gearbox):
        values["ratio"] = found.ratio
        teeth = drawn_teeth(found, seed)
        values["teeth"] = [] if teeth is None else [asdict(teeth)]
        if teeth is not None and len(found.tooth_sets()) > 1:
            assumed["teeth"] = f"{teeth.spoken} of {len(found.tooth_sets())} possible sets"
    return Filled(name=name, values=values, uncertainties=uncertainties, assumed=assumed, effects=effects)


def copy_of(entry: AnyEntry, seed: int) -> Drawn[AnyEntry]:
    """Return one possible copy: stated values as they are (a spread around them is for calibration), others drawn."""
    copy = drawn(entry, seed)
    stated = {
        name: estimate.value
        for name, estimate in estimates(entry)
        if estimate.value is not None and estimate.low is None and not estimate.choices
    }
    return Drawn(
        entry,
        {**copy.values, **stated},
        {name: assumed for name, assumed in copy.assumed.items() if name not in stated},
    )


def replace_entry(copy: Drawn[Any], motor: Motor) -> Drawn[Motor]:
    """Return the copy typed as a motor's."""
    return Drawn(motor, copy.values, copy.assumed)


def _motor_effects(motor: Drawn[Motor], name: str) -> list[Filled]:
    lines = ripple_lines(motor)
    effects = []
    for group in dict.fromkeys(GROUPS.values()):
        steady = [line for line in lines if GROUPS[line.family] == group and line.torque > 0]
        if steady:
            effects.append(_ripple(name, group, steady, motor))
        effects += [
            Filled(
                name=f"{name}.ripple_{line.order}",
                values={"kind": "commutation_ripple", "at": name, "order_motor": line.order, "depth": line.share},
            )
            for line in lines
            if GROUPS[line.family] == group and line.share > 0
        ]
    return effects


def _ripple(name: str, group: str, lines: list[RippleLine], motor: Drawn[Motor]) -> Filled:
    amplitudes: dict[int, float] = {}
    for line in lines:
        amplitudes[line.order] = amplitudes.get(line.order, 0.0) + line.torque
    spreads = [estimate.rel_sd for key, estimate in estimates(motor.entry.ripple) if key.startswith("known_lines")]
    return Filled(
        name=f"{name}.{group}",
        values={
            "kind": "torque_ripple",
            "at": name,
            "group": group,
            "amplitudes": {order: written_quantity(torque, "N*m") for order, torque in amplitudes.items()},
            "amplitude_rel_sd": max(spreads, default=0.0),
        },
    )
