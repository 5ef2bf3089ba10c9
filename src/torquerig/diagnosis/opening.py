"""From recordings to a case: shafts followed, lines found, and the nominal model calibrated on what fits may see."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import calibrated
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.diagnosis.looking.combs import without_comb
from torquerig.diagnosis.looking.common_tones import common_tones, lead_astray
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.hum import hum_places
from torquerig.diagnosis.looking.lines_left import Strong, known_places, lines_left, strong_lines
from torquerig.diagnosis.looking.notches import notches
from torquerig.diagnosis.looking.observed import Observed, observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.pulses_both_ways import lines_of_pulses
from torquerig.diagnosis.looking.refilled import refilled
from torquerig.diagnosis.looking.without_tones import less_tones
from torquerig.diagnosis.sample_findings import SampleFindings
from torquerig.inference.knobs import nuisance_knobs
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.inference.places import Place
from torquerig.linear_twin.twin import Twin
from torquerig.parallel import parallel_map
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario

_STEADY = 2  # runs by which a line of an order is told from one of a fixed frequency


def followed(recordings: Sequence[Recording], mended: Sequence[Recording], rig: Rig) -> tuple[Observed, ...]:
    """Return the runs with the torque of the mended recordings, and their samples as they were recorded.

    Where strong lines stand out that ``rig`` lacks, the shafts are followed once more, by those orders as well and with
    those tones taken off.
    """
    runs = _runs(recordings, mended, rig, Strong())
    tones = common_tones(runs)
    if tones:
        without = _with(tones, _runs(recordings, mended, rig, Strong(tones=tones)))
        own = [place.at for place in known_places(runs, rig) if place.domain == "order"]
        runs, tones = (without, tones) if lead_astray(runs, without, tones, own) else (runs, ())
    strong = strong_lines(runs, rig)
    if not strong.orders and not strong.tones:
        return runs
    strong = replace(strong, tones=(*tones, *(tone for tone in strong.tones if tone not in tones)))
    return _with(tones, _runs(recordings, mended, rig, strong))


def opened(
    scenario: Scenario, runs: tuple[Observed, ...], nominal: Rig, faults: SampleFindings
) -> tuple[Case, tuple[Features, ...]]:
    """Return the case with the nominal model calibrated, and the held-out features."""
    struck = faults.struck or [()] * len(runs)
    runs = tuple(
        replace(
            run, rebuilt=run.name in faults.rebuilt, stepping=faults.stepping, broken=run.name in faults.broken,
            swept=faults.swept, slipping=any(struck), struck=tuple(own),
        )
        for run, own in zip(runs, struck, strict=True)
    )  # fmt: skip
    narrow = notches(runs)
    runs = tuple(replace(run, notches=narrow) for run in runs)
    whole = _for_fits(runs, faults)
    known = known_places(whole, nominal)
    left = without_comb(lines_left(whole, known, rig=nominal))
    left = (*left, *_of_pulses(whole, [*known, *(peak.place for peak in left)], nominal))
    unknown = [peak.place for peak in left]
    places = [*known, *unknown, *hum_places(left)]
    runs = tuple(refilled(run, lost, places) for run, lost in zip(runs, faults.lost, strict=True))
    fitted = _for_fits(runs, faults)
    looks = [(run, False) for run in fitted] + [(run, True) for run in runs]
    found = parallel_map(lambda look: features(look[0], places, held=look[1], unknown=unknown), looks)
    found = [replace(each, observed=run) for each, (run, _) in zip(found, looks, strict=True)]  # one run, not copies
    seen, held = tuple(found[: len(fitted)]), tuple(found[len(fitted) :])
    occupancies = [run.run.occupancy_percent or 0.0 for run in fitted]
    knobs = nuisance_knobs(nominal, scenario.uncertainties, occupancies=occupancies)
    rig = nominal
    for candidate in faults.candidates:
        rig = candidate.added_to(rig) if candidate.mechanism == "quantization" else rig
    apart = calibrated(rig, [each.without(unknown) for each in seen], knobs)
    model = calibrated(rig, seen, knobs, start=apart.positions, jacobian=apart.jacobian, near=False)
    return Case(nominal=rig, runs=fitted, seen=seen, model=model, left=left, apart=apart.positions), held


def _of_pulses(runs: Sequence[Observed], places: Sequence[Place], rig: Rig) -> list[Peak]:
    """Return the lines of a load that comes in pulses, where a run that turns back shows it."""
    at = loaded_part(rig)
    return [] if at is None else lines_of_pulses(runs, places, turns=Twin(rig).turns[rig.node(at)])


def _runs(
    recordings: Sequence[Recording], mended: Sequence[Recording], rig: Rig, strong: Strong
) -> tuple[Observed, ...]:
    angles = shaft_angles([_less(each, strong.tones) for each in mended], rig, also=strong.orders)
    ratio = kinematics_of(rig).ratio
    runs = [observed(each, angle, ratio=ratio) for each, angle in zip(mended, angles, strict=True)]
    return tuple(replace(run, recording=replace(raw, run=run.run)) for run, raw in zip(runs, recordings, strict=True))


def _with(tones: tuple[float, ...], runs: Sequence[Observed]) -> tuple[Observed, ...]:
    return tuple(replace(run, tones=tones) for run in runs)


def _less(recording: Recording, tones: Sequence[float]) -> Recording:
    name = recording.torque_name()
    values = less_tones(recording.channels[name].values, recording.sample_rate, tones)
    return recording.with_values(name, values) if tones else recording


def _for_fits(runs: tuple[Observed, ...], faults: SampleFindings) -> tuple[Observed, ...]:
    """Return the runs that fits may use: those that are not clipped, all where all are.

    Where they leave no two steady runs, those whose moments at the limit were rebuilt serve as well.
    """
    whole = tuple(run for run in runs if run.name not in faults.clipped)
    if sum(run.steady for run in whole) < _STEADY:
        whole = tuple(run for run in runs if run.rebuilt or run.name not in faults.clipped)
    return whole or runs
