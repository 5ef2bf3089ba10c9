"""Sets of trials and their seals."""

from __future__ import annotations

from collections import Counter

from proof.prove.campaign import ProofResults
from proof.prove.scored import OURS, ScoredSet
from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter

KINDS = ("clean", "wrong parameters only", "effects outside the library", "one effect", "two effects")


def trial_sets(proved: ProofResults) -> Chapter:
    """Return seeds, seals and kinds of cases."""
    rows = tuple(_row(one) for one in (*proved.blind, *proved.same_laws, *proved.riddle))
    table = Table(
        caption="Sets of trials", rows=rows,
        head=("", "rigs", *KINDS, "SHA-256 of the answers, printed before the first diagnosis"),
    )  # fmt: skip
    lines = (
        (
            "An independent rig program makes the recordings. It has its equations, integrators and effects, and "
            "imports nothing of the simulator. For each rig it draws parameters around the nominal ones, the friction "
            "law near standstill, the contact law, the load shape and the integrator. A case is drawn again if its "
            "backlash is below the sensor noise in all recordings. The diagnosis has only the recordings and the "
            "nominal scenario."
        ),
        (
            "The answers follow from the seed. They are written and hashed before the first recording, and opened "
            "after the last diagnosis."
        ),
    )
    return Chapter(anchor="trials", title="How the trials were made", lines=lines, tables=(table,))


def _row(one: ScoredSet) -> tuple[Cell, ...]:
    trials = one.trials[OURS]
    kinds = Counter(trial.kind for trial in trials)
    return (*words(one.name), number(str(len(trials))), *(number(str(kinds[kind])) for kind in KINDS),
            Cell(text=one.seal, style="font-family:monospace;font-size:.75em"))  # fmt: skip
