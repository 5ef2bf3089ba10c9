"""Faults of the samples as hypotheses: a limit, coarse codes, dropouts; each against samples of a continuous signal.

The detectors of ``recordings.repair`` propose a level, a step, or moments. Each is accepted by the likelihood of
held-out samples: how many of them are exactly on the level or on the steps, compared with how many a signal would leave
there that takes every code of the converter. What the moments hold is then repaired or left out, so that the features
are those of the torque.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf, log, sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.blocks import Block, blocks_of
from torquerig.inference.measured_run import MeasuredRun
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.coarse_codes import coarse_codes
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.repair.moments import bridged
from torquerig.recordings.repair.samples_at_limit import at_limit, rebuilt, too_long
from torquerig.recordings.repair.sharp_dropouts import Gap, dropouts_of, gaps
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.sensor_stages.rounding import Rounding

NAMES = ("clipping", "quantization", "signal_dropout")

LEAST = 8.0  # [nats] of posterior odds, as for every addition
_LOG_ODDS = -5.0  # of each of the three
_PARTS = 6  # of a recording, of which each third one is held out, as blocks are
_JUMP = 12.0  # [standard deviations of a step] that each edge of a dropout exceeds at least
_TAIL = 8.0  # degrees of freedom of Student's distribution, by which a single jump is judged
_SAME_SCALE = 0.05  # [1] relative: so near to the factor of a sensor codes are its converter's
_MOST_AT_LIMIT = 1e-3  # share of the samples of a block
_CROSSED = (
    0.5  # of the step of coarse codes: standard deviation of a signal whose rounding has the variance step^2 / 12
)
_NEAR = 0.25  # of the converter's step, within which a value is on a coarser one
_ASIDE = 1e-3  # probability of a value that is on none of the coarse codes
_TWO_SIDED = 1.96  # standard deviations of half a 95 % interval


@dataclass(frozen=True, eq=False)
class SampleFaults:
    """Recordings with the moments that hold no torque repaired, and what was found.

    Parameters
    ----------
    recordings : tuple of Recording
        Repaired.
    unusable : tuple of ndarray of bool, shape (samples,)
        By recording, which samples are at a limit where they are too many to be rebuilt.
    lost : tuple of ndarray of bool, shape (samples,)
        By recording, which samples hold no signal.
    additions : tuple of Addition
        Without parameters that are fitted.
    coarser : float
        Step of the codes over that of the converter [1]; 1 where they are the converter's.
    nameless : tuple of str
        Which of ``NAMES`` were found and are no mechanism of this library.
    """

    recordings: tuple[Recording, ...]
    unusable: tuple[NDArray[np.bool_], ...]
    lost: tuple[NDArray[np.bool_], ...]
    additions: tuple[Addition, ...]
    coarser: float = 1.0
    nameless: tuple[str, ...] = ()

    def without_scaled_codes(self, scales: Iterable[float]) -> tuple[Addition, ...]:
        """Return the faults without codes that are coarse because the reading has another scale than stated."""
        scaled = any(abs(self.coarser / abs(scale) - 1) < _SAME_SCALE for scale in scales)
        return tuple(each for each in self.additions if each.mechanism != "quantization" or not scaled)

    def added_to(self, rig: Rig) -> Rig:
        """Return the rig with the faults."""
        for each in self.additions:
            rig = each.added_to(rig)
        return rig


def sample_faults(recordings: Sequence[Recording], rig: Rig) -> SampleFaults:
    """Return what the samples of recordings of one rig show that the rig does not have."""
    full, step = converter_of(rig)
    found = dict[str, Addition]()
    coarse = None if rig.of_kind("quantization") else _codes(recordings, rig, step)
    if coarse is not None:
        found["quantization"] = coarse[0]
    code = step if coarse is None else coarse[1]
    lost = [gaps(each.torque_values(), each.sample_rate) for each in recordings]
    dropouts = None if rig.of_kind("signal_dropout") else _dropouts(recordings, rig, lost)
    if dropouts is not None:
        found["signal_dropout"] = dropouts
        recordings = [bridged(each, [gap[:2] for gap in own]) for each, own in zip(recordings, lost, strict=True)]
    limit = None if rig.of_kind("clipping") else _limit(recordings, rig, full, code, coarse=coarse is not None)
    unusable = tuple(np.zeros(each.samples, dtype=bool) for each in recordings)
    if limit is not None:
        found["clipping"] = limit[0]
        stuck = [at_limit(each, limit=limit[1]) for each in recordings]
        unusable = tuple(each if too_long(each) else np.zeros_like(each) for each in stuck)
        recordings = tuple(rebuilt(each, limit=limit[1]) for each in recordings)
    empty = tuple(
        covered(own if dropouts is not None else (), each.samples) for each, own in zip(recordings, lost, strict=True)
    )
    named = tuple(each for each in found.values() if each.is_named)
    nameless = tuple(name for name, each in found.items() if not each.is_named)
    return SampleFaults(tuple(recordings), unusable, empty, named, 1.0 if coarse is None else code / step, nameless)


def converter_of(rig: Rig) -> tuple[float, float]:
    """Return range and step of the compared sensor's converter [V]; infinity and 0 where it is not stated."""
    sensor = rig.part(rig.measured)
    if not isinstance(sensor, AmplifiedTorqueSensor):
        return inf, 0.0
    return sensor.converter_range, 2 * sensor.converter_range / 2**sensor.converter_bits


