"""A sizing as plain text for the terminal, at most 120 wide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import median

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.drive_sizing import EXCEEDS, GROUPS, HOLDS, UNKNOWN, UNSURE, Sizing
from torquerig.plain_table import cut, grid, wrapped
from torquerig.reporting.layout import figure_text
from torquerig.study.candidate import Candidate

LABELS: Mapping[str, str] = {
    "rms_torque": "rms torque", "peak_torque": "largest torque", "peak_power": "largest power",
    "top_speed": "top speed", "mean_speed": "mean speed", "rms_torque_use": "rms / rated torque",
    "peak_torque_use": "largest / peak torque", "continuous_use": "rms / continuous torque there",
    "intermittent_use": "worst moment / intermittent torque", "speed_limit_use": "top / maximum speed",
    "inertia_ratio": "driven inertia / rotor", "thermal_use": "winding's rise / allowed rise",
    "thermal_margin": "winding to its limit", "gearbox_life_use": "gearbox: cubic mean x service factor / T2N",
    "gearbox_peak_use": "gearbox: largest torque / T2a", "gearbox_jam_use": "gearbox: drive's limit / T2a",
    "gearbox_speed_use": "gearbox: input speed / largest", "gearbox_no_load_use": "gearbox: no-load / rated torque",
    "rms_current": "rms current", "peak_current": "largest current", "limit_current": "current at the drive's limit",
    "rms_current_use": "rms / rated current", "peak_current_use": "largest torque / drive's limit",
    "braking_energy": "braking energy of a cycle", "regenerated_energy": "regenerated energy of a cycle",
    "ideal_ratio": "ideal ratio (alpha-beta)", "speed_ratio": "ratio at the maximum speed",
    "best_ratio": "best ratio that the speed allows", "best_ratio_use": "rms / rated torque there",
    "sensor_cycle_use": "sensor: largest torque / range", "sensor_range_use": "sensor: drive's limit / range",
    "sensor_overload": "sensor: drive's limit / limit load",
    "sensor_overload_unlimited": "sensor: peak torque / limit load, no drive limit",
    "load_fidelity": "load in the reading, outside the loop", "loop_fidelity": "slow load in the reading",
    "flat_to": "reading within 10 % of the load up to",
}  # fmt: skip
IN_TABLE: Mapping[str, str] = {
    "rms_torque_use": "rms/rated", "peak_torque_use": "max/peak", "speed_limit_use": "speed", "thermal_use": "thermal",
    "inertia_ratio": "inertia", "gearbox_life_use": "gear T2N", "gearbox_peak_use": "gear T2a",
    "rms_current_use": "current", "regenerated_energy": "regen J", "sensor_overload": "overload",
    "load_fidelity": "fidelity",
}  # fmt: skip
"""The columns of the table of all drives, with their heads."""
LETTERS = 66  # of the value that decides a figure


def sizing_rows(sized: Sizing) -> list[list[str]]:
    """Return a header and a row per figure: value, interval, unit, state of its limit, and the deciding value."""
    rows = [["figure", "value (lowest..highest)", "unit", "limit", "decided by"]]
    for _, units in GROUPS:
        for name, unit in units.items():
            if name not in sized.figures:
                continue
            figure = sized.figures[name]
            shown, counted = _shown(figure, unit)
            first = figure.missing.split(", ")[0]
            rows.append([LABELS[name], shown, "" if counted == "1" else counted, sized.word(name), cut(first, LETTERS)])
    return rows


def verdict_text(sized: Sizing) -> str:
    """Return the verdict as text, with the missing values where it is uncertain."""
    over, unsure, unknown = (sized.with_word(word) for word in (EXCEEDS, UNSURE, UNKNOWN))
    if over:
        return f"Too small: exceeds {_listed(over)}."
    if not unsure and not unknown:
        return "Large enough: every limit holds for all values of the catalog's intervals."
    parts = [f"may exceed {_listed(unsure)}"] if unsure else []
    parts += [f"has unknown {_listed(unknown)}"] if unknown else []
    missing = dict.fromkeys(sized.figures[name].missing.split(", ")[0] for name in (*unsure, *unknown))
    first = f"No limit is exceeded for certain, but the drive {' and '.join(parts)}."
    return f"{first} To decide, ask for {', '.join(missing)}."


def all_rows(sized: Mapping[Candidate, Sizing | str]) -> list[list[str]]:
    """Return a header and a row per drive; a text replaces the numbers of a drive that cannot be sized."""
    rows = [["drive", "verdict", *IN_TABLE.values()]]
    for candidate, one in sized.items():
        if isinstance(one, str):
            rows.append([candidate.name, "out of reach", *("-" for _ in IN_TABLE)])
            continue
        cells = [_cell(one.figures[name]) if name in one.figures else "?" for name in IN_TABLE]
        rows.append([candidate.name, one.verdict if one.verdict != HOLDS else "large enough", *cells])
    return rows


def disturbance_rows(
    before: Sequence[float], after: Mapping[str, Sequence[float]], *, unit: str = "N*m"
) -> list[list[str]]:  # fmt: skip
    """Return a header and a row per filter chain: the disturbance behind it, over the Monte Carlo samples."""
    rows = [["filter", f"disturbance {unit}", "remaining %"], ["(before)", range_text(before), "100"]]
    for name, values in after.items():
        shares = [100 * one / whole for one, whole in zip(values, before, strict=True) if whole > 0]
        rows.append([name, range_text(values), range_text(shares, digits=1) if shares else "-"])
    return rows


def range_text(values: Sequence[float], *, digits: int = 4) -> str:
    """Return the median of the samples, with the lowest and the highest."""
    middle, low, high = (f"{one:.{digits}f}" for one in (median(values), min(values), max(values)))
    return middle if low == high else f"{middle} ({low}..{high})"


def all_text(sized: Mapping[Candidate, Sizing | str]) -> str:
    """Return the table of every drive, and the reasons why some are out of reach."""
    why = [wrapped(f"{one.name}: {reason}") for one, reason in sized.items() if isinstance(reason, str)]
    return "\n".join([grid(all_rows(sized)), *why])


def _cell(figure: Figure) -> str:
    """Return a short text: the interval where there is one."""
    if figure.unknown or figure.low is None or figure.high is None:
        return "?" if figure.unknown else f"{figure.value:.2g}"
    low, high = (f"{end:.2g}" for end in (figure.low, figure.high))
    return low if low == high else f"{low}..{high}"


def _shown(figure: Figure, unit: str) -> tuple[str, str]:
    if unit != "rad/s":
        return figure_text(figure), unit
    turned = Figure(value=None if figure.value is None else figure.value * 30 / 3.141592653589793)
    return figure_text(turned), "rpm"


def _listed(names: Sequence[str]) -> str:
    return ", ".join(f"'{LABELS[name]}'" for name in names)
