"""What recordings can show and tell apart, before anything is searched in them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from torquerig.inference.context import Context
from torquerig.inference.engine import Prepared
from torquerig.inference.isolability.classes import Pair, inseparable
from torquerig.inference.isolability.limits import as_limit, best_by_mechanism, smallest
from torquerig.inference.isolability.probes import hypotheses, probed
from torquerig.inference.isolability.separating import separating_run
from torquerig.inference.isolability.signatures import Projection, Signature
from torquerig.inference.knobs import turned
from torquerig.rig.assembly import Rig


@dataclass(frozen=True)
class Inseparable:
    """Two hypotheses that the recordings do not separate, and the further run that does, in one sentence."""

    one: str
    other: str
    mechanisms: tuple[str, str]
    next_experiment: str


@dataclass(frozen=True)
class Beforehand:
    """The smallest visible size of each mechanism, in the contract's form, and what cannot be separated."""

    upper_limits: tuple[dict[str, Any], ...]
    inseparable: tuple[Inseparable, ...]


def beforehand(ready: Prepared) -> Beforehand:
    """Return what recordings would show of the mechanisms of the library, by the fitted nominal rig."""
    context, places = probed(ready.nominal, ready.runs, ready.known)
    found = smallest(Projection(context), hypotheses(context, places))
    return Beforehand(
        tuple(as_limit(each) for each in best_by_mechanism(found)),
        tuple(_inseparable(context, pair) for pair in inseparable(found)),
    )


def _inseparable(context: Context, pair: Pair) -> Inseparable:
    names = (pair.one.addition.mechanism, pair.other.addition.mechanism)
    run = separating_run(
        _with(context, pair.one), _with(context, pair.other), context.data.seen, context.fit, names=names
    )
    return Inseparable(pair.one.addition.label, pair.other.addition.label, names, run)


def _with(context: Context, each: Signature) -> Rig:
    return turned(each.addition.added_to(context.rig), each.addition.knobs, each.positions)
