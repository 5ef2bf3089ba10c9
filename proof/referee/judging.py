"""One case judged: the claim of a diagnosis against the sealed answer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from proof.referee.claims import Claim, Located, Named

ALIKE = {
    "order": {"order"}, "frequency": {"frequency"}, "time": {"time", "level"}, "speed": {"speed", "level"},
    "level": {"level", "speed", "time"}, "distribution": {"distribution", "level", "time"},
}  # fmt: skip
"""Domains in which a place of each domain may be reported: a level that moves is a course over time, or over speed."""
WHOLE_BAND = 1.0  # relative width of a place from which on only the domain is judged
WIDEST = 0.1  # relative width of a reported place beyond which it does not help
MODELLED = 0.7  # share of the held-out excess that the written model must remove


@dataclass(frozen=True)
class Size:
    """Error of one estimated size: relative error, whether the interval holds the truth, relative half-width."""

    mechanism: str
    parameter: str
    error: float
    covered: bool | None
    half_width: float | None


@dataclass(frozen=True)
class Verdict:
    """The outcome of one case.

    Parameters
    ----------
    name, set_name, due : str
    said : str
        Verdict of the diagnosis, or empty without one.
    exact : bool
        The due verdict, every name that counts, no false one.
    false_names, missed : tuple of str
    located, modelled, setup_reported : bool or None
        None where the case has nothing of the kind.
    accused : bool or None
        A rig without effects called anything but adequate.
    """

    name: str
    set_name: str
    due: str
    said: str
    exact: bool
    false_names: tuple[str, ...]
    missed: tuple[str, ...]
    effects: tuple[str, ...]
    named: tuple[str, ...]
    located: bool | None
    modelled: bool | None
    setup_reported: bool | None
    accused: bool | None
    confidences: tuple[tuple[float, bool], ...]
    sizes: tuple[Size, ...]
    clean_chi_square: float | None
    group: str
    change: str = ""
    signature: str = ""
    why_not: str = ""


def judged(name: str, answer: Mapping[str, Any], claim: Claim | None, *, why_not: str = "") -> Verdict:
    """Return the outcome of a case; ``why_not`` is what the command said where it has no claim."""
    effects = list(answer["effects"])
    counted = [one for one in effects if one["counts"]]
    wanted = [one for one in counted if one["in_library"]]
    facts = answer["setup"]
    claim_or_none = claim or Claim(verdict="")
    pairs = matched(effects, claim_or_none.findings)
    false = tuple(finding.name for finding, effect in pairs if effect is None)
    found = [effect for _, effect in pairs if effect is not None]
    missed = tuple(one["mechanism"] for one in wanted if one not in found)
    reported = None if not facts else any(says(one, facts[0]) for one in claim_or_none.setup)
    free = not effects and not facts
    due = due_verdicts(answer, named=bool(found))
    exact = claim is not None and claim.verdict in due and not false and not missed and reported is not False
    outside = [one for one in counted if not one["in_library"]]
    return Verdict(
        name=name, set_name=answer["set"], due=answer["verdict"], said=claim_or_none.verdict, exact=exact,
        false_names=false, missed=missed, effects=tuple(_shown(one) for one in effects),
        named=tuple(f"{one.name} {one.confidence:.2f}" for one in (*claim_or_none.findings, *claim_or_none.setup)),
        located=None if not outside else all(located(one, claim_or_none.places, answer) for one in outside),
        modelled=None if not outside else modelled(claim_or_none),
        setup_reported=reported,
        accused=None if not free else claim is not None and (claim.verdict != "adequate" or bool(claim.findings)),
        confidences=tuple((finding.confidence, effect is not None) for finding, effect in pairs),
        sizes=tuple(size for finding, effect in pairs if effect is not None for size in sizes_of(effect, finding)),
        clean_chi_square=claim.before if free and claim is not None else None,
        group=group_of(answer), change=answer.get("change", ""), signature=signature_of(claim_or_none), why_not=why_not,
    )  # fmt: skip


def due_verdicts(answer: Mapping[str, Any], *, named: bool) -> tuple[str, ...]:
    """Return the right verdicts; a true effect that does not count may be named or not."""
    if answer["verdict"] == "adequate" and named:
        return ("adequate", "missing_physics")
    if answer["setup"]:
        return ("setup_error", answer["verdict"])
    return (answer["verdict"],)


def matched(
    effects: Sequence[Mapping[str, Any]], findings: Sequence[Named]
) -> list[tuple[Named, Mapping[str, Any] | None]]:
    """Return every finding with the effect that it names, each effect once; None: a false name."""
    free = [one for one in effects if one["in_library"]]
    pairs: list[tuple[Named, Mapping[str, Any] | None]] = []
    for finding in findings:
        names = {finding.name, *finding.equivalent_to}
        ranked = sorted(free, key=lambda one: finding.name not in _names(one))  # by name before by class
        effect = next((one for one in ranked if names & _names(one)), None)
        if effect is not None:
            free.remove(effect)
        pairs.append((finding, effect))
    return pairs


def says(fact: Named, true: Mapping[str, Any]) -> bool:
    """Return whether a set-up fact is the true one, or leaves it open as an alternative."""
    kinds = {true["kind"], *true.get("also", ())}
    return bool(kinds & {fact.name, *fact.equivalent_to})


def located(effect: Mapping[str, Any], places: Sequence[Located], answer: Mapping[str, Any]) -> bool:
    """Return whether a reported place is one of the effect's: right domain, position within 1 % or its band."""
    return any(_is_at(true, one, answer["turns_per_output_turn"]) for true in effect["places"] for one in places)


