"""A chain block by block is the chain on the whole recording, to within what its reach says."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.filters.block_filtering import blocking_for, filtered_blocks
from torquerig.filters.butterworth import ButterworthLowPass
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import chain_effect
from torquerig.filters.harmonic_regression import HarmonicRegression
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.joined_effect import joined_effect
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.filters.reach import reach_of
from torquerig.filters.revolution_mean import RevolutionMean
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.files import open_stream, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.recordings.stage import Stage

RATE, SECONDS, SPEED = 500.0, 240.0, 2 * np.pi * 10
LINES = Kinematics(ratio=5.0).lines(3)


def recording() -> Recording:
    rng = np.random.default_rng(4)
    count = int(RATE * SECONDS)
    angle = np.cumsum(SPEED * (1 + 0.003 * np.sin(np.arange(count) / RATE))) / RATE
    load = 1 + 0.2 * np.sin(2 * np.pi * 0.05 * np.arange(count) / RATE)
    torque = load + np.sin(angle) + 0.3 * np.cos(2 * angle / 5) + 0.05 * rng.standard_normal(count)
    return Recording(
        sample_rate=RATE,
        channels={
            "torque_V": Channel(values=torque, quantity="torque", unit="V"),
            "angle_rad": Channel(values=angle, quantity="motor_angle", unit="rad"),
        },
        run=Run(speed=SPEED, gear_ratio=5.0),
        name="made",
    )


def low_pass() -> ButterworthLowPass:
    return ButterworthLowPass(cutoff=5.0)


# what a block may differ from the whole by, of a torque of 1 N m: the tail of the answer beyond the reach, or for the
# regression the scatter of amplitudes that are fitted on blocks that start elsewhere (0.05 N m of noise, 2 s of it)
STAGES: dict[str, tuple[Stage, float]] = {
    "low-pass": (low_pass(), 1e-8),
    "revolution mean": (RevolutionMean(ratio=5.0), 3e-3),
    "moving mean": (MovingMeanKept(samples=100, around=(low_pass(),)), 1e-8),
    "band-stop": (IdealBandstop(lines=LINES[:1], half_width=0.5), 1e-2),
    "regression": (HarmonicRegression(lines=LINES, block=2.0), 2e-2),
}


@pytest.mark.parametrize("name", STAGES)
def test_blocks_give_what_the_whole_gives(tmp_path: Path, name: str) -> None:
    made, (stage, tolerance) = recording(), STAGES[name]
    write_recording(made, tmp_path / "run1.parquet")
    stream = open_stream(tmp_path / "run1.parquet")
    chain = Chain(name="one", stages=(stage,))
    blocking = blocking_for([chain], stream, block=30.0)
    blocks = list(filtered_blocks([chain], stream, blocking, ratio=5.0))
    assert len(blocks) > 3
    joint = np.concatenate([block.after[0].torque() for block in blocks])
    whole = chain.apply(made).torque()
    # the ends of the record are the business of the stage: a brick wall wraps around there
    inside = slice(blocking.overlap, -blocking.overlap)
    assert np.abs(joint - whole)[inside].max() < tolerance
    assert np.array_equal(np.concatenate([block.before.torque() for block in blocks]), made.torque())


def test_the_effect_of_the_blocks_is_that_of_the_whole() -> None:
    before = recording()
    chain = Chain(name="one", stages=(IdealBandstop(lines=LINES[:1]),))
    after = chain.apply(before)
    whole = chain_effect(before, after, ratio=5.0, lines=chain.lines)
    cuts = [(0, 40000), (40000, 100000), (100000, before.samples)]
    pieces = [
        [replace(one, channels={name: replace(c, values=c.values[low:high]) for name, c in one.channels.items()})
         for one in (before, after)]
        for low, high in cuts
    ]  # fmt: skip
    effects = [chain_effect(first, last, ratio=5.0, lines=chain.lines) for first, last in pieces]
    joint = joined_effect(effects, [high - low for low, high in cuts])
    for field in ("std_before", "std_after", "mean_before", "mean_after"):
        assert getattr(joint, field) == pytest.approx(getattr(whole, field), rel=1e-12)
    # one step of the trapezium at each cut is missing
    assert joint.energy_before == pytest.approx(whole.energy_before, rel=1e-4)
    # the wandering line spreads over the band in either case
    assert joint.levels[0].before == pytest.approx(whole.levels[0].before, rel=0.05)


@dataclass(frozen=True)
class _Whole:
    """Says nothing of its reach."""

    def apply(self, recording: Recording) -> Recording:
        return recording


@dataclass(frozen=True)
class _Told(_Whole):
    """Says how far it looks."""

    def reach(self, head: Recording) -> float:
        return 3.0 / head.sample_rate


def test_a_stage_tells_its_reach_and_reaches_add_up() -> None:
    chain = Chain(name="two", stages=(_Told(), _Told()))
    assert reach_of(chain, recording()) == pytest.approx(6.0 / RATE)
    with pytest.raises(RecordingError, match="_Whole needs the whole recording at once and cannot work in blocks"):
        reach_of(Chain(name="one", stages=(_Whole(),)), recording())


def test_a_ramp_is_not_cut_into_blocks(tmp_path: Path) -> None:
    made = recording()
    write_recording(replace(made, run=replace(made.run, profile="ramp")), tmp_path / "run1.parquet")
    with pytest.raises(RecordingError, match="a ramp cannot be filtered block by block"):
        blocking_for([Chain(name="none", stages=())], open_stream(tmp_path / "run1.parquet"))
