"""What no rig does, in words and as places: samples written twice, jumps, levels, another gain, steps, a sweep."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.looking.angle_jumps import angle_jumps
from torquerig.diagnose.looking.copied import copied
from torquerig.diagnose.looking.gain_moments import GainMoment, gain_moments, with_one_gain
from torquerig.diagnose.looking.mean_steps import MeanStep, edges, mean_steps, without_steps
from torquerig.diagnose.looking.refilled import Moments
from torquerig.diagnose.looking.sample_jumps import sample_jumps
from torquerig.diagnose.looking.sweep_course import Sweep, without_sweep
from torquerig.diagnose.looking.sweeps import sweep_along, sweeps_in
from torquerig.diagnose.looking.telegraph_noise import Telegraph, telegraph_noise, without_telegraph
from torquerig.signals.recording import Recording

Untrue = tuple[str, Mismatch]

_TOLD = 4  # moments of a recording that are told
_TAKEN_OUT = "the rest was judged with the steps taken out"
_LEFT_IN = "there are too many of them to put the rest right"
_FEWEST_JUMPS = 3  # of a sample, in one recording: one may be a switch of the load, and passes
_FEW_STEPS = 3  # of a recording: a mean that steps to and fro is not put right by taking out those that are seen


@dataclass(frozen=True)
class Mended:
    """Recordings without what no rig does, the lost moments of each, and what was told of them.

    ``stepping`` is whether the mean torque of one steps, ``swept`` the frequencies [Hz], lowest and highest, over which
    a line swept that was taken out, ``to_the_other`` what leads each recording to the other level of its telegraph
    noise [V].
    """

    recordings: tuple[Recording, ...]
    lost: tuple[Moments, ...]
    told: tuple[Untrue, ...]
    stepping: bool
    swept: tuple[tuple[float, float], ...]
    to_the_other: tuple[float, ...]


def repeated(recordings: Sequence[Recording]) -> Iterator[Untrue]:
    """Yield a sentence and a place for each recording that holds samples twice."""
    for recording in recordings:
        found, rate = copied(recording), recording.sample_rate
        if not found:
            continue
        length = max(each.stop - each.start for each in found) / rate
        sentence = (
            f"{recording.name}: at {_moments([each.start / rate for each in found])} samples repeat earlier ones "
            f"exactly, for up to {1e3 * length:.3g} ms; the logger wrote them twice, so its time base cannot be trusted"
        )
        yield sentence, _place(recording, found[0].start, found[0].stop, excess=0.0)


def jumping(recordings: Sequence[Recording]) -> Iterator[Untrue]:
    """Yield a sentence and a place for each recording whose measured angle jumps."""
    for recording in recordings:
        found, rate = angle_jumps(recording), recording.sample_rate
        if found:
            furthest = max(abs(each.turn) for each in found) / (2 * np.pi)
            sentence = (
                f"{recording.name}: at {_moments([each.start / rate for each in found])} the channel "
                f"{found[0].channel} jumps by up to {furthest:.2g} turns from one sample to the next, and no shaft "
                "does; samples or counts were lost or written twice, so its time base cannot be trusted"
            )
            yield sentence, _place(recording, found[0].start, found[0].start + 1, excess=0.0)


def without_untrue(
    recordings: Sequence[Recording], lost: Sequence[Moments], *, standing: Collection[str], resolution: float = 0.0
) -> Mended:
    """Return the recordings at one level and gain, without steps and sweeping lines, what is lost, and what was told.

    Parameters
    ----------
    recordings : sequence of Recording
        Moments without signal bridged.
    lost : sequence of Moments
        Those moments.
    standing : collection of str
        Recordings with flat tops or coarse codes: where their signal stands still, that is no gain.
    resolution : float
        Half a code [V], 0 where it is not known.
    """
    levels = telegraph_noise(recordings, lost, resolution=2 * resolution)
    told = [_telegraph(each, own) for each, own in zip(recordings, levels, strict=True) if own is not None]
    level = without_telegraph(recordings, levels)
    answer, lost = list(level.recordings), [[*some, *more] for some, more in zip(lost, level.moments, strict=True)]
    for index, (recording, moments) in enumerate(zip(level.recordings, lost, strict=True)):
        gains = () if recording.name in standing else gain_moments(recording, without=moments)
        if gains:
            answer[index] = with_one_gain(recording, gains)
            told.append(_gain_change(recording, gains))
    moments_of_each, steps_of_each = list(lost), mean_steps(answer, lost, resolution=resolution)
    for recording, moments, steps in zip(answer, lost, steps_of_each, strict=True):
        if not steps and recording.name not in standing:
            told += _jumping_values(recording, moments, resolution=2 * resolution)
    few = max(map(len, steps_of_each), default=0) <= _FEW_STEPS
    for index, steps in enumerate(steps_of_each):
        if steps:
            told.append(_stepping(answer[index], steps, taken_out=few))
        if steps and few:
            moments_of_each[index] = [*lost[index], *edges(answer[index], steps)]
            answer[index] = without_steps(answer[index], steps)
    volts = [(each.channels[each.torque_name()].values, each.sample_rate) for each in answer]
    steady = [index for index, each in enumerate(answer) if each.run.profile == "steady"]
    sweeps = dict(zip(steady, sweeps_in([volts[index] for index in steady]), strict=True))
    known = [sweep for sweep in sweeps.values() if sweep is not None]
    swept = tuple((min(sweep.start, sweep.stop), max(sweep.start, sweep.stop)) for sweep in known)
    for index, recording in enumerate(answer):
        sweep = sweeps[index] if index in sweeps else sweep_along(*volts[index], known)
        if sweep is not None:
            answer[index] = recording.with_values(recording.torque_name(), without_sweep(*volts[index], sweep))
            told.append(_sweeping(recording, sweep))
    return Mended(
        tuple(answer), tuple(moments_of_each), tuple(told), stepping=any(steps_of_each), swept=swept,
        to_the_other=level.to_the_other,
    )  # fmt: skip


def _telegraph(recording: Recording, own: Telegraph) -> Untrue:
    rate, unit = recording.sample_rate, recording.channels[recording.torque_name()].si_per_unit
    sentence = (
        f"{recording.name}: at {_moments([at / rate for at in own.jumps])} the signal jumps to and fro between two "
        f"levels {own.height * unit:.3g} N m apart, within {_samples(own.lag)}; no torque does that, random telegraph "
        "(burst) noise of an amplifier or a loose contact does, and no mechanism of the library: the rest was judged "
        "at one level"
    )
    stop = own.jumps[1] if len(own.jumps) > 1 else recording.samples
    return sentence, _place(recording, own.jumps[0], stop, excess=20 * float(np.log10(own.clear)))


def _samples(count: int) -> str:
    return "a sample" if count == 1 else f"{count} samples"


def _gain_change(recording: Recording, moments: Sequence[GainMoment]) -> Untrue:
    rate, factor = recording.sample_rate, float(np.median([each.factor for each in moments]))
    length = max(each.stop - each.start for each in moments) / rate
    sentence = (
        f"{recording.name}: at {_moments([each.start / rate for each in moments])} all of the signal, noise too, is "
        f"{factor:.3g} times as large, for up to {length:.3g} s; that is a gain which changes, and no mechanism of the "
        "library does that: the rest was judged with these moments scaled back"
    )
    return sentence, _place(recording, moments[0].start, moments[0].stop, excess=20 * float(np.log10(factor)))


def _jumping_values(recording: Recording, lost: Moments, *, resolution: float) -> Iterator[Untrue]:
    rate, channel = recording.sample_rate, recording.channels[recording.torque_name()]
    jumps = sample_jumps(channel.values, lost, resolution=resolution)
    if jumps.size < _FEWEST_JUMPS:
        return
    heights = np.abs(channel.values[jumps] - channel.values[jumps - 1])
    sentence = (
        f"{recording.name}: at {_moments((jumps / rate).tolist())} the signal jumps by up to "
        f"{float(heights.max()) * channel.si_per_unit:.3g} N m from one sample to the next, and is smooth before and "
        "after; no torque does that, a gain or a zero that changes or lost samples do, and no mechanism of the "
        "library: the rest was judged with the jumps in it"
    )
    yield sentence, _place(recording, int(jumps[0]), int(jumps[0]) + 1, excess=0.0)


def _stepping(recording: Recording, steps: Sequence[MeanStep], *, taken_out: bool) -> Untrue:
    rate, unit = recording.sample_rate, recording.channels[recording.torque_name()].si_per_unit
    largest = max(steps, key=lambda each: abs(each.height))
    sentence = (
        f"{recording.name}: at {_moments([each.sample / rate for each in steps])} the mean torque steps by up to "
        f"{abs(largest.height) * unit:.3g} N m within some milliseconds and stays there; a load that changes or a zero "
        f"that jumps does that, no mechanism of the library: {_TAKEN_OUT if taken_out else _LEFT_IN}"
    )
    start = steps[0].sample
    stop = steps[1].sample if len(steps) > 1 else recording.samples
    return sentence, _place(recording, start, stop, excess=20 * float(np.log10(largest.clear)))


def _sweeping(recording: Recording, sweep: Sweep) -> Untrue:
    sentence = (
        f"{recording.name}: a line sweeps from {sweep.start:.5g} to {sweep.stop:.5g} Hz over the run, and nothing "
        "does that at a steady speed; no mechanism of the library does it either: the rest was judged without it"
    )
    return sentence, Mismatch(
        domain="frequency", axis="Hz", at=0.5 * (sweep.start + sweep.stop), width=abs(sweep.stop - sweep.start),
        recordings=(recording.name,), excess_dB=20 * float(np.log10(sweep.clear)), share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip


def _moments(starts: Sequence[float]) -> str:
    return f"{', '.join(f'{start:.4g}' for start in starts[:_TOLD])} s{' and later' if len(starts) > _TOLD else ''}"


def _place(recording: Recording, start: int, stop: int, *, excess: float) -> Mismatch:
    return Mismatch(
        domain="time", axis="s", at=start / recording.sample_rate, width=(stop - start) / recording.sample_rate,
        recordings=(recording.name,), excess_dB=excess, share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip
