"""Small effects beside a large one: simulations of the large one are asked, at the place of the small one."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing import secondary
from torquerig.diagnosis.choosing.secondary import hump_of_a_tone, small_beside, stands_in_simulations
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import Place, frequency, order
from torquerig.mechanisms import Backlash, MainsInterference, QuadraticDrag, SensorBandwidth, SensorDrift, TorsionalMode

RATIO = 5.0
DRAG = QuadraticDrag(name="quadratic_drag", coefficient=1e-3)
CUTOFF = SensorBandwidth(name="sensor_bandwidth", sensor="torque_sensor", cutoff=200.0)


def trial(gain: float, place: Place | None = None, part: Any = DRAG) -> Trial:
    candidate, model = SimpleNamespace(place=place, parts=(part,)), SimpleNamespace(rig=None, corrections=())
    return cast(Trial, SimpleNamespace(gain=gain, candidate=candidate, model=model))


def mismatch(domain: str, axis: str, at: float) -> Mismatch:
    return Mismatch(domain=domain, axis=axis, at=at, width=0.02, recordings=("run",), excess_dB=20.0,  # type: ignore[arg-type]
                    share_of_misfit=0.5, p_value=1e-9)  # fmt: skip


@pytest.mark.parametrize(
    ("earlier", "small"), [((10_000.0, None), True), ((1000.0, None), False), ((10_000.0, order(84.0)), True),
                           ((10_000.0, frequency(50.0)), False)],
)  # fmt: skip
def test_small_is_told_beside_what_moves_the_shafts(earlier: tuple[float, Place | None], small: bool) -> None:
    """A hum of the cable, however large, makes no lines of the shaft."""
    assert small_beside(trial(100.0), [trial(*earlier)]) is small
    assert not small_beside(trial(100.0), [])


def test_what_the_sensor_lets_pass_is_no_part_of_what_moves_the_shafts() -> None:
    assert not small_beside(trial(100.0, part=CUTOFF), [trial(10_000.0)])


def test_a_gap_is_no_part_of_a_zero_that_drifts() -> None:
    gap = Backlash(name="backlash", gear="gearbox", gap=1e-3)
    drift = SensorDrift(name="sensor_drift", span=1.0, time_constant=2.0)
    assert not small_beside(trial(100.0, part=gap), [trial(10_000.0, part=drift)])
    assert small_beside(trial(100.0, part=gap), [trial(10_000.0, part=drift), trial(10_000.0)])
    assert small_beside(trial(100.0), [trial(10_000.0, part=drift)])


@pytest.mark.parametrize(
    ("at", "gain", "hump"), [(49.9, 100.0, True), (249.7, 100.0, True), (149.9, 100.0, False), (49.9, 1000.0, False),
                             (49.0, 100.0, False)],
    ids=["at the hum", "at its fifth", "at none of its lines", "too much for a hump", "beside it"],
)  # fmt: skip
def test_a_small_mode_at_a_hum_is_the_hump_of_what_wanders(at: float, gain: float, hump: bool) -> None:
    hum = MainsInterference(name="hum", frequency=49.97, amplitudes=(0.01, 0.0, 0.0, 0.0, 0.1))
    mode = TorsionalMode(name="mode", frequency=at, inertia=3e-4, damping_ratio=0.01)
    found = replace_model(trial(gain, part=mode), mode)
    assert hump_of_a_tone(found, [trial(10_000.0, frequency(249.85), hum)]) is hump
    assert not hump_of_a_tone(found, [])
    assert not hump_of_a_tone(found, [trial(10_000.0, order(12.6))])


def replace_model(found: Trial, part: Any) -> Trial:
    """Return a trial whose fitted rig is one part."""
    model = SimpleNamespace(rig=SimpleNamespace(parts=(part,)), corrections=())
    return cast(Trial, SimpleNamespace(gain=found.gain, candidate=found.candidate, model=model))


@pytest.mark.parametrize(
    ("place", "asked"),
    [
        (order(11.0), [11.0]),
        (order(8.4), [42.0]),
        (order(3.0), [50.0]),  # the band around it, at the speed of the run that shows it
        (frequency(50.0), [50.0]),
        (None, [11.0, 42.0, 50.0]),
    ],
)
@pytest.mark.parametrize("there", [True, False])
def test_simulations_are_asked_at_its_own_place(
    place: Place | None, asked: list[float], there: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    every = [
        mismatch("order", "motor_shaft", 11.0),
        mismatch("order", "output_shaft", 42.0),
        mismatch("frequency", "Hz", 50.0),
    ]
    runs = (SimpleNamespace(name="run", mean_speed=2 * pi * 50.003 / 3), SimpleNamespace(name="other", mean_speed=1.0))
    case = cast(Case, SimpleNamespace(nominal=SimpleNamespace(run=SimpleNamespace(gear_ratio=RATIO)), runs=runs))
    shown: list[float] = []

    def by_simulation(its: Case, left: Sequence[Mismatch]) -> tuple[Mismatch, ...]:
        assert its is case
        shown.extend(each.at for each in left)
        return tuple(left) if there else ()

    def left(_: Any) -> list[Mismatch]:
        return every

    monkeypatch.setattr(secondary, "mismatches", left)
    monkeypatch.setattr(secondary, "left_by_simulation", by_simulation)
    monkeypatch.setattr(secondary, "left_and_fall", lambda its, left, rig: (by_simulation(its, left), 0.0))
    assert stands_in_simulations(case, trial(100.0, place)) is there
    assert shown == asked


@pytest.mark.parametrize(
    ("place", "fall", "stands"),
    [(None, 60.0, True), (None, 45.0, False), (None, 30.0, False), (order(11.0), 60.0, False)],
)
def test_what_acts_in_many_places_must_gain_beside_simulations(
    place: Place | None, fall: float, stands: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """More than any chance, and a third of what it gains beside the twin; a line must stand out there itself."""
    case = cast(Case, SimpleNamespace(nominal=SimpleNamespace(run=SimpleNamespace(gear_ratio=RATIO)), runs=()))
    monkeypatch.setattr(secondary, "mismatches", lambda its: [])
    monkeypatch.setattr(secondary, "left_by_simulation", lambda its, left: ())
    monkeypatch.setattr(secondary, "left_and_fall", lambda its, left, rig: ((), fall))
    assert stands_in_simulations(case, trial(150.0, place)) is stands