def covered(moments: Iterable[Gap], samples: int) -> NDArray[np.bool_]:
    """Return which of so many samples lie in the moments, shape (samples,)."""
    answer = np.zeros(samples, dtype=bool)
    for start, stop, _ in moments:
        answer[start:stop] = True
    return answer


def usable_runs(
    runs: Sequence[MeasuredRun], unusable: Sequence[NDArray[np.bool_]], *, step: float = 0.0
) -> tuple[tuple[MeasuredRun, ...], bool]:
    """Return the runs without blocks that show no torque, and whether enough are left.

    Such a block has too many samples at a limit, or moves by less than half a step of coarse codes [V]: what is rounded
    to one code or two has no spectrum (Widrow & Kollar 2008, Quantization Noise, 5). Where the rest cannot both be
    fitted and judge a fit, blocks of few codes stay, or all blocks are returned.
    """
    kept = _without_blocks(runs, [[flags[block.samples].mean() >= _MOST_AT_LIMIT for block in run.blocks]
                                  for run, flags in zip(runs, unusable, strict=True)])  # fmt: skip
    if not _can_be_judged(kept):
        return tuple(runs), False
    moving = _without_blocks(kept, [[_is_rounded_away(run, block, step) for block in run.blocks] for run in kept])
    return (moving if _can_be_judged(moving) else kept), True


def _without_blocks(runs: Sequence[MeasuredRun], without: Sequence[Sequence[bool]]) -> tuple[MeasuredRun, ...]:
    return tuple(
        replace(run, blocks=tuple(block for block, gone in zip(run.blocks, own, strict=True) if not gone))
        for run, own in zip(runs, without, strict=True)
    )


def _can_be_judged(runs: Sequence[MeasuredRun]) -> bool:
    return {block.held_out for run in runs for block in run.blocks} == {True, False}


def _is_rounded_away(run: MeasuredRun, block: Block, step: float) -> bool:
    recording = run.recording
    unit = abs(recording.channels[recording.torque_name()].si_per_unit)
    return float(np.std(run.torque[block.samples])) < _CROSSED * unit * step


def on_few_codes(runs: Sequence[MeasuredRun], *, step: float) -> tuple[str, ...]:
    """Return a sentence for each run of which blocks were left out because they move by less than half a step [V]."""
    answer = list[str]()
    for run in runs:
        kept = {block.start for block in run.blocks}
        gone = [
            block for block in blocks_of(run.speed) if block.start not in kept and _is_rounded_away(run, block, step)
        ]
        lost, whole = sum(block.stop - block.start for block in gone) / run.rate, run.torque.size / run.rate
        if gone:
            answer.append(
                f"{run.name}: {lost:.3g} s of {whole:.3g} s move by less than half a step of the codes "
                f"({step:.4g} V) and are not compared"
            )
    return tuple(answer)


def rounding_step(rig: Rig) -> float:
    """Return the step of the coarsest codes that a mechanism of a rig makes [V]; 0 where none does."""
    return max((stage.step for stage in rig.stages() if isinstance(stage, Rounding)), default=0.0)


