"""What a catalog entry gives a part: its fields, the lines it brings along, and which values had to be assumed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, replace
from math import pi
from typing import Any, TypeVar

from torquerig.catalog.coupling import Coupling
from torquerig.catalog.drawing import Drawn, drawn, drawn_teeth
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog
from torquerig.catalog.sensor import Sensor
from torquerig.errors import InputError, UnknownNameError
from torquerig.scenario.filled import Filled, FromCatalog
from torquerig.scenario.motor_effects import motor_effects
from torquerig.units import in_unit, written_quantity

AnyEntry = TypeVar("AnyEntry", bound=Entry)

# kind of part -> field of the part, field of the catalog entry, SI unit
FIELDS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "motor": (
        ("inertia", "rotor_inertia", "kg*m^2"),
        ("viscous", "viscous_friction", "N*m*s/rad"),
        ("coulomb", "coulomb_friction", "N*m"),
        ("torque_limit", "peak_torque", "N*m"),
        ("current_loop_bandwidth", "current_loop_bandwidth", "Hz"),
    ),
    "induction_drive": (
        ("rated_torque", "rated_torque", "N*m"),
        ("rated_speed", "rated_speed", "rad/s"),
        ("breakdown_torque", "peak_torque", "N*m"),
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

RANGES = ("torque_limit", "rated_torque", "rated_speed", "breakdown_torque", "converter_range", "backlash")
"""Ends of ranges, and a gap that is none where the flanks touch: nothing that a reading within them could tell."""

BOUGHT_AS = {"planetary_gear": "gear", "fixed_axis_gear": "gear"}  # kinds that share a shelf and its fields

COUPLING_MODE = 130.0  # [Hz] where a damping or loss ratio is turned into a damping: the wear rig's first mode


def filled_from_catalog(catalog: Catalog, entry: str, *, kind: str, name: str, seed: int, place: str) -> Filled:
    """Return the data of the part ``name`` from the catalog entry ``entry``.

    Raises
    ------
    InputError
        When the kind of part has no catalog, or the entry is unknown; starts with ``place``.
    """
    shelves: dict[str, Callable[[str], Entry]] = {
        "motor": catalog.motor,
        "induction_drive": catalog.motor,
        "gear": catalog.gearbox,
        "torque_sensor": catalog.sensor,
        "coupling": catalog.coupling,
    }
    if kind in BOUGHT_AS:
        filled = filled_from_catalog(catalog, entry, kind=BOUGHT_AS[kind], name=name, seed=seed, place=place)
        return replace(filled, values={**filled.values, "kind": kind})
    if kind not in shelves:
        raise InputError(f"{place}.catalog: a {kind} has no catalog; state its values and leave catalog: out")
    try:
        found = shelves[kind](entry)
    except UnknownNameError as error:
        raise InputError(f"{place}.catalog: {error}") from None
    copy = copy_of(found, seed)
    filled = _quantities(copy, kind, name)
    if isinstance(found, Motor):
        motor = Drawn(found, copy.values, copy.assumed)
        return _on_its_supply(filled, motor, place) if kind == "induction_drive" else _with_winding(filled, motor)
    if isinstance(found, Gearbox):
        return _with_teeth(filled, found, seed)
    if isinstance(found, Coupling):
        return _with_damping(filled, copy)
    if isinstance(found, Sensor) and "adc.bits" in copy.values:
        taken = {**filled.taken, "converter_bits": _taken(copy, "adc.bits")}
        return replace(filled, values={**filled.values, "converter_bits": copy.count("adc.bits")}, taken=taken)
    return filled


def _quantities(copy: Drawn[Any], kind: str, name: str) -> Filled:
    values: dict[str, Any] = {"kind": kind}
    uncertainties, assumed, taken = {}, {}, {}
    known = dict(estimates(copy.entry))
    for target, source, unit in FIELDS[kind]:
        if source not in copy.values:
            continue
        values[target] = written_quantity(copy.values[source], unit)
        taken[target] = _taken(copy, source)
        spread = known[source].spread if target not in RANGES else known[source].rel_sd
        if spread and (source in copy.assumed or known[source].rel_sd):
            uncertainties[target] = spread
        if source in copy.assumed:
            value, shown = in_unit(copy.values[source], known[source].unit), known[source].unit
            assumed[target] = f"{value:.4g}{'' if shown == '1' else ' ' + shown} of {copy.assumed[source].known}"
    return Filled(name=name, values=values, uncertainties=uncertainties, assumed=assumed, taken=taken)


def _taken(copy: Drawn[Any], source: str) -> FromCatalog:
    known = dict(estimates(copy.entry))[source]
    maker = getattr(copy.entry, "stands_for", "") or copy.entry.name
    return FromCatalog(entry=maker, field=source, known=known, used=copy.values[source])


def _with_winding(filled: Filled, copy: Drawn[Motor]) -> Filled:
    """Return the motor with pole pairs, slots and the lines that it brings along."""
    counts = {key: copy.count(key) for key in ("pole_pairs", "slots") if key in copy.values}
    assumed = {key: f"{counts[key]} of {copy.assumed[key].known}" for key in counts if key in copy.assumed}
    if not copy.entry.ripple.known_lines:
        shares = {key: known for key, known in copy.assumed.items() if key.startswith("ripple.")}
        assumed |= {key: f"{copy.values[key]:.3g} of {known.known}" for key, known in shares.items()}
    lines = [key for key in copy.values if key.startswith("ripple.")]
    if copy.entry.ripple.known_lines:
        lines = [key for key in lines if key.startswith("ripple.known_lines.")]
    return replace(
        filled,
        values={**filled.values, "model": copy.entry.name, **counts},
        assumed={**filled.assumed, **assumed},
        taken={**filled.taken, **{key: _taken(copy, key) for key in (*counts, *lines)}},
        effects=motor_effects(copy, filled.name),
    )


def _on_its_supply(filled: Filled, copy: Drawn[Motor], place: str) -> Filled:
    """Return the drive of an induction motor with its pole pairs; InputError where the motor is of another kind."""
    if copy.entry.kind != "induction":
        raise InputError(
            f"{place}.catalog: {copy.entry.name} is a {copy.entry.kind} motor, which has no slip; write a "
            "speed_controller for it"
        )
    pairs = copy.count("pole_pairs")
    assumed = {"pole_pairs": f"{pairs} of {copy.assumed['pole_pairs'].known}"} if "pole_pairs" in copy.assumed else {}
    return replace(filled, values={**filled.values, "pole_pairs": pairs}, assumed={**filled.assumed, **assumed})


def _with_teeth(filled: Filled, gearbox: Gearbox, seed: int) -> Filled:
    """Return the gear with its ratio and, where a set is known or possible, its teeth."""
    teeth, sets = drawn_teeth(gearbox, seed), gearbox.tooth_sets()
    values = {**filled.values, "ratio": gearbox.ratio, "teeth": [] if teeth is None else [asdict(teeth)]}
    if teeth is None or len(sets) < 2:
        return replace(filled, values=values)
    chosen = {"teeth": f"{teeth.spoken} of {len(sets)} possible sets"}
    return replace(filled, values=values, assumed={**filled.assumed, **chosen})


def _with_damping(filled: Filled, copy: Drawn[Any]) -> Filled:
    """Return the coupling with a viscous damping, where the catalog has only a damping ratio or a loss factor.

    ``c = 2 zeta k / w`` and ``c = eta k / w`` at the angular frequency w of ``COUPLING_MODE``: a viscous damper has
    the stated ratio at one frequency only.
    """
    if "damping" in filled.values:
        return filled
    source = "damping_ratio" if "damping_ratio" in copy.values else "loss_factor"
    loss = copy.value(source) * (2 if source == "damping_ratio" else 1)
    damping = loss * copy.value("stiffness") / (2 * pi * COUPLING_MODE)
    spread = dict(estimates(copy.entry))[source].spread
    text = f"{damping:.3g} N*m*s/rad, from its {source.replace('_', ' ')} at {COUPLING_MODE:g} Hz"
    return replace(
        filled,
        values={**filled.values, "damping": written_quantity(damping, "N*m*s/rad")},
        assumed={**filled.assumed, "damping": text},
        uncertainties={**filled.uncertainties, **({"damping": spread} if spread else {})},
        taken={**filled.taken, "damping": _taken(copy, source)},
    )


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
