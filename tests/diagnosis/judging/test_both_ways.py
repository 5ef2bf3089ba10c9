"""A mode that leaves its own band too loud in one run and too quiet in another stands in for noise."""

from __future__ import annotations

import pytest

from torquerig.diagnosis.judging.both_ways import rings_both_ways
from torquerig.diagnosis.judging.withdrawn import why_withdrawn
from torquerig.diagnosis.outcome import HeldOut
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.mechanisms import TorsionalMode
from torquerig.scenario.model import Scenario

MODE = TorsionalMode(name="mode", after="wear_part", frequency=190.0, inertia=1e-4, damping_ratio=0.01)


def band(excess: float, *, at: float = 200.0, width: float = 35.0, run: str = "run1") -> Mismatch:
    return Mismatch(
        domain="frequency", axis="Hz", at=at, width=width, recordings=(run,), excess_dB=excess, share_of_misfit=0.5,
        p_value=1e-9,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("left", "both"),
    [
        ((band(5.0), band(-6.0)), True),
        ((band(5.0), band(6.0)), False),
        ((band(5.0), band(-6.0, at=400.0)), False),
        ((band(5.0, width=900.0), band(-6.0, width=900.0)), False),
        ((), False),
    ],
    ids=["both ways", "one way", "elsewhere", "all over", "nothing"],
)
def test_the_band_of_a_mode_that_stays_wrong_both_ways(
    left: tuple[Mismatch, ...], both: bool, wear_rig: Scenario
) -> None:
    assert rings_both_ways(left, wear_rig.rig + MODE) is both
    assert not rings_both_ways(left, wear_rig.rig)


def test_it_is_withdrawn_and_said() -> None:
    fit = HeldOut(nominal=9.0, before=4.0, after=1.0, improvement=(0.75, 0.6, 0.9), by_twin=False, explained=0.95)
    left = (band(5.0), band(-6.0, run="run2"))
    assert "too weak in another" in why_withdrawn(fit, left, resembled=True, both_ways=True)
    assert why_withdrawn(fit, left, resembled=True) == ""
