"""What a linear twin leaves and a simulation of the same rig shows too is no missing physics."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.calibration import Calibrated, misfits_of
from torquerig.diagnosis.fitting.misfit import misfit_sum
from torquerig.diagnosis.judging import by_simulation, leftover
from torquerig.diagnosis.judging.by_simulation import left_and_fall, left_by_simulation
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.lines_left import known_places
from torquerig.diagnosis.looking.observed import Observed, observed
from torquerig.errors import SimulationError
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.inference.places import order
from torquerig.mechanisms import Backlash, BearingDefect, Cogging, QuadraticDrag, SensorDrift
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario

# its own ripple turns the motor by 56 * 0.6 N m / (J omega^2) of a radian, enough for a line at twice the order
STRONG = Cogging(name="cogging", slots=12, pole_pairs=7, further={56: 0.6})
BEARING = BearingDefect(
    name="bearing", at="wear_part", order_output=8.08, ring_frequency=1650.0, damping=0.03, amplitude=0.5
)
SPEED = 158.0  # [rpm] where order 56 meets the wear part's mode


@pytest.fixture(scope="module")
def recording(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig + STRONG, 5, rpm=SPEED, duration=12.0, occupancy=0.0)


def case_of(rig: Rig, recording: Recording) -> Case:
    """The run against ``rig``, none of its numbers fitted."""
    angles = shaft_angles([recording], rig)
    run = observed(recording, angles[0], ratio=kinematics_of(rig).ratio)
    seen = (features(run, [*known_places([run], rig), order(112.0)]),)
    misfits = misfits_of(rig, seen)
    none = np.zeros(0)
    model = Calibrated(rig, (), none, np.zeros((0, 0)), misfits, misfit_sum(misfits))
    return Case(nominal=rig, runs=(run,), seen=seen, model=model, left=())


def fall(case: Case, other: Rig) -> float:
    return left_and_fall(case, (), other)[1]


def at_twice_the_order(left: tuple[Mismatch, ...]) -> list[Mismatch]:
    return [mismatch for mismatch in left if mismatch.domain == "order" and mismatch.at in {112.0, 560.0}]


@pytest.mark.long
def test_a_line_that_a_strong_ripple_makes_at_twice_its_order(wear_rig: Scenario, recording: Recording) -> None:
    case = case_of(wear_rig.rig + STRONG, recording)
    twin = mismatches(case)
    assert at_twice_the_order(twin)  # the twin has none
    assert not at_twice_the_order(left_by_simulation(case, twin))


@pytest.mark.long
def test_what_the_rig_lacks_stays_left(wear_rig: Scenario, recording: Recording) -> None:
    case = case_of(wear_rig.rig, recording)
    twin = mismatches(case)
    assert at_twice_the_order(left_by_simulation(case, twin)) == at_twice_the_order(twin) != []


@pytest.mark.long
def test_where_nothing_can_be_simulated_all_stays(
    wear_rig: Scenario, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object, **__: object) -> None:
        raise SimulationError("the motor is held fast")

    monkeypatch.setattr(by_simulation, "simulated_runs", fails)
    case = case_of(wear_rig.rig + STRONG, recording)
    twin = mismatches(case)
    assert left_by_simulation(case, twin) == twin
    assert left_and_fall(case, twin, wear_rig.rig) == (twin, 0.0)


@pytest.mark.long
def test_what_takes_up_but_the_line_of_a_simulation_gains_nothing_beside_it(
    wear_rig: Scenario, recording: Recording
) -> None:
    """Cogging at twice the order, of the size that the strong ripple makes by itself."""
    case = case_of(wear_rig.rig + STRONG, recording)
    stand_in = Cogging(name="stand_in", slots=12, pole_pairs=7, further={112: 0.1})
    beside = wear_rig.rig + STRONG + stand_in
    by_twin = case.model.cost - misfit_sum(misfits_of(beside, case.seen))
    assert by_twin > 1000.0
    assert abs(fall(case, beside)) < 1.0
    without = case_of(wear_rig.rig, recording)
    assert fall(without, wear_rig.rig + STRONG) > 100.0


@pytest.mark.long
@pytest.mark.parametrize("occupancy", [0.0, 5.0])
def test_the_chance_of_a_load_speaks_for_no_rig(
    occupancy: float, wear_rig: Scenario, record: Callable[..., Recording], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The mean torque of a simulation strays from the twin's as its load does, and from a recording's otherwise."""
    case = case_of(wear_rig.rig, record(wear_rig.rig, 6, rpm=1000.0, duration=12.0, occupancy=occupancy))
    (twin,) = [expected(case.model.rig, features) for features in case.seen]
    strayed = 0.1 * np.random.default_rng(1).standard_normal(twin.level.size)
    correction = Correction(np.ones_like(twin.power), np.zeros_like(twin.amplitude), strayed, None)
    monkeypatch.setattr(by_simulation, "_beyond_the_twin", lambda _: (None, [correction]))
    other = wear_rig.rig + QuadraticDrag(name="quadratic_drag", at="wear_part", coefficient=2e-4)
    by_twin = case.model.cost - misfit_sum(misfits_of(other, case.seen))
    assert (fall(case, other) == pytest.approx(by_twin)) is bool(occupancy)


