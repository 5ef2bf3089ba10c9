"""What a figure of a study was worked out from: catalog values with evidence and source, and how, in words."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.decide.cell import Origin
from torquerig.metrics.figure import Figure
from torquerig.parameter import Estimate
from torquerig.scenario.filled import FromCatalog
from torquerig.study.results import DriveResult
from torquerig.study.settings import SIMULATED, Metric, Settings
from torquerig.units import in_unit

IN_WORDS: Mapping[str, str] = {
    "truth_error": "rms of the filtered reading minus the true load",
    "disturbance": "rms of all that is not load in the unfiltered reading, each group of lines left out in turn",
    "left_disturbance": "rms of what the lines of motor and gear still add behind the filter",
    "speed_reserve": "largest speed / (output speed x ratio)",
    "speed_use": "output speed x ratio / rated speed",
    "continuous_output_torque": "rated torque x ratio x efficiency",
    "torque_reserve": "rated torque x ratio x efficiency / mean torque of the load",
    "sensor_peak": "torque limit of the drive, as the study sets it for the sensor, x ratio x efficiency",
    "servo": "as the catalog states it",
    "new_parts": "3 for a motor that does not stand there yet (with its drive and adapter), 1 for such a gearbox",
    "price": "sum of the prices of what does not stand there yet",
}
"""How each metric of the study's own comes about; a sizing's figure says it itself, as its source."""

FACTS_IN_WORDS: Mapping[str, str] = {
    "rated_speed": "catalog value as it stands",
    "rated_torque": "catalog value as it stands",
    "output_torque": "rated torque x ratio x efficiency",
    "unlimited_peak": "peak torque x ratio x efficiency, without a limit set for the sensor",
    "rotor_inertia": "catalog value as it stands",
    "inertia_at_output": "rotor inertia x ratio squared",
    "servo": "as the catalog states it",
    "a_series_adapter": "as the catalog states it",
    "same_shaft": "shaft diameter beside that of the present motor",
}
"""The same for what is read off the catalog without a simulation."""


def origins_of(drive: DriveResult, figure: Figure, metric: Metric) -> tuple[Origin, ...]:
    """Return the catalog values behind a figure: those of the whole simulated rig, or those of its formula."""
    if metric in SIMULATED:
        return tuple(_of_rig(one) for one in drive.taken.values())
    return tuple(origin_of(name, known) for name, known in figure.rests_on)


def origin_of(name: str, known: Estimate) -> Origin:
    """Return a catalog value as the trace shows it."""
    evidence = "" if known.unknown and not known.source else known.evidence
    return Origin(name=name.removeprefix("the "), shown=_shown(name, known), evidence=evidence, source=known.source)


def metric_in_words(metric: str, figure: Figure, *, chain: str | None, settings: Settings) -> str:
    """Return how a figure was worked out of its catalog values."""
    told = IN_WORDS.get(metric, f"{metric.replace('_', ' ')}: {figure.source}" if figure.source else "")
    if metric not in SIMULATED:
        return told
    behind = "" if metric == "disturbance" or chain is None else f", behind the filter {chain}"
    copies = f"; the interval is over {1 + settings.draws} copies drawn from the catalog" if settings.draws else ""
    return f"simulated for {settings.duration:g} s with seed {settings.seed}{behind}: {told}{copies}"


def _of_rig(one: FromCatalog) -> Origin:
    shown = one.known.shown()
    if not one.known.documented:
        unit = "" if one.known.unit == "1" else f" {one.known.unit}"
        shown = f"{shown}, in the first copy {in_unit(one.used, one.known.unit):.4g}{unit}"
    return Origin(name=one.name, shown=shown, evidence=one.known.evidence, source=one.known.source)


def _shown(name: str, known: Estimate) -> str:
    if name.startswith("whether ") and known.value is not None:
        return "yes" if known.value else "no"
    return known.shown()
