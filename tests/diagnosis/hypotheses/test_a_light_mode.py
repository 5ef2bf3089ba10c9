"""A branch of a twenty-fifth of the loaded part's inertia shows in a narrow band, and is sought there all the same."""

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
@pytest.mark.parametrize(("share", "frequency"), [(0.04, 97.8), (0.04, 140.0), (0.5, 140.0)])
def test_one_of_those_tried_stands_where_it_is(
    share: float, frequency: float, known_rig: Scenario, three_runs: Callable[..., list[Recording]]
) -> None:
    body = known_rig.rig.part("wear_part")
    assert isinstance(body, Body)
    hidden = TorsionalMode(
        name="hidden", after=body.name, frequency=frequency, inertia=share * body.inertia, damping_ratio=0.02
    )
    case = begun(known_rig, (), three_runs(known_rig.rig + hidden, 3), lambda _: None).before
    tried = [one.parts[0] for one in torsional_mode.propose(case)]
    near = [
        one for one in tried
        if isinstance(one, TorsionalMode) and one.frequency == pytest.approx(frequency, rel=0.05)
    ]  # fmt: skip
    assert min(abs(one.inertia / hidden.inertia - 1) for one in near) < 0.7


@pytest.mark.long
def test_where_a_line_swept_a_mode_must_gain_more(
    known_rig: Scenario, three_runs: Callable[..., list[Recording]]
) -> None:
    case = begun(known_rig, (), three_runs(known_rig.rig, 3), lambda _: None).before
    plain = {one.price for one in torsional_mode.propose(case)}
    swept = replace(case, runs=tuple(replace(run, swept=((10.0, 1000.0),)) for run in case.runs))
    elsewhere = replace(case, runs=tuple(replace(run, swept=((1000.0, 2000.0),)) for run in case.runs))
    assert len(plain) == 1
    assert {one.price for one in torsional_mode.propose(swept)} == {price + 100.0 for price in plain}
    assert {one.price for one in torsional_mode.propose(elsewhere)} == plain
