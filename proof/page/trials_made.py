"""Which trials were made, and how their answers were sealed."""

from __future__ import annotations

from collections import Counter

from proof.prove.campaign import Proved
from proof.prove.scored import OURS, ScoredSet
from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter

KINDS = ("clean", "wrong parameters only", "in no library", "one effect", "two effects")


def trials_made(proved: Proved) -> Chapter:
    """Return seeds, seals and shares of what was hidden."""
    rows = tuple(_row(one) for one in (*proved.blind, *proved.same_laws, *proved.riddle))
    table = Table(
        caption="Sets of trials", head=("", "rigs", *KINDS, "SHA-256 of the answers, told before the first diagnosis"),
        rows=rows,
    )  # fmt: skip
    lines = (
        (
            "A rig program of its own (own equations, integrators and effects; it imports nothing of the "
            "simulator) draws a rig around the nominal one and, for each rig anew, the law of friction near "
            "standstill, the contact law, the shape of the load and the integrator. A case whose gap shows in no "
            "recording by more than the sensor's noise is drawn again. The diagnosis is given the recordings and the "
            "nominal scenario."
        ),
        (
            "Answers are drawn from the seed, written and hashed before anything is recorded, and opened when "
            "every rig has its diagnosis."
        ),
    )
    return Chapter(anchor="trials", title="How the trials were made", lines=lines, tables=(table,))


def _row(one: ScoredSet) -> tuple[Cell, ...]:
    trials = one.trials[OURS]
    kinds = Counter(trial.kind for trial in trials)
    return (*words(one.name), number(str(len(trials))), *(number(str(kinds[kind])) for kind in KINDS),
            Cell(text=one.seal, style="font-family:monospace;font-size:.75em"))  # fmt: skip
