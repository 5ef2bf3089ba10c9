"""Values of a part from a catalog entry: its fields, its ripple lines, and the assumed values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from typing import Any, TypeVar

from torquerig.catalog.coupling import Coupling
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog
from torquerig.catalog.sampling import Sample, sample_entry, sample_teeth
from torquerig.catalog.sensor import Sensor
from torquerig.errors import InputError, UnknownNameError
from torquerig.scenario.catalog_values.filled import Filled, FromCatalog
from torquerig.scenario.catalog_values.motor_effects import motor_effects
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
    "worm_gear": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("forward_efficiency", "efficiency", "1"),
        ("worm_inertia", "input_inertia", "kg*m^2"),
        ("wheel_inertia", "output_inertia", "kg*m^2"),
        ("backlash", "backlash", "rad"),
        ("lead_angle", "lead_angle", "rad"),
    ),
    "torque_sensor": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("inertia", "inertia", "kg*m^2"),
        ("sensitivity", "sensitivity", "V/(N*m)"),
        ("bandwidth", "bandwidth", "Hz"),
        ("noise_rms", "noise", "V"),
        ("converter_range", "adc.range", "V"),
        ("gain_tolerance", "gain_tolerance", "1"),
    ),
    "coupling": (
        ("stiffness", "stiffness", "N*m/rad"),
        ("damping", "damping", "N*m*s/rad"),
        ("inertia", "inertia", "kg*m^2"),
    ),
}

RANGES = (
    "torque_limit", "rated_torque", "rated_speed", "breakdown_torque", "converter_range", "backlash", "gain_tolerance",
)  # fmt: skip
"""Limits of ranges, the backlash and tolerances: a reading within the range does not depend on them."""

BOUGHT_AS = {"planetary_gear": "gear", "fixed_axis_gear": "gear"}  # kinds with the same catalog folder and fields


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
        "worm_gear": catalog.gearbox,
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
    if isinstance(found, Gearbox) and (found.kind == "worm") != (kind == "worm_gear"):
        meant = "worm_gear" if found.kind == "worm" else "gear"
        raise InputError(f"{place}.catalog: {found.name} is a {found.kind} gear; write kind: {meant}")
    sample = sample_of(found, seed)
    filled = _quantities(sample, kind, name)
    if isinstance(found, Motor):
        motor = Sample(found, sample.values, sample.assumed)
        return _on_its_supply(filled, motor, place) if kind == "induction_drive" else _with_winding(filled, motor)
    if isinstance(found, Gearbox):
        return _with_teeth(filled, found, seed)
    if isinstance(found, Coupling):
        return _with_loss(filled, sample)
    if isinstance(found, Sensor) and "adc.bits" in sample.values:
        taken = {**filled.taken, **_taken(sample, {"converter_bits": "adc.bits"})}
        return replace(filled, values={**filled.values, "converter_bits": sample.count("adc.bits")}, taken=taken)
    return filled


def _quantities(sample: Sample[Any], kind: str, name: str) -> Filled:
    values: dict[str, Any] = {"kind": kind}
    uncertainties, assumed = {}, {}
    known = dict(estimates(sample.entry))
    there = {target: source for target, source, _ in FIELDS[kind] if source in sample.values}
    for target, source, unit in FIELDS[kind]:
        if target not in there:
            continue
        values[target] = written_quantity(sample.values[source], unit)
        spread = known[source].part_rel_sd if target not in RANGES else known[source].rel_sd
        if spread and (source in sample.assumed or known[source].rel_sd):
            uncertainties[target] = spread
        if source in sample.assumed:
            value, shown = in_unit(sample.values[source], known[source].unit), known[source].unit
            assumed[target] = f"{value:.4g}{'' if shown == '1' else ' ' + shown} of {sample.assumed[source].known}"
    taken = _taken(sample, there)
    return Filled(name=name, values=values, uncertainties=uncertainties, assumed=assumed, taken=taken)


def _taken(sample: Sample[Any], fields: Mapping[str, str]) -> dict[str, FromCatalog]:
    """Return what a part took from the catalog, from the entry's field by field of the part."""
    known = dict(estimates(sample.entry))
    maker = getattr(sample.entry, "stands_for", "") or sample.entry.name
    return {
        target: FromCatalog(entry=maker, field=source, known=known[source], used=sample.values[source])
        for target, source in fields.items()
    }


