"""Backlash: whether there is a gap, told by flights, by stays near zero torque (``gap_width``) or by its chatter."""

from __future__ import annotations

from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.chattering import told_by_chatter, unexplained
from torquerig.diagnosis.choosing.gap_fits import FittedGap, GapFits, left_alone, simulated_rigs
from torquerig.diagnosis.choosing.gap_width import WithGaps, stays_speak_against, width
from torquerig.diagnosis.choosing.opened_gap import GAP, flanks_fly, opened
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import gears_to_sensor

_SUSPICIOUS = 2.5  # mean square residual of an unloaded run that asks for more than the twin


def gap_is_possible(case: Case) -> bool:
    """Whether flanks fly, or a run is fitted badly in which they may part."""
    if not hasattr(mechanisms, "Backlash") or case.has(GAP) or not gears_to_sensor(case.nominal):
        return False
    if flanks_fly(case):
        return True
    return max(unexplained(case, case.model), default=0.0) > _SUSPICIOUS


def fitted_gap(case: Case, base: Rig) -> FittedGap | None:
    """Return the gap whose simulations come nearest to the recordings, and the model fitted around it.

    None where neither flights nor stays near zero tell one, and chatter leaves a run unexplained where flanks may part,
    or coarse codes are in the model, which may look like chatter, or stays near zero speak against any gap beside what
    was found before. A gap that the scenario states has the stated width where nothing tells another.
    """
    alone = left_alone(case, base)
    rigs = simulated_rigs(case, alone)
    shown = WithGaps(case, rigs)
    told = width(shown)
    if told is None and not case.stated_gap and _no_chatter(case, shown):
        return None
    fits = GapFits(case, base, alone, rigs)
    if told is not None:
        width_told = opened(case, told.gap, within=told.within)
        return replace(fits.around(told.gap), candidate=width_told, closed=told.closed, opened=told.opened)
    if case.stated_gap:
        return fits.around(case.stated_gap)
    return told_by_chatter(fits)


def _no_chatter(case: Case, shown: WithGaps) -> bool:
    """Whether what looks like chatter is none: coarse codes, or moments of which stays near zero know nothing.

    Stays are asked beside what was found before, which may leave a rest that looks like chatter.
    """
    return bool(case.nominal.of_kind("quantization") or (case.accepted and stays_speak_against(shown)))


def simulated_model(candidate: Candidate, model: Calibrated) -> Calibrated:
    """Return the model with the candidate's parts in its rig: what is simulated, and written."""
    return replace(model, rig=candidate.added_to(model.rig))
