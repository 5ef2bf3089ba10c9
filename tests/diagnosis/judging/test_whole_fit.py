"""Where a model that fits nowhere quite, and nowhere badly, is worst."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.diagnosis.judging import whole_fit
from torquerig.diagnosis.judging.whole_fit import misfit_as_a_whole
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.scenario.model import Scenario

RATE = 5000.0


def test_the_worst_kind_of_the_worst_run_is_told(by_hand: Callable[..., Observed], wear_rig: Scenario) -> None:
    time = np.arange(int(6 * RATE)) / RATE
    noise = np.random.default_rng(1).standard_normal(time.size)
    seen = tuple(features(by_hand(noise, 100 * time, rate=RATE, name=name), []) for name in ("one", "two"))
    size, none = seen[0].band.size, np.zeros(0)
    good = Misfit(np.full(size, 1.0), none, np.full(16, 0.8))
    bad = Misfit(np.full(size, 2.0), none, np.full(16, 3.0))
    model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), (good, bad), 0.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=seen, model=model, left=())
    (told,) = misfit_as_a_whole(case, (), held_out=3.0)
    assert (told.recordings, told.domain, told.axis) == (("two",), "speed", "rpm")
    assert abs(told.at - 100 * 30 / pi) < 1.0
    assert told.p_value < 1e-9
    assert 6.0 < told.excess_dB < 10.0
    assert misfit_as_a_whole(case, (), held_out=0.9) == ()


@pytest.mark.parametrize(("held_out", "told"), [(1.3, False), (9.0, True)])
def test_bad_luck_in_what_no_fit_has_seen_is_no_place(
    held_out: float, *, told: bool, by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    """A little of it; so far beyond what a true model reaches is none."""
    time = np.arange(int(6 * RATE)) / RATE
    noise = np.random.default_rng(1).standard_normal(time.size)
    seen = (features(by_hand(noise, 100 * time, rate=RATE, name="one"), []),)
    none = np.zeros(0)
    good = Misfit(np.full(seen[0].band.size, 1.0), none, np.full(16, 0.8))
    model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), (good,), 0.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=seen, model=model, left=())
    assert bool(misfit_as_a_whole(case, (), held_out=held_out)) == told


@pytest.mark.parametrize(("unseen", "told"), [(1.1, True), (0.7, False)])
def test_what_is_missed_everywhere_stands_out_nowhere(
    unseen: float, *, told: bool, by_hand: Callable[..., Observed], wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A shaft that hardens moves every band a little: more than chance in what was seen, and in what was not."""
    time = np.arange(int(6 * RATE)) / RATE
    noise = np.random.default_rng(1).standard_normal(time.size)
    seen = (features(by_hand(noise, 100 * time, rate=RATE, name="one"), []),)
    none = np.zeros(0)

    def missed(by: float) -> Misfit:
        return Misfit(np.full(seen[0].band.size, by), none, np.full(16, 1.5))

    model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), (missed(1.4),), 0.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=seen, model=model, left=())
    monkeypatch.setattr(whole_fit, "misfits_of", lambda rig, held: (missed(unseen),))
    assert bool(misfit_as_a_whole(case, seen, held_out=0.9)) is told
