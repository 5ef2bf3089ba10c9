"""What the whole of a rest goes with, where no place of it stands out: a delay, a spring, a number that changes.

None of these has a name among the effects; each is told with its size, so that the laboratory knows where to look.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import log10

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.diagnosis.motion.moved import STRETCHES, Moved
from torquerig.inference.answer.mismatch import Mismatch

Floats = NDArray[np.float64]

_FALLS = 0.3  # of the square of what is left and was held out: less is the detail of laws that differ
_CHANCE = 0.05
_TOLERANCE = 0.03  # of the rms effort, that must be left: what nobody models
_DELAYS = 40  # samples either way, of a low-passed effort: four periods of the compared band's edge
_TURNING = 0.05  # of the rms speed, over which the sign of the speed changes


@dataclass(frozen=True, kw_only=True)
class GoesWith:
    """What the rest goes with, in words and as a place."""

    sentence: str
    mismatch: Mismatch


def goes_with(model: FittedMotion, runs: Sequence[Moved]) -> GoesWith | None:
    """Return what explains most of what a model leaves of the held-out stretches, None where nothing explains much.

    Chance is that of a fall where each stretch that was held out is worth one sample: what is left is often slow.
    """
    held = model.of(runs, held=True)
    effort = root_mean_square([run.effort[run.held] for run in runs if run.held.any()])
    if root_mean_square(held) < _TOLERANCE * effort:
        return None
    falls = {
        said: 1 - (root_mean_square(after) / root_mean_square(held)) ** 2 for said, after in _tried(model, runs)
    }  # fmt: skip
    said, fall = max(falls.items(), key=lambda item: item[1])
    chance = max(1 - fall, 1e-9) ** (0.25 * STRETCHES * len(held))
    if fall < _FALLS or chance > _CHANCE:
        return None
    longest = max(run.recording.duration for run in runs)
    place = Mismatch(
        domain="time", axis="s", at=0.5 * longest, width=longest, recordings=tuple(run.name for run in runs),
        excess_dB=10 * log10(1 / max(1 - fall, 1e-6)), share_of_misfit=fall, p_value=chance,
    )  # fmt: skip
    return GoesWith(sentence=f"One effect explains {100 * fall:.0f} % of the squared residual: {said}.", mismatch=place)


def _tried(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[tuple[str, list[Floats]]]:
    """Yield what may explain the rest, in words, and what is then left of the stretches held out."""
    taken = [run.effort - left for run, left in zip(runs, model.residuals, strict=True)]
    yield _late(runs, taken)
    yield _sprung(model, runs)
    unit, drag = ("N", "N s/m") if in_a_line(runs) else ("N m", "N m s/rad")
    for words, wave in (
        (
            f"dry friction that varies over the runs, by {{0:+.3g}} {unit} at first, {{1:+.3g}} {unit} at last",
            _sign,
        ),
        (
            f"viscous friction that varies over the runs, by {{0:+.3g}} {drag} at first, {{1:+.3g}} {drag} at last",
            _speed,
        ),
        ("a sensitivity that varies over the runs, by {0:+.2%} at first, {1:+.2%} at last", _effort),
    ):
        yield _changing(model, runs, taken, words, wave)


def _sign(run: Moved, _: Floats) -> Floats:
    return np.tanh(run.speed / (_TURNING * root_mean_square([run.speed])))


def _speed(run: Moved, _: Floats) -> Floats:
    return run.speed


def _effort(_: Moved, made: Floats) -> Floats:
    return made


def _late(runs: Sequence[Moved], taken: Sequence[Floats]) -> tuple[str, list[Floats]]:
    """Return what is left where the effort comes later, or sooner, than the motion that it made."""
    rate = runs[0].rate
    delays = np.arange(-_DELAYS, _DELAYS + 1) / rate

    def left(delay: float, masks: Sequence[NDArray[np.bool_]]) -> list[Floats]:
        answer = []
        for run, made, mask in zip(runs, taken, masks, strict=True):
            time = run.recording.time()
            answer.append((run.effort - np.interp(time - delay, time, made))[mask])
        return [each for each in answer if each.size]

    seen = [run.seen for run in runs]
    squares = np.array([root_mean_square(left(delay, seen)) ** 2 for delay in delays])
    best = int(np.argmin(squares))
    delay = float(delays[best])
    if 0 < best < delays.size - 1:  # the bottom of the parabola through the three lowest
        low, middle, high = squares[best - 1 : best + 2]
        delay += 0.5 * (low - high) / max(low - 2 * middle + high, 1e-300) / rate
    way = "late" if delay > 0 else "early"
    said = f"a delay between the channels (clocks or filters); torque or force is {1e3 * abs(delay):.3g} ms too {way}"
    return said, left(delay, [run.held for run in runs])


def _sprung(model: FittedMotion, runs: Sequence[Moved]) -> tuple[str, list[Floats]]:
    """Return what is left where a spring holds what is moved to the frame."""
    pairs = list(zip(runs, model.residuals, strict=True))
    places = np.concatenate([run.position[run.seen] for run in runs])
    found = np.polynomial.Polynomial.fit(places, np.concatenate([left[run.seen] for run, left in pairs]), 1).convert()
    stiffness = float(found.coef[-1])
    after = [(left - found(run.position))[run.held] for run, left in pairs if run.held.any()]
    unit = "N/m" if in_a_line(runs) else "N m/rad"
    return f"a spring to the frame of {stiffness:.3g} {unit}, or a weight with the same effect", after


def _changing(
    model: FittedMotion, runs: Sequence[Moved], taken: Sequence[Floats], words: str,
    wave: Callable[[Moved, Floats], Floats],
) -> tuple[str, list[Floats]]:  # fmt: skip
    """Return what is left where something in proportion to ``wave`` changes as a parabola along each run."""
    longest = max(run.recording.duration for run in runs)
    bases = []
    for run, made in zip(runs, taken, strict=True):
        along = run.recording.time() / longest
        bases.append(wave(run, made)[:, None] * np.column_stack([np.ones(along.size), along, along**2]))
    pairs = list(zip(runs, bases, model.residuals, strict=True))
    basis = np.concatenate([one[run.seen] for run, one, _ in pairs])
    found = np.linalg.lstsq(basis, np.concatenate([left[run.seen] for run, _, left in pairs]), rcond=None)[0]
    after = [(left - one @ found)[run.held] for run, one, left in pairs if run.held.any()]
    said = words.format(float(found[0]), float(found.sum()))
    return said, after
