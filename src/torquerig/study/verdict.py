"""Which combination to buy, how sure that is, and what to ask the makers first."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.eliminate import Decision
from torquerig.decide.robustness import best_shares
from torquerig.study.results import DriveResult
from torquerig.study.scoring import Decided

ROBUST = 0.9  # [1] probability of being best from which a verdict is called robust
UNDECIDED = 0.5  # [1] below it the missing data decide, not the study
NEIGHBOURS = 5  # drives whose missing data are asked for


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """The answer of a study.

    Parameters
    ----------
    winner : str
        Name of the alternative; empty where nothing survives.
    sentence : str
        One sentence for the reader.
    word : str
        robust, fragile, tie, undecidable for lack of information, or nothing survives.
    p_best : float
        How often the combination is best when every interval is drawn; ``p_best_drive`` the same for its drive with
        any filter.
    open_facts : tuple of str
        What to ask for, the best drives first.
    """

    winner: str
    sentence: str
    word: str
    p_best: float
    p_best_drive: float
    open_facts: tuple[str, ...]


def verdict(decided: Decided) -> Verdict:
    """Return the answer to the study's question."""
    out = set(decided.chart.with_decision(Decision.ELIMINATE))
    names = [name for name in decided.ranked() if decided.alternatives[name].drive.candidate.name not in out]
    if not names:
        return Verdict(
            winner="", word="nothing survives", p_best=0.0, p_best_drive=0.0, open_facts=(),
            sentence="No drive meets the demands; the elimination says which demand each one misses.",
        )  # fmt: skip
    shares = best_shares(decided.matrix.only(alternatives=names))
    chance = dict(zip(shares.alternatives, shares.p_best.tolist(), strict=True))
    winner = names[0]
    drive = decided.alternatives[winner].drive
    by_drive = sum(chance[name] for name in names if decided.alternatives[name].drive is drive)
    totals = dict(zip(decided.overall.alternatives, decided.overall.total.tolist(), strict=True))
    rivals = [name for name in names if decided.alternatives[name].drive is not drive]
    word = _word(totals[winner], totals[rivals[0]] if rivals else None, by_drive)
    return Verdict(
        winner=winner, word=word, p_best=chance[winner], p_best_drive=by_drive,
        sentence=_sentence(decided, winner, rivals[0] if rivals else "", word=word, by_drive=by_drive),
        open_facts=_open_facts(decided, names),
    )  # fmt: skip


def _word(total: float, rival: float | None, by_drive: float) -> str:
    if rival is not None and abs(total - rival) < 1e-9:
        return "tie"
    if by_drive < UNDECIDED:
        return "undecidable for lack of information"
    return "robust" if by_drive >= ROBUST else "fragile"


def _sentence(decided: Decided, winner: str, rival: str, *, word: str, by_drive: float) -> str:
    made = decided.alternatives[winner]
    error = made.drive.chains[made.chain].truth_error
    now = decided.alternatives[decided.datum]
    today = now.drive.chains[now.chain].truth_error
    action = (
        f"Keep {made.drive.candidate.name} as it is, with"
        if winner == decided.datum
        else _action(made.drive, now.drive)
    )
    if word.startswith("undecidable"):
        action = f"Nothing can be called best yet; in front is {made.drive.candidate.name} with"
    reading = (
        f"it reads the load to {error.value:.3f} N m rms, where {now.drive.candidate.name} with the filter {now.chain} "
        f"is off by {today.value:.3f}"
    )
    newest = next((name for name in decided.ranked() if _bought(decided, name, now.drive)), "")
    beside = f"; the best new motor is {newest.replace(' | ', ' with ')}" if newest and newest != winner else ""
    beside = beside or (f"; next is {rival.replace(' | ', ' with ')}" if rival else "")
    row = next(row for row in decided.chart.rows if row.alternative == made.drive.candidate.name)
    doubts = [remark.missing for remark in row.remarks if remark.missing]
    still = f" Still open: {', '.join(doubts)}." if doubts else ""
    return (
        f"{action} the filter {made.chain}: {reading}{beside}. The verdict is {word}: this drive is best in "
        f"{100 * by_drive:.0f} % of draws over what the catalog leaves open (weights and points kept).{still}"
    )


def _action(chosen: DriveResult, now: DriveResult) -> str:
    if chosen.margins["new_parts"].value == 0:
        return f"Keep {chosen.candidate.name} and add"
    if chosen.candidate.motor == now.candidate.motor:
        return f"Keep the motor {now.candidate.motor}, put it on a gearbox of {chosen.candidate.ratio:g}:1 and add"
    return f"Buy {chosen.candidate.name} with"


def _bought(decided: Decided, name: str, now: DriveResult) -> bool:
    drive = decided.alternatives[name].drive
    out = decided.chart.with_decision(Decision.ELIMINATE)
    return drive.candidate.motor != now.candidate.motor and drive.candidate.name not in out


def _open_facts(decided: Decided, names: list[str]) -> tuple[str, ...]:
    drives = list(dict.fromkeys(id(decided.alternatives[name].drive) for name in names))[:NEIGHBOURS]
    known = {id(made.drive): made.drive for made in decided.alternatives.values()}
    facts = []
    for drive in (known[key] for key in drives):
        asked = [key.split(".")[-1].replace("_", " ") for key in drive.assumed if key.startswith("motor.")]
        if asked:
            facts.append(f"{', '.join(dict.fromkeys(asked))} of {drive.candidate.motor}")
        margins = [figure.missing for figure in drive.margins.values() if figure.missing]
        facts += list(dict.fromkeys(margins))
    return tuple(dict.fromkeys(facts))
