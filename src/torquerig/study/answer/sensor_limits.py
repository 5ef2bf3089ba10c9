"""What scenario and catalog state on the sensor and its converter, as items of an uncertainty budget.

A limit "at most a" of a data sheet counts as a rectangular distribution of half-width a, so u = a / sqrt(3) (GUM
4.3.7). Of an interval of limits the largest counts.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.parts import ForceSensor
from torquerig.study.answer.uncertainty_item import Item
from torquerig.study.candidates import scenario_of

if TYPE_CHECKING:
    from torquerig.catalog.sensor import Sensor
    from torquerig.parameter import Estimate
    from torquerig.scenario.model import Scenario
    from torquerig.study.results import DriveResult, StudyRuns

AnySensor = AmplifiedTorqueSensor | ForceSensor
RECTANGULAR, ARCSINE = sqrt(3), sqrt(2)  # [1] half-width over standard deviation
DRIFT_OVER = 10.0  # [K] to which data sheets and the catalog refer a drift
IN_FIRST = "simulated, and contained in the item filter"
NO_ENTRY = "name a catalog entry at the sensor, or add the effect to the rig:"


@dataclass(frozen=True, kw_only=True)
class _Measuring:
    """The sensor of a study, its catalog entry, and the mean torque [N m] or force [N] that it reads.

    ``tolerance`` is the largest relative error of its sensitivity [1], 0 where none is stated; ``simulated`` are the
    kinds of parts that act on it; ``warmed`` is the stated change of its temperature [K].
    """

    sensor: AnySensor
    entry: Sensor | None
    mean: float
    tolerance: float
    simulated: frozenset[str]
    warmed: float | None
    unit: str


def sensor_items(drive: DriveResult, runs: StudyRuns) -> tuple[Item, ...]:
    """Return the items of sensor and converter; one "not known" where the reading comes from another kind of sensor."""
    scenario = scenario_of(drive.candidate, runs.study, seed=runs.study.settings.seed)
    rig = scenario.rig
    known: list[AnySensor] = [*rig.parts_of(AmplifiedTorqueSensor), *rig.parts_of(ForceSensor)]
    sensors = [one for place in rig.places for one in known if one.name == place]
    if not sensors:
        remedy = "the budget needs a torque_sensor, reaction_torque_sensor or force_sensor"
        return (_unknown("sensor and converter", remedy),)
    read = _measuring(scenario, sensors[0], drive, runs)
    return (
        _sensitivity(read), _linearity(read), _zero(read), _temperature(read, "zero"),
        _temperature(read, "sensitivity"), *_bending(read), _converter(read),
    )  # fmt: skip


def _measuring(
    scenario: Scenario, sensor: AmplifiedTorqueSensor | ForceSensor, drive: DriveResult, runs: StudyRuns
) -> _Measuring:
    stated = runs.study.document.data["rig"].get(sensor.name, {})
    name = stated.get("catalog")
    found = runs.study.catalog.sensor(name) if name and sensor.kind == "torque_sensor" else None
    mean = runs.mean_load if drive.shares is None else drive.shares.mean
    kinds = frozenset(part.kind for part in scenario.rig.parts if getattr(part, "sensor", sensor.name) == sensor.name)
    tolerance = (
        sensor.gain_tolerance if "gain_tolerance" in stated else _largest(found.gain_tolerance if found else None)
    )
    return _Measuring(
        sensor=sensor, entry=found, mean=abs(mean), tolerance=tolerance, simulated=kinds,
        warmed=scenario.operating_point.temperature_change, unit=drive.disturbance.unit.replace("*", " "),
    )  # fmt: skip


def _sensitivity(read: _Measuring) -> Item:
    if not read.tolerance:
        return _unknown("sensor class", "state gain_tolerance at the sensor, from its data sheet")
    return _limit(
        "sensor class", read.tolerance * read.mean,
        f"sensitivity within {100 * read.tolerance:.2g} % of {read.mean:.3g} {read.unit}",
        source=_source(read.entry.gain_tolerance if read.entry else None),
    )  # fmt: skip


def _linearity(read: _Measuring) -> Item:
    name = "linearity and hysteresis"
    if read.simulated & {"sensor_hysteresis", "sensor_nonlinearity"}:
        return _contained(name)
    known = read.entry.nonlinearity_hysteresis if read.entry else None
    share = _largest(known)
    if read.entry is None or not share:
        remedy = "the catalog entry of the sensor states no nonlinearity_hysteresis"
        return _unknown(name, remedy if read.entry else f"{NO_ENTRY} nonlinearity and hysteresis")
    full = read.entry.range_torque.nominal()
    return _limit(name, share * full, f"within {100 * share:.2g} % of {full:g} {read.unit}", source=_source(known))


def _zero(read: _Measuring) -> Item:
    if read.sensor.tare:
        return Item(name="zero", kind="B", standard=0.0, basis="tare: the zero was set before the runs",
                    source="scenario")  # fmt: skip
    if read.sensor.zero_tolerance is None:
        return _unknown("zero", "state tare: true or zero_tolerance at the sensor")
    return _limit("zero", read.sensor.zero_tolerance, "largest error of the zero", source="scenario")


def _temperature(read: _Measuring, of: str) -> Item:
    name = f"temperature drift of the {of}"
    if "sensor_drift" in read.simulated and of == "zero":
        return _contained(name)
    known = None if read.entry is None else read.entry.zero_drift if of == "zero" else read.entry.gain_drift
    share = _largest(known)
    if read.entry is None or not share:
        return _unknown(name, f"{NO_ENTRY} the drift of the {of}")
    torque = read.entry.range_torque.nominal() if of == "zero" else read.mean
    if read.warmed is None:
        remedy = f"state operating_point.temperature_change; each {DRIFT_OVER:g} K adds up to {share * torque:.2g} "
        return _unknown(name, remedy + read.unit)
    largest = share * torque * read.warmed / DRIFT_OVER
    return _limit(name, largest, f"within {100 * share:.2g} % of {torque:.3g} {read.unit} per {DRIFT_OVER:g} K, over "
                  f"{read.warmed:g} K", source=_source(known))  # fmt: skip


def _bending(read: _Measuring) -> tuple[Item, ...]:
    """Return the line once a turn of a shaft that bends the sensor; none for a force sensor, which does not turn."""
    if isinstance(read.sensor, ForceSensor):
        return ()
    name = "bending of the sensor"
    if "bending_crosstalk" in read.simulated:
        return (_contained(name),)
    known = read.entry.bending_crosstalk if read.entry else None
    share = _largest(known)
    if read.entry is None or not share:
        return (_unknown(name, "neither the weight on the sensor nor its cross-talk is stated"),)
    amplitude = share * read.entry.range_torque.nominal()
    basis = f"line once a turn of at most {amplitude:.2g} {read.unit}, arcsine distribution"
    return (Item(name=name, kind="B", standard=amplitude / ARCSINE, source=_source(known), basis=basis),)


def _converter(read: _Measuring) -> Item:
    step = 2 * read.sensor.converter_range / 2**read.sensor.converter_bits / read.sensor.sensitivity
    return Item(name="converter", kind="B", standard=step / 2 / RECTANGULAR, is_counted=False, source="scenario",
                basis=f"half a step of {1e3 * step:.2g} m{read.unit}, rectangular; {IN_FIRST}")  # fmt: skip


def _limit(name: str, half_width: float, basis: str, *, source: str) -> Item:
    return Item(name=name, kind="B", standard=half_width / RECTANGULAR, basis=f"{basis}, rectangular", source=source)


def _contained(name: str) -> Item:
    return Item(name=name, kind="B", standard=0.0, basis=IN_FIRST, source="scenario", is_counted=False)


def _unknown(name: str, remedy: str) -> Item:
    return Item(name=name, kind="B", standard=None, basis="", source="", remedy=remedy)


def _largest(known: Estimate | None) -> float:
    """Return the largest possible value; 0 where it is not known."""
    return 0.0 if known is None or known.unknown else known.bounds[1]


def _source(known: Estimate | None) -> str:
    return "scenario" if known is None or known.unknown else f"{known.source} ({known.evidence})"
