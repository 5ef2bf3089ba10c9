"""Catalog values behind a figure of a study, with evidence and source, and the calculation as text."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

from torquerig.decide.cell import Origin
from torquerig.study.settings import SIMULATED, Metric, Settings
from torquerig.units import in_unit

if TYPE_CHECKING:
    from torquerig.metrics.figure import Figure
    from torquerig.parameter import Estimate
    from torquerig.scenario.catalog_values.filled import FromCatalog
    from torquerig.study.results import DriveResult

MOST_ORIGINS = 4096  # catalog values whose text is remembered: each stands in some twenty cells
METRIC_TEXTS: Mapping[str, str] = {
    "truth_error": "rms of the filtered reading minus the true load",
    "disturbance": "rms of all that is not load in the unfiltered reading, each group of lines omitted in turn",
    "residual_disturbance": "rms of the lines of motor and gear behind the filter",
    "speed_reserve": "largest speed / (output speed x ratio)",
    "speed_use": "output speed x ratio / rated speed",
    "continuous_output_torque": "rated torque x ratio x efficiency",
    "torque_reserve": "rated torque x ratio x efficiency / mean torque of the load",
    "sensor_peak": "torque limit of the drive (set by the study for the sensor) x ratio x efficiency",
    "servo": "stated in the catalog",
    "new_parts": "3 for a new motor (with its drive and adapter), 1 for a new gearbox",
    "price": "sum of the prices of all new parts",
}
"""Calculation of each metric of the study; figures of a sizing have theirs as their source."""

FACT_TEXTS: Mapping[str, str] = {
    "rated_speed": "catalog value, unchanged",
    "rated_torque": "catalog value, unchanged",
    "output_torque": "rated torque x ratio x efficiency",
    "unlimited_peak": "peak torque x ratio x efficiency, without the limit for the sensor",
    "rotor_inertia": "catalog value, unchanged",
    "inertia_at_output": "rotor inertia x ratio squared",
    "servo": "stated in the catalog",
    "a_series_adapter": "stated in the catalog",
    "same_shaft": "shaft diameter compared with that of the present motor",
}
"""Calculation of facts that need the catalog only."""


def origins_in_rig(drive: DriveResult) -> tuple[Origin, ...]:
    """Return the catalog values of the simulated rig of a drive, which are behind all its simulated figures."""
    return tuple(_of_rig(one) for one in drive.taken.values())


def origins_of(figure: Figure, metric: Metric, *, in_rig: tuple[Origin, ...]) -> tuple[Origin, ...]:
    """Return the catalog values behind a figure: those of the whole simulated rig, or those of its formula."""
    if metric in SIMULATED:
        return in_rig
    return tuple(origin_of(name, known) for name, known in figure.rests_on)


def origin_of(name: str, known: Estimate) -> Origin:
    """Return a catalog value for the trace."""
    evidence = "" if known.unknown and not known.source else known.evidence
    return Origin(name=name.removeprefix("the "), shown=_shown(name, known), evidence=evidence, source=known.source)


def metric_text(metric: str, figure: Figure, *, chain: str | None, settings: Settings) -> str:
    """Return the calculation of a figure from its catalog values as text."""
    text = METRIC_TEXTS.get(metric, f"{metric.replace('_', ' ')}: {figure.source}" if figure.source else "")
    if metric not in SIMULATED:
        return text
    behind = "" if metric == "disturbance" or chain is None else f", behind the filter {chain}"
    samples = (
        f"; the value is the median of {1 + settings.draws} Monte Carlo samples of the catalog under the same load, "
        "the interval their extremes"
        if settings.draws
        else ""
    )
    return f"simulated for {settings.duration:g} s with seed {settings.seed}{behind}: {text}{samples}"


@lru_cache(maxsize=MOST_ORIGINS)
def _of_rig(one: FromCatalog) -> Origin:
    shown = one.known.shown()
    if not one.known.documented:
        unit = "" if one.known.unit == "1" else f" {one.known.unit}"
        shown = f"{shown}, in the first sample {in_unit(one.used, one.known.unit):.4g}{unit}"
    return Origin(name=one.name, shown=shown, evidence=one.known.evidence, source=one.known.source)


def _shown(name: str, known: Estimate) -> str:
    if name.startswith("whether ") and known.value is not None:
        return "yes" if known.value else "no"
    return known.shown()
