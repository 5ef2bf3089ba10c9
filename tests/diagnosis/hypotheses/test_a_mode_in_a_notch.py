"""A branch that hardly damps empties a band narrower than any other: it is sought where all runs have a notch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from torquerig.diagnosis.beginning import begun
from torquerig.diagnosis.hypotheses import torsional_mode
from torquerig.mechanisms import TorsionalMode
from torquerig.recordings.recording import Recording
from torquerig.rig.parts import Body
from torquerig.scenario.model import Scenario


@pytest.mark.long
def test_it_is_found_in_the_notch_and_pays_for_no_other_place(
    known_rig: Scenario, three_runs: Callable[..., list[Recording]]
) -> None:
    body = known_rig.rig.part("wear_part")
    assert isinstance(body, Body)
    hidden = TorsionalMode(name="hidden", after=body.name, frequency=46.0, inertia=5.8e-4, damping_ratio=0.005)
    case = begun(known_rig, (), three_runs(known_rig.rig + hidden, 3, duration=12.0), lambda _: None).before
    (notch,) = {notch for run in case.runs for notch in run.notches}
    assert notch == pytest.approx(46.0, abs=1.0)  # of the branch itself: what hangs on it is held fast there
    own = list(torsional_mode.in_notches(case))
    assert own
    for one in own:
        (part,) = one.parts
        assert isinstance(part, TorsionalMode)
        assert part.frequency == pytest.approx(notch, rel=0.021)
        assert one.price == 0
        assert not one.resembled  # noise leaves no notch
    assert any(one.parts[0].inertia == pytest.approx(hidden.inertia, rel=0.7) for one in own)  # type: ignore[attr-defined]


@pytest.mark.long
def test_without_a_notch_none_is_sought_there(known_rig: Scenario, three_runs: Callable[..., list[Recording]]) -> None:
    case = begun(known_rig, (), three_runs(known_rig.rig, 3), lambda _: None).before
    assert not any(run.notches for run in case.runs)
    assert list(torsional_mode.in_notches(case)) == []
    at_one = replace(case, runs=tuple(replace(run, notches=(60.0,)) for run in case.runs))
    assert list(torsional_mode.in_notches(at_one))