def _codes(recordings: Sequence[Recording], rig: Rig, step: float) -> tuple[Addition, float] | None:
    """Return codes coarser than the converter's, and their step [V].

    Of k codes of the converter one is on the coarse ones: each different held-out value there weighs ``ln k``.
    """
    codes = coarse_codes(recordings, converter_step=step) if step else None
    if codes is None:
        return None
    values = np.unique(np.concatenate([_held_out(each) for each in recordings]))
    off = np.abs(values / codes.step - np.round(values / codes.step))
    on = int((off * codes.step < _NEAR * step).sum())
    share = 2 * _NEAR * step / codes.step  # of a continuous signal's values that are as near to a step
    gain = on * log(1 / share) + (values.size - on) * log(_ASIDE)
    if gain + _LOG_ODDS < LEAST:
        return None
    half = _TWO_SIDED * step / max(float(np.ptp(values)) / codes.step, 1.0) / sqrt(12)
    label = f"codes {codes.step / step:.3g} times as coarse as the converter's"
    fixed = {"step_V": (codes.step, half, "V")}
    return _addition(rig, "quantization", gain, fixed, label, step=codes.step), codes.step


def _limit(
    recordings: Sequence[Recording], rig: Rig, full: float, code: float, *, coarse: bool
) -> tuple[Addition, float] | None:
    """Return the level at which readings stop [V], and its hypothesis.

    The tail of a continuous signal thins out: the last code holds no more samples than the one before it. The number of
    held-out samples on the last code is a Poisson variate.
    """
    cut = flat_tops(recordings, full_range=full, code=code, coarse=coarse)
    if cut is None:
        return None
    width = code or 1e-6 * cut.limit
    gain = 0.0
    for each in recordings:
        if each.name in cut.runs:
            size = np.abs(_held_out(each))
            piled, before = (int((np.abs(size - at) < 0.5 * width).sum()) for at in (cut.limit, cut.limit - width))
            gain += piled * log(max(piled, 1) / (before + 1)) - max(piled - before - 1, 0)
    if gain + _LOG_ODDS < LEAST:
        return None
    fixed = {"limit_V": (cut.limit, 0.5 * width, "V")}
    return _addition(rig, "clipping", gain, fixed, "a limit at which the readings stop", limit=cut.limit), cut.limit


def _dropouts(recordings: Sequence[Recording], rig: Rig, lost: Sequence[Sequence[Gap]]) -> Addition | None:
    """Return moments at one level between two jumps.

    A jump of so many standard deviations has, in Student's distribution, ``(nu + 1) / 2 ln(1 + z^2 / nu)`` nats less
    than a usual step; a dropout has two. Every third moment is held out.
    """
    cut = dropouts_of([*zip(recordings, lost, strict=True)])
    if cut is None:
        return None
    gain = (_TAIL + 1) * log(1 + _JUMP**2 / _TAIL) * max(cut.count // 3, 1)
    if gain + _LOG_ODDS < LEAST:
        return None
    sample = 1e3 / recordings[0].sample_rate
    lengths = [sample * (stop - start) for own in lost for start, stop, _ in own]
    rate, half = 60 * cut.rate, max(_TWO_SIDED * float(np.std(lengths)) / sqrt(cut.count), sample)
    return _addition(
        rig, "signal_dropout", gain,
        {"duration_ms": (1e3 * cut.duration, half, "ms"),
         "rate_per_minute": (rate, _TWO_SIDED * rate / sqrt(cut.count), "1/min")},
        f"{cut.count} moments without a signal", duration=cut.duration, rate=cut.rate, level=cut.level,
    )  # fmt: skip


def _addition(
    rig: Rig, mechanism: str, gain: float, fixed: dict[str, tuple[float, float, str]], label: str, **values: float
) -> Addition:
    classes = {"quantization": "Quantization", "clipping": "Clipping", "signal_dropout": "SignalDropout"}
    made = getattr(mechanisms, classes[mechanism], None)
    if made is None:  # a library without it: the samples are repaired all the same
        return Addition(kind="other", log_odds=_LOG_ODDS + gain, fixed=fixed, label=label)
    part: Part = made(name=free_name(rig, mechanism), **values)
    return Addition(mechanism=mechanism, parts=(part,), log_odds=_LOG_ODDS + gain, fixed=fixed, label=label)


def _held_out(recording: Recording) -> NDArray[np.float64]:
    """Return the samples of every third part of a recording [V]."""
    parts = np.array_split(recording.torque_values(), _PARTS)
    return np.concatenate([each for index, each in enumerate(parts) if index % 3 == 1])
