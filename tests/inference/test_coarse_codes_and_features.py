"""Codes that are coarse for their signal: blocks that stay on one are not compared, and their noise is not white."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.errors import InputError
from torquerig.inference.engine import features_of, with_held_out
from torquerig.inference.features.run_features import run_features
from torquerig.inference.prediction.measuring_chain import rounding_error
from torquerig.inference.sample_faults import on_few_codes, usable_runs
from torquerig.sensor_stages.noise import WhiteNoise
from torquerig.sensor_stages.rounding import Rounding

RATE, STEP = 2000.0, 0.2


class Chain:
    """What ``rounding_error`` asks of a rig."""

    def __init__(self, noise):
        self.noise = noise

    def stages(self):
        return (WhiteNoise(rms=self.noise), Rounding(step=STEP))


def rounded(run):
    return replace(run, torque=STEP * np.round(run.torque / STEP))


def no_flags(runs):
    return [np.zeros(run.torque.size, dtype=bool) for run in runs]


def test_blocks_on_one_code_are_left_out():
    quiet, moving = (rounded(drawn_run(1, speed=steady(1000), noise=noise)) for noise in (0.01, 0.3))
    half = quiet.torque.size // 2
    both = replace(moving, torque=np.concatenate([quiet.torque[:half], moving.torque[half:]]))
    (usable,), judged = usable_runs([both], no_flags([both]), step=STEP)
    assert judged
    assert min(block.start for block in usable.blocks) >= half - 1.1 * RATE
    assert len(usable.blocks) >= len(both.blocks) // 2 - 1
    assert usable_runs([both], no_flags([both]))[0][0].blocks == both.blocks


def test_a_recording_of_one_code_keeps_its_blocks():
    quiet = rounded(drawn_run(1, speed=steady(1000), noise=0.01))
    (usable,), judged = usable_runs([quiet], no_flags([quiet]), step=STEP)
    assert judged
    assert usable.blocks == quiet.blocks


@pytest.mark.parametrize("noise", [0.02, 0.04, 0.06])
def test_the_error_that_is_not_white_is_what_rounding_shows(noise):
    # a slow signal over many codes: without noise its error has little at high frequencies
    rng = np.random.default_rng(1)
    slow = np.cumsum(rng.standard_normal(200_000)) * 0.002
    signal = slow + noise * rng.standard_normal(slow.size)
    error = STEP * np.round(signal / STEP) - signal
    lag = 1
    shared = float(np.mean(error[lag:] * error[:-lag])) / (STEP**2 / 12)
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    density = np.full((1, seen.bands.low.size), STEP**2 / 12 / (0.5 * RATE))
    share = rounding_error(Chain(noise), seen, density)[0, 0] / rounding_error(Chain(0.0), seen, density)[0, 0]
    assert share == pytest.approx(np.exp(-((2 * pi * noise / STEP) ** 2)))
    assert shared == pytest.approx(6 / pi**2 * share, abs=0.05)  # of the harmonics of the error the first one remains


def test_a_run_that_is_left_out_whole_does_not_stop_the_others():
    quiet, moving = (rounded(drawn_run(1, speed=steady(1000), noise=noise)) for noise in (0.01, 0.3))
    usable, judged = usable_runs([quiet, moving], no_flags([quiet, moving]), step=STEP)
    assert judged
    assert not usable[0].blocks
    data = features_of(usable, [])
    assert [seen.run.blocks for seen in data.seen] == [usable[1].blocks]


def test_what_is_left_out_is_stated():
    quiet, moving = (rounded(drawn_run(1, speed=steady(1000), noise=noise)) for noise in (0.01, 0.3))
    usable, _ = usable_runs([quiet, moving], no_flags([quiet, moving]), step=STEP)
    (sentence,) = on_few_codes(usable, step=STEP)
    assert sentence.startswith("run1: 12 s of 12 s move by less than half a step of the codes (0.2 V)")
    assert not on_few_codes([quiet, moving], step=STEP), "nothing was left out"


def test_a_recording_of_which_nothing_is_compared_cannot_be_held_out():
    quiet, moving = (
        rounded(drawn_run(1, speed=steady(1000), noise=noise, name=name)) for noise, name in ((0.01, "a"), (0.3, "b"))
    )
    usable, _ = usable_runs([quiet, moving], no_flags([quiet, moving]), step=STEP)
    with pytest.raises(InputError, match=r"nothing of a can be compared.*; leave the option out"):
        with_held_out(usable, ["a"])
    with pytest.raises(InputError, match="nothing of the others than b can be compared"):
        with_held_out(usable, ["b"])
    other = replace(moving, recording=replace(moving.recording, name="c"))
    with pytest.raises(InputError, match="hold out one of b, c"):
        with_held_out([*usable, other], ["a"])
    assert {block.held_out for block in with_held_out([*usable, other], ["c"])[2].blocks} == {True}