def _with_winding(filled: Filled, sample: Sample[Motor]) -> Filled:
    """Return the motor with pole pairs, slots and its ripple lines."""
    counts = {key: sample.count(key) for key in ("pole_pairs", "slots") if key in sample.values}
    assumed = {key: f"{counts[key]} of {sample.assumed[key].known}" for key in counts if key in sample.assumed}
    if not sample.entry.ripple.known_lines:
        shares = {key: known for key, known in sample.assumed.items() if key.startswith("ripple.")}
        assumed |= {key: f"{sample.values[key]:.3g} of {known.known}" for key, known in shares.items()}
    lines = [key for key in sample.values if key.startswith("ripple.")]
    if sample.entry.ripple.known_lines:
        lines = [key for key in lines if key.startswith("ripple.known_lines.")]
    return replace(
        filled,
        values={**filled.values, "model": sample.entry.name, **counts},
        assumed={**filled.assumed, **assumed},
        taken={**filled.taken, **_taken(sample, {key: key for key in (*counts, *lines)})},
        effects=motor_effects(sample, filled.name),
    )


def _on_its_supply(filled: Filled, sample: Sample[Motor], place: str) -> Filled:
    """Return the drive of an induction motor with its pole pairs; InputError where the motor is of another kind."""
    if sample.entry.kind != "induction":
        raise InputError(
            f"{place}.catalog: {sample.entry.name} is a {sample.entry.kind} motor, which has no slip; write a "
            "speed_controller for it"
        )
    pairs = sample.count("pole_pairs")
    assumed = (
        {"pole_pairs": f"{pairs} of {sample.assumed['pole_pairs'].known}"} if "pole_pairs" in sample.assumed else {}
    )
    return replace(filled, values={**filled.values, "pole_pairs": pairs}, assumed={**filled.assumed, **assumed})


def _with_teeth(filled: Filled, gearbox: Gearbox, seed: int) -> Filled:
    """Return the gear with its ratio and, where a set is known or possible, its teeth; a worm with starts and wheel."""
    if gearbox.kind == "worm":
        return replace(filled, values={**filled.values, "starts": gearbox.starts, "wheel_teeth": gearbox.wheel_teeth})
    teeth, sets = sample_teeth(gearbox, seed), gearbox.tooth_sets()
    values = {**filled.values, "ratio": gearbox.ratio, "teeth": [] if teeth is None else [asdict(teeth)]}
    if teeth is None or len(sets) < 2:
        return replace(filled, values=values)
    chosen = {"teeth": f"{teeth.spoken} of {len(sets)} possible sets"}
    return replace(filled, values=values, assumed={**filled.assumed, **chosen})


def _with_loss(filled: Filled, sample: Sample[Any]) -> Filled:
    """Return the coupling with a loss factor, where the catalog has only that or a damping ratio (half of it)."""
    if "damping" in filled.values:
        return filled
    source = "damping_ratio" if "damping_ratio" in sample.values else "loss_factor"
    loss = sample.value(source) * (2 if source == "damping_ratio" else 1)
    spread = dict(estimates(sample.entry))[source].part_rel_sd
    known = sample.assumed.get(source)
    text = f"{loss:.3g}, from its {source.replace('_', ' ')}" + ("" if known is None else f" {known.known}")
    return replace(
        filled,
        values={**filled.values, "loss_factor": loss},
        assumed={**filled.assumed, "loss_factor": text},
        uncertainties={**filled.uncertainties, **({"loss_factor": spread} if spread else {})},
        taken={**filled.taken, **_taken(sample, {"loss_factor": source})},
    )


def sample_of(entry: AnyEntry, seed: int) -> Sample[AnyEntry]:
    """Return one sample: stated values unchanged (their standard deviation is for calibration), others random."""
    sample = sample_entry(entry, seed)
    stated = {
        name: estimate.value
        for name, estimate in estimates(entry)
        if estimate.value is not None and estimate.low is None and not estimate.choices
    }
    return Sample(
        entry,
        {**sample.values, **stated},
        {name: assumed for name, assumed in sample.assumed.items() if name not in stated},
    )