def _is_at(true: Mapping[str, Any], said: Located, turns: Mapping[str, float]) -> bool:
    if said.domain not in ALIKE[true["domain"]]:
        return False
    if true["width"] >= WHOLE_BAND or said.domain != true["domain"]:
        return True
    factor = turns.get(said.axis, 1.0) if true["domain"] == "order" else 1.0
    wanted = true["at"] * (turns.get(true["axis"], 1.0) if true["domain"] == "order" else 1.0)
    tolerance = max(true["width"], 0.01, min(said.width, WIDEST)) * abs(wanted)
    return any(abs(position * factor - wanted) <= tolerance for position in said.positions)


def modelled(claim: Claim) -> bool:
    """Return whether the written model removes 70 % of the held-out excess over a true model, whose residual is 1."""
    if claim.before is None or claim.after is None or claim.before <= 1.0:
        return False
    return claim.before - claim.after >= MODELLED * (claim.before - 1.0)


def sizes_of(effect: Mapping[str, Any], finding: Named) -> list[Size]:
    """Return the errors of the sizes that truth and finding both state; places (orders, frequencies) are none."""
    rows = []
    for name, true in effect["parameters"].items():
        one = finding.parameters.get(name)
        if one is None or not true or one.value is None or name.startswith("order") or name.endswith("frequency_Hz"):
            continue
        low, high = one.interval or (None, None)
        covered = None if low is None or high is None else low <= true <= high
        half = None if low is None or high is None else 0.5 * (high - low) / abs(true)
        rows.append(Size(effect["mechanism"], name, abs(one.value / true - 1.0), covered, half))
    return rows


def group_of(answer: Mapping[str, Any]) -> str:
    """Return what a case is counted under within its set: its kind of effect, fault or rig."""
    if answer["setup"]:
        return str(answer["setup"][0]["kind"])
    counted = [one["mechanism"] for one in answer["effects"] if one["counts"]]
    if answer["set"] in ("FLEET", "WEAR"):
        return f"{len(counted)} effects"
    if answer.get("change"):
        return str(answer["change"])
    return counted[0] if counted else f"{answer['rig']['drive']}, {answer['rig']['plan']}"


def signature_of(claim: Claim) -> str:
    """Return verdict and names as one text; a change that must not matter leaves it."""
    return " ".join([claim.verdict, *sorted(one.name for one in (*claim.findings, *claim.setup))])


def _names(effect: Mapping[str, Any]) -> set[str]:
    return {effect["mechanism"], *effect.get("also_right", ())}


def _shown(effect: Mapping[str, Any]) -> str:
    return str(effect["mechanism"]) + ("" if effect["counts"] else " (does not count)")