@pytest.mark.long
@pytest.mark.parametrize(("made", "stays"), [(0, True), (4, False)])
def test_flights_that_lines_make_in_a_simulation_too_are_none(
    made: int, stays: bool, wear_rig: Scenario, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where lines beat, the torque rests near zero and swings off, at the same moments in a simulation."""

    def in_simulation(run: Observed, **_: object) -> int:
        assert run.origin == "simulated"
        return made

    def in_recording(_: object) -> int:
        return 6

    monkeypatch.setattr(by_simulation, "flights_counted", in_simulation)
    for module in (by_simulation, leftover):
        monkeypatch.setattr(module, "flights_beyond_lines", in_recording)
    case = case_of(wear_rig.rig + STRONG, recording)
    (flights,) = (mismatch for mismatch in mismatches(case) if mismatch.domain == "distribution")
    assert (flights in left_by_simulation(case, [flights])) is stays


@pytest.mark.parametrize(("domain", "axis", "same"), [("speed", "rpm", True), ("frequency", "Hz", False)])
def test_a_run_misses_its_mean_torque_once(domain: str, axis: str, same: bool) -> None:
    """Where it misses most differs from twin to simulation; a line is another line elsewhere."""

    def at(where: float) -> Mismatch:
        return Mismatch(
            domain=domain, axis=axis, at=where, width=10.0, recordings=("run",), excess_dB=20.0, share_of_misfit=1.0,
            p_value=0.0,
        )  # fmt: skip

    assert by_simulation._same(at(-10.0), at(400.0)) is same
    assert by_simulation._same(at(-10.0), at(-11.0))


@pytest.mark.long
def test_a_few_of_a_bearings_rings_look_like_flights(
    wear_rig: Scenario, record: Callable[..., Recording], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 27 impacts a second six may; of a rig without a bearing they are flights."""
    monkeypatch.setattr(by_simulation, "flights_beyond_lines", lambda features: 6)
    monkeypatch.setattr(by_simulation, "flights_counted", lambda run: 0)
    monkeypatch.setattr(by_simulation, "without_tones", lambda run, places: run)
    plain = case_of(wear_rig.rig, record(wear_rig.rig, 5, rpm=1000.0, duration=12.0, occupancy=0.0))
    struck = replace(plain, model=replace(plain.model, rig=wear_rig.rig + BEARING))
    copies = [[run] for run in plain.runs]
    assert by_simulation._flies_more(plain, copies)
    assert not by_simulation._flies_more(struck, copies)


@pytest.mark.long
def test_flights_behind_a_drift_are_more_than_its_simulations_make(
    wear_rig: Scenario, record: Callable[..., Recording]
) -> None:
    drifting = wear_rig.rig + SensorDrift(name="sensor_drift", span=1.5, time_constant=0.8)
    gap = Backlash(name="backlash", gear="gearbox", gap=15 / 60 * pi / 180)
    settings: dict[str, Any] = {"rpm": 200.0, "occupancy": 0.0, "rate": 25_000.0, "duration": 12.0}
    flying, still = (case_of(rig, record(rig, 3, **settings)) for rig in (drifting + gap, drifting))
    known = replace(flying, model=replace(flying.model, rig=drifting))
    assert by_simulation._flies_more(known, [[run] for run in still.runs])
    assert not by_simulation._flies_more(known, [[run] for run in flying.runs])
