"""Sets of trials: WEAR, FLEET, CLEAN, STRANGERS, LEAVE-ONE-OUT, SET-UP, INVARIANCE; each with other random streams."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from proof.errors import ProofError
from proof.fleet.draw import RIGS, FleetCase, NoRigError, draw_case, draw_kinds
from proof.fleet.effects import MECHANISMS
from proof.fleet.rig import draw_rig
from proof.referee.invariance import CHANGES, changed_case
from proof.referee.setup_faults import FAULTS, SetupFault, fault_case
from proof.strangers import STRANGERS
from proof.strangers.draw import stranger_case

DEVELOPMENT_SEEDS = range(7001, 7100)
"""Seeds for development; the published figures come from others, drawn once after the last change."""
INVARIANT_RIGS = 6


@dataclass(frozen=True)
class TrialCase:
    """One case of a set: its rig and what is special about it.

    Parameters
    ----------
    name : str
        Its folder.
    case : FleetCase
    fault : SetupFault or None
        Set-up fault of recordings or scenario.
    without : str
        Mechanism whose file is removed before the diagnosis, or empty.
    change : str
        Change of the files that must not change the answer, or empty.
    outside : tuple of str
        Kinds of effects that are in no library, or not in the library of this diagnosis.
    """

    name: str
    case: FleetCase
    fault: SetupFault | None = None
    without: str = ""
    change: str = ""
    outside: tuple[str, ...] = ()


def fleet(seed: int, number: int) -> TrialCase:
    """Return a rig with 0 to 4 effects."""
    name, key = f"fleet-{seed}-{number:03d}", (seed, 1, number)
    rng = np.random.default_rng([*key, 1])
    return TrialCase(name, draw_case(name, key, draw_kinds(number, rng)))


def clean(seed: int, number: int) -> TrialCase:
    """Return a rig without effects."""
    name = f"clean-{seed}-{number:03d}"
    return TrialCase(name, FleetCase(draw_rig(name, (seed, 2, number))))


def strangers(seed: int, number: int) -> TrialCase:
    """Return a rig with one effect that no mechanism describes; the kinds in turn."""
    name = f"stranger-{seed}-{number:03d}"
    case = stranger_case(name, (seed, 3, number), list(STRANGERS)[number % len(STRANGERS)])
    return TrialCase(name, case, outside=tuple(STRANGERS))


def leave_one_out(seed: int, number: int) -> TrialCase:
    """Return a rig with one effect, to be diagnosed without the file of that mechanism; the mechanisms in turn."""
    kind = list(MECHANISMS)[number % len(MECHANISMS)]
    name = f"left-out-{seed}-{number:03d}"
    for attempt in range(RIGS):
        case = draw_case(name, (seed, 4, number, attempt), (kind,))
        # a scenario that states such a part could not be read without its file
        if all(part["kind"] != kind for part in case.rig.design.parts.values()):
            return TrialCase(name, case, without=kind, outside=(kind,))
    raise NoRigError(f"{name}: none of {RIGS} drawn rigs is without a stated {kind}")


def setup(seed: int, number: int) -> TrialCase:
    """Return a rig without effects and with one set-up fault; the faults in turn."""
    name = f"setup-{seed}-{number:03d}"
    case, fault = fault_case(name, (seed, 5, number), list(FAULTS)[number % len(FAULTS)])
    return TrialCase(name, case, fault=fault)


def invariance(seed: int, number: int) -> TrialCase:
    """Return a rig under one change that must not change the answer; ``as_is`` comes first for every rig."""
    rig, kind = divmod(number, len(CHANGES))
    name = f"invariance-{seed}-{rig:02d}-{list(CHANGES)[kind]}"
    return TrialCase(name, changed_case(name, (seed, 6, rig)), change=list(CHANGES)[kind])


@dataclass(frozen=True)
class TrialSet:
    """A set: its full number of cases and the function that draws one (None: the wear rig's program draws them)."""

    name: str
    size: int
    draw: Callable[[int, int], TrialCase] | None


SETS = {
    one.name: one
    for one in (
        TrialSet("WEAR", 120, None),
        TrialSet("FLEET", 200, fleet),
        TrialSet("CLEAN", 100, clean),
        TrialSet("STRANGERS", 100, strangers),
        TrialSet("LEAVE-ONE-OUT", 48, leave_one_out),
        TrialSet("SET-UP", 60, setup),
        TrialSet("INVARIANCE", INVARIANT_RIGS * len(CHANGES), invariance),
    )
}


def drawn(set_name: str, seed: int, number: int) -> TrialCase:
    """Return one case of a set on the fleet.

    Raises
    ------
    ProofError
        For an unknown set or the wear rig's, and where no rig can be drawn.
    """
    draw = SETS[set_name].draw if set_name in SETS else None
    if draw is None:
        known = ", ".join(name for name, one in SETS.items() if one.draw)
        raise ProofError(f"{set_name!r} is no set of the fleet; use one of {known}")
    try:
        return draw(seed, number)
    except NoRigError as wrong:
        raise ProofError(str(wrong)) from wrong
