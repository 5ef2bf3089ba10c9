"""What no rig does, as detectors: blows of what slips, levels, another gain, steps and jumps, a sweep."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, fault_in_frequency, fault_in_time, in_words
from torquerig.recordings.repair.gain_changes import GainMoment, gain_moments, with_one_gain
from torquerig.recordings.repair.mean_steps import MeanStep, edges, mean_steps, without_steps
from torquerig.recordings.repair.moments import Moments, seams
from torquerig.recordings.repair.sample_jumps import sample_jumps
from torquerig.recordings.repair.slips import slips
from torquerig.recordings.repair.slips_removed import moments_of_slips, slips_told, without_slips
from torquerig.recordings.repair.sweep_course import Sweep, without_sweep
from torquerig.recordings.repair.sweeps import sweep_along, sweeps_in
from torquerig.recordings.repair.telegraph_noise import Telegraph, telegraph_noise, without_telegraph

_TAKEN_OUT = "the rest was judged with the steps taken out"
_LEFT_IN = "there are too many of them to put the rest right"
_FEWEST_JUMPS = 3  # of a sample, in one recording: one may be a switch of the load, and passes
_FEW_STEPS = 3  # of a recording: a mean that steps to and fro is not put right by taking out those that are seen


def without_strikes(seen: Examination) -> Examination:
    """Bridge the blows of what slips under load and grips again."""
    struck = slips(seen.recordings)
    recordings, lost = without_slips(seen.recordings, seen.lost, struck)
    found = replace(seen, recordings=tuple(recordings), lost=tuple(lost), struck=moments_of_slips(struck))
    return found.with_faults(*slips_told(recordings, struck))


def one_level(seen: Examination) -> Examination:
    """Remove telegraph noise."""
    levels = telegraph_noise(seen.recordings, seen.lost, resolution=2 * seen.resolution)
    told = [_telegraph(each, own) for each, own in zip(seen.recordings, levels, strict=True) if own is not None]
    level = without_telegraph(seen.recordings, levels)
    lost = tuple([*some, *more] for some, more in zip(seen.lost, level.moments, strict=True))
    stepping = seen.stepping or any(level.to_the_other)
    return replace(
        seen, recordings=level.recordings, lost=lost, to_the_other=level.to_the_other, stepping=stepping
    ).with_faults(*told)


def one_gain(seen: Examination) -> Examination:
    """Scale moments of another gain back."""
    answer, told = list(seen.recordings), list[Fault]()
    for index, (recording, moments) in enumerate(zip(seen.recordings, seen.lost, strict=True)):
        gains = () if recording.name in seen.standing else gain_moments(recording, without=moments)
        if gains:
            answer[index] = with_one_gain(recording, gains)
            told.append(_gain_change(recording, gains))
    return replace(seen, recordings=tuple(answer)).with_faults(*told)


def without_steps_and_jumps(seen: Examination) -> Examination:
    """Remove steps of the mean where they are few, and bridge jumps from one sample to the next."""
    answer = list(seen.recordings)
    steps_of_each = mean_steps(answer, seen.lost, resolution=seen.resolution)
    free = [not steps and each.name not in seen.standing for each, steps in zip(answer, steps_of_each, strict=True)]
    jumps = [
        _jumps_of(recording, moments, resolution=2 * seen.resolution) if may else []
        for recording, moments, may in zip(answer, seen.lost, free, strict=True)
    ]
    told = [_jumping_values(recording, own) for recording, own in zip(answer, jumps, strict=True) if own]
    lost = [[*some, *seams(own, each)] for some, own, each in zip(seen.lost, jumps, answer, strict=True)]
    few = max(map(len, steps_of_each), default=0) <= _FEW_STEPS
    for index, steps in enumerate(steps_of_each):
        if steps:
            told.append(_stepping(answer[index], steps, taken_out=few))
        if steps and few:
            lost[index] += edges(answer[index], steps)
            answer[index] = without_steps(answer[index], steps)
    stepping = seen.stepping or any(steps_of_each)
    return replace(seen, recordings=tuple(answer), lost=tuple(lost), stepping=stepping).with_faults(*told)


def without_sweeps(seen: Examination) -> Examination:
    """Remove lines that sweep while the speed is steady, and the same from runs whose speed changes."""
    answer, told = list(seen.recordings), list[Fault]()
    volts = [(each.torque_values(), each.sample_rate) for each in answer]
    steady = [index for index, each in enumerate(answer) if each.run.profile == "steady"]
    sweeps = dict(zip(steady, sweeps_in([volts[index] for index in steady]), strict=True))
    known = [sweep for sweep in sweeps.values() if sweep is not None]
    swept = tuple((min(sweep.start, sweep.stop), max(sweep.start, sweep.stop)) for sweep in known)
    for index, recording in enumerate(answer):
        sweep = sweeps[index] if index in sweeps else sweep_along(*volts[index], known)
        if sweep is not None:
            answer[index] = recording.with_values(recording.torque_name(), without_sweep(*volts[index], sweep))
            told.append(_sweeping(recording, sweep))
    return replace(seen, recordings=tuple(answer), swept=swept).with_faults(*told)


def _telegraph(recording: Recording, own: Telegraph) -> Fault:
    rate, unit = recording.sample_rate, recording.channels[recording.torque_name()].si_per_unit
    sentence = (
        f"{recording.name}: at {in_words([at / rate for at in own.jumps])} the signal jumps to and fro between two "
        f"levels {own.height * unit:.3g} N m apart, within {_samples(own.lag)}; no torque does that, random telegraph "
        "(burst) noise of an amplifier or a loose contact does, and no mechanism of the library: the rest was judged "
        "at one level"
    )
    stop = own.jumps[1] if len(own.jumps) > 1 else recording.samples
    return fault_in_time(recording, sentence, own.jumps[0], stop, excess=20 * float(np.log10(own.clear)))


def _samples(count: int) -> str:
    return "a sample" if count == 1 else f"{count} samples"


def _gain_change(recording: Recording, moments: Sequence[GainMoment]) -> Fault:
    rate, factor = recording.sample_rate, float(np.median([each.factor for each in moments]))
    length = max(each.stop - each.start for each in moments) / rate
    sentence = (
        f"{recording.name}: at {in_words([each.start / rate for each in moments])} all of the signal, noise too, is "
        f"{factor:.3g} times as large, for up to {length:.3g} s; that is a gain which changes, and no mechanism of the "
        "library does that: the rest was judged with these moments scaled back"
    )
    return fault_in_time(recording, sentence, moments[0].start, moments[0].stop, excess=20 * float(np.log10(factor)))


def _jumps_of(recording: Recording, lost: Moments, *, resolution: float) -> list[int]:
    """Return the first samples after a jump, none where there are so few that a load may have switched."""
    jumps = sample_jumps(recording.torque_values(), lost, resolution=resolution).tolist()
    return jumps if len(jumps) >= _FEWEST_JUMPS else []


def _jumping_values(recording: Recording, jumps: Sequence[int]) -> Fault:
    volts, unit = recording.torque_values(), recording.channels[recording.torque_name()].si_per_unit
    heights = np.abs(np.diff(volts))[np.array(jumps) - 1]
    sentence = (
        f"{recording.name}: at {in_words([at / recording.sample_rate for at in jumps])} the signal jumps by up to "
        f"{float(heights.max()) * unit:.3g} N m from one sample to the next, and is smooth before and after; no torque "
        "does that, a gain or a zero that changes or lost samples do, and no mechanism of the library: the rest was "
        "judged with the jumps bridged"
    )
    return fault_in_time(recording, sentence, jumps[0], jumps[0] + 1, excess=0.0)


def _stepping(recording: Recording, steps: Sequence[MeanStep], *, taken_out: bool) -> Fault:
    rate, unit = recording.sample_rate, recording.channels[recording.torque_name()].si_per_unit
    largest = max(steps, key=lambda each: abs(each.height))
    sentence = (
        f"{recording.name}: at {in_words([each.sample / rate for each in steps])} the mean torque steps by up to "
        f"{abs(largest.height) * unit:.3g} N m within some milliseconds and stays there; a load that changes or a zero "
        f"that jumps does that, no mechanism of the library: {_TAKEN_OUT if taken_out else _LEFT_IN}"
    )
    start = steps[0].sample
    stop = steps[1].sample if len(steps) > 1 else recording.samples
    return fault_in_time(recording, sentence, start, stop, excess=20 * float(np.log10(largest.clear)))


def _sweeping(recording: Recording, sweep: Sweep) -> Fault:
    sentence = (
        f"{recording.name}: a line sweeps from {sweep.start:.5g} to {sweep.stop:.5g} Hz over the run, and nothing "
        "does that at a steady speed; no mechanism of the library does it either: the rest was judged without it"
    )
    middle, width = 0.5 * (sweep.start + sweep.stop), abs(sweep.stop - sweep.start)
    return fault_in_frequency(recording, sentence, middle, width=width, excess=20 * float(np.log10(sweep.clear)))
