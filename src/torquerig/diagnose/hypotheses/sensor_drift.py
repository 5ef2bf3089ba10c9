"""A zero that moves while the recording runs, whatever the shafts do."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.knobs import Knob

_SPANS = tuple(sign * span for sign in (-1, 1) for span in (0.05, 0.15, 0.5, 1.5, 4.0))  # [V]
_SPREAD = 0.3  # [V]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield the exponential and the straight drift that fit best among a few spans and time constants."""
    longest = max(run.recording.duration for run in case.runs)
    for constants in ((0.1 * longest, 0.3 * longest, longest), (None,)):
        ranked: list[tuple[float, Candidate]] = []
        for tau in constants:
            for span in _SPANS:
                part = mechanisms.SensorDrift(name="sensor_drift", span=span, time_constant=tau)
                knobs = [Knob(part.name, "span", _SPREAD, factor=False)]
                knobs += [] if tau is None else [Knob(part.name, "time_constant", 0.7)]
                candidate = Candidate(
                    mechanism="sensor_drift", parts=(part,), knobs=tuple(knobs),
                    variant="linear" if tau is None else "exponential",
                )  # fmt: skip
                ranked.append((case.misfit_of(candidate.added_to(case.model.rig)), candidate))
        yield min(ranked, key=lambda item: item[0])[1]
