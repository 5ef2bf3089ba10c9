"""Outcome of a diagnosis: true effects are matched with findings by name first, then within the class."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from proof.scoring.claims import Claim, Finding


class Outcome(Enum):
    """Outcome of one case, best first."""

    EXACT = "exactly right"
    IN_CLASS = "right within the class"
    PARTIAL = "partly right"
    UNEXPLAINED = "falsely unexplained"
    MISSED = "missed"
    FALSE_NAME = "false name"
    NO_ANSWER = "no diagnosis"


@dataclass(frozen=True)
class TrueEffect:
    """One effect of the sealed answers."""

    mechanism: str
    in_library: bool
    size: float
    also_right: tuple[str, ...]
    parameters: dict[str, float | None]

    @property
    def names(self) -> tuple[str, ...]:
        """Every right name of the effect."""
        return (self.mechanism, *self.also_right)


@dataclass(frozen=True)
class Match:
    """A finding with the effect that it names (None: a false name), by name or by class."""

    finding: Finding
    effect: TrueEffect | None
    by_class: bool = False


def match_findings(effects: tuple[TrueEffect, ...], findings: tuple[Finding, ...]) -> list[Match]:
    """Return every finding with its effect of the library, each effect once: names first, then classes."""
    free = [effect for effect in effects if effect.in_library]
    matched: dict[int, Match] = {}
    for by_class in (False, True):
        for i, finding in enumerate(findings):
            if i in matched:
                continue
            names = finding.equivalent_to if by_class else (finding.mechanism,)
            effect = next((effect for effect in free if set(effect.names).intersection(names)), None)
            if effect is not None:
                free.remove(effect)
                matched[i] = Match(finding, effect, by_class)
    return [matched.get(i, Match(finding, None)) for i, finding in enumerate(findings)]


def judge(due: str, effects: tuple[TrueEffect, ...], claim: Claim | None) -> Outcome:
    """Return the outcome of a claim for the true verdict ``due``; one false name makes the case false."""
    if claim is None:
        return Outcome.NO_ANSWER
    matches = match_findings(effects, claim.findings)
    if any(match.effect is None for match in matches):
        return Outcome.FALSE_NAME
    wanted = sum(effect.in_library for effect in effects)
    if claim.verdict == due and len(matches) == wanted:
        return Outcome.IN_CLASS if any(match.by_class for match in matches) else Outcome.EXACT
    if matches or (claim.verdict == due == "unexplained"):
        return Outcome.PARTIAL
    return Outcome.UNEXPLAINED if claim.verdict == "unexplained" else Outcome.MISSED
