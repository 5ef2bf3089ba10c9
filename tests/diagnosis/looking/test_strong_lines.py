"""What the angle of a shaft without encoder must be followed by, and what must not pull it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis import opening
from torquerig.diagnosis.looking.lines_left import Strong, lines_left, strong_lines
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.mechanisms import BladePass, MainsInterference
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

RATE, LENGTH, TONE, ORDER = 5000.0, 12.0, 49.98, 13.4
TIME = np.arange(int(RATE * LENGTH)) / RATE


@pytest.mark.parametrize("measured", [True, False])
def test_strong_orders_and_tones_that_the_rig_lacks(
    measured: bool, by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    def run(speed: float, seed: int) -> Observed:
        lines = 0.2 * np.cos(2 * pi * TONE * TIME) + 0.2 * np.cos(ORDER * speed * TIME)
        noise = 0.02 * np.random.default_rng(seed).standard_normal(TIME.size)
        return by_hand(1.0 + lines + noise, speed * TIME, name=f"{speed:g}", measured=measured)

    strong = strong_lines([run(100.0, 1), run(70.0, 2)], wear_rig.rig)
    if measured:
        assert strong.orders == strong.tones == ()
    else:
        assert strong.orders == pytest.approx((ORDER,), abs=0.01)
        assert strong.tones == pytest.approx((TONE,), abs=0.03)


def test_a_line_of_one_of_several_speeds_is_not_followed(by_hand: Callable[..., Observed], wear_rig: Scenario) -> None:
    def run(speed: float, seed: int, *, line: float) -> Observed:
        noise = 0.02 * np.random.default_rng(seed).standard_normal(TIME.size)
        return by_hand(
            1.0 + line * np.cos(ORDER * speed * TIME) + noise, speed * TIME, name=f"{speed:g}", measured=False
        )

    strong = strong_lines([run(100.0, 1, line=0.2), run(70.0, 2, line=0.0)], wear_rig.rig)
    assert strong == Strong()


def test_a_hum_beside_an_order_does_not_swing_the_angle(wear_rig: Scenario, record: Callable[..., Recording]) -> None:
    """At 994 rpm order 3 is 0.3 Hz below a hum, which beats with it; the angle does not follow the beat."""
    hum = MainsInterference(name="hum", frequency=TONE, amplitudes=(0.5,))
    full = record(wear_rig.rig + hum, 3, rpm=990.0, duration=12.0)
    torque = {name: one for name, one in full.channels.items() if one.quantity == "torque"}
    blind = replace(full, channels=torque)
    (true,) = shaft_angles([full], wear_rig.rig)

    def swing(recording: Recording) -> float:
        (angle,) = shaft_angles([recording], wear_rig.rig)
        apart = angle.values - true.values
        return float(np.std(apart - np.polyval(np.polyfit(TIME, apart, 1), TIME)))

    assert true.measured
    # an angle that followed the beat would swing by more
    assert swing(blind) < 0.02
    assert swing(opening._less(blind, [TONE])) < 0.02


@pytest.mark.long
def test_at_one_speed_an_order_counts_where_the_wander_tells_it(
    wear_rig: Scenario, record: Callable[..., Recording]
) -> None:
    """Blades swing the shaft within each turn, and cogging stands on the angle as it swings."""
    bladed = wear_rig.rig + BladePass(name="blades", order_output=9.0, amplitude=0.8)
    runs = [record(bladed, seed, duration=12.0, occupancy=occupancy) for seed, occupancy in ((3, 5.0), (4, 11.0))]
    blind = [
        replace(run, channels={name: one for name, one in run.channels.items() if one.quantity == "torque"})
        for run in runs
    ]
    (true, _) = shaft_angles(runs, wear_rig.rig)
    strong = strong_lines(opening._runs(blind, blind, wear_rig.rig, Strong()), wear_rig.rig)
    assert [each for each in strong.orders if each == pytest.approx(1.8, abs=1e-3)]
    assert not strong.tones

    def swing(also: tuple[float, ...]) -> float:
        (angle, _) = shaft_angles(blind, wear_rig.rig, also=also)
        apart = angle.values - true.values
        apart = apart - np.polyval(np.polyfit(TIME, apart, 2), TIME)
        return float(np.abs(np.mean(apart * np.hanning(apart.size) * np.exp(-1j * 1.8 * true.values))))

    assert swing(strong.orders) < 0.3 * swing(())


@pytest.mark.parametrize(("tone", "domain"), [(2440.0, "frequency"), (1000.0, "order")])
def test_a_tone_that_no_order_could_be_seen_at_stays_one(
    tone: float, domain: str, by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    """At one speed that nobody measured any tone is near a whole order; near half the sample rate none is seen."""
    time = np.arange(60_000) / RATE
    noise = 0.02 * np.random.default_rng(1).standard_normal(time.size)
    run = by_hand(1.0 + 0.2 * np.cos(2 * pi * tone * time) + noise, 100.0 * time, measured=False)
    (peak,) = lines_left([run], (), rig=wear_rig.rig)
    assert peak.place.domain == domain
    assert peak.place.frequency(100.0) == pytest.approx(tone, rel=0.02)


@pytest.mark.parametrize(("tone", "domain"), [(1000.0, "order"), (4000.0, "frequency")])
def test_a_tone_among_many_whole_orders_keeps_its_frequency(
    tone: float, domain: str, by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    """At 250 times the speed seven whole orders of the output lie within what an unmeasured speed may be off."""
    rate = 25_000.0
    time = np.arange(150_000) / rate
    noise = 0.02 * np.random.default_rng(1).standard_normal(time.size)
    angle = 100.0 * time + 0.3 * np.sin(2 * pi * 0.4 * time)
    run = by_hand(1.0 + 0.2 * np.cos(2 * pi * tone * time) + noise, angle, rate=rate, measured=False)
    found = lines_left([run], (), rig=wear_rig.rig)
    assert found[0].place.domain == domain
    assert found[0].place.frequency(run.mean_speed) == pytest.approx(tone, rel=3e-3)


@pytest.mark.parametrize(("seed", "also"), [(4, (2.6, 5.2)), (5, (2.6,)), (6, (2.6, 5.2, 7.8))])
def test_strong_blades_do_not_lead_the_angle_astray(
    seed: int, also: tuple[float, ...], wear_rig: Scenario, record: Callable[..., Recording]
) -> None:
    """Their lines hide which factor of the comb fits best; along it the lines stand out all the same."""
    bladed = wear_rig.rig + BladePass(name="blades", order_output=13.0, amplitude=1.5)
    full = record(bladed, seed, rpm=440.0, duration=12.0)
    blind = replace(full, channels={name: one for name, one in full.channels.items() if one.quantity == "torque"})
    (true,) = shaft_angles([full], wear_rig.rig)
    (angle,) = shaft_angles([blind], wear_rig.rig, also=also)
    apart = angle.values - true.values
    assert float(np.std(apart - apart.mean())) < 0.1
