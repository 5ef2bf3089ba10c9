"""``torquerig diagnose --check``: what recordings would show, and what they cannot tell apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from torquerig.cli.progress import stages
from torquerig.inference.engine import Prepared, prepared
from torquerig.inference.isolability.beforehand import Beforehand, Inseparable, beforehand
from torquerig.inference.motion.beforehand import inseparable, limits, signatures
from torquerig.inference.motion.engine import nominal_fits
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.json_results.diagnosis import DiagnoseCheckResult, InseparablePair, UpperLimit
from torquerig.reporting.layout import plain
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.reading_place import effort_unit
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.as_compared import as_compared

_FURTHER = "Record a run that turns back, and one at another speed; the next run is not computed under measured motion."


def checked_by_likelihood(
    scenario: Scenario, recordings: Sequence[Recording], lines: Sequence[str], *, held_out: Sequence[Path]
) -> DiagnoseCheckResult:
    """Return the check of the files, ``lines``, with what the recordings would show of each mechanism.

    The nominal rig is fitted as a diagnosis fits it, so that what a diagnosis refuses is refused here.

    Raises
    ------
    InputError, RecordingError
        As a diagnosis.
    """
    names = [one.name for one in held_out]
    if imposed_part(scenario.rig) is not None:
        return _checked_motion(scenario, recordings, lines, names)
    with stages("diagnose --check") as progress:
        compared = as_compared(scenario, recordings)
        ready = prepared(compared.scenario, compared.recordings, held_out=names, progress=progress)
        progress("computing what the recordings would show")
        found = beforehand(ready)
    *first, last = lines
    return _result([*first, *_suspicions(ready), *_text(found), last], found)


def _checked_motion(
    scenario: Scenario, recordings: Sequence[Recording], lines: Sequence[str], held_out: Sequence[str]
) -> DiagnoseCheckResult:
    """Return the check where the motion was measured."""
    with stages("diagnose --check") as progress:
        compared = as_compared(scenario, recordings)
        _, nominal = nominal_fits(compared.scenario, compared.recordings, held_out_runs=held_out, progress=progress)
        progress("computing what the recordings would show")
        seen = signatures(nominal)
    found = Beforehand(
        tuple(limits(seen, effort_unit(nominal.rig))),
        tuple(Inseparable(one.label, other.label, (one.mechanism, other.mechanism), _FURTHER)
              for one, other in inseparable(seen)),
    )  # fmt: skip
    *first, last = lines
    return _result([*first, *_text(found), last], found)


def _result(lines: Sequence[str], found: Beforehand) -> DiagnoseCheckResult:
    return DiagnoseCheckResult(
        tuple(lines),
        tuple(UpperLimit(**each) for each in found.upper_limits),
        tuple(InseparablePair(each.one, each.other, each.mechanisms, each.next_experiment)
              for each in found.inseparable),
    )  # fmt: skip


def _suspicions(ready: Prepared) -> Iterator[str]:
    for sentence in ready.remarks:
        yield from wrapped(f"suspicious: {sentence}").splitlines()
    for fault in ready.setup:
        yield from wrapped(f"suspicious: {fault.explanation}").splitlines()


def _text(found: Beforehand) -> Iterator[str]:
    if found.upper_limits:
        yield "smallest sizes that these runs would show (in 95 % of such runs):"
        rows = [
            [mechanism_text(each["mechanism"]), each["parameter"],
             f"{'below' if each['grows'] == 'down' else 'from'} {plain(each['value'])} {each['unit']}", each["place"]]
            for each in found.upper_limits
        ]  # fmt: skip
        yield from grid([["mechanism", "parameter", "size", "tested place"], *rows], right=()).splitlines()
    for pair in found.inseparable:
        yield from wrapped(
            f"these runs do not separate {pair.one} from {pair.other}. {pair.next_experiment}"
        ).splitlines()
    if found.upper_limits and not found.inseparable:
        yield "these runs separate all mechanisms at twice these sizes"
