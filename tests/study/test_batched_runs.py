"""Runs of a study in batches: the figures are those of single runs, whatever the number of workers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from functools import cache

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.filters.chains.all_chains import filtered_by
from torquerig.filters.chains.filter_chain import Chain
from torquerig.metrics.residual_disturbance import simulated_reading_pair
from torquerig.metrics.shares import reading_shares
from torquerig.metrics.truth_error import truth_error
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.planned_drive import settling_of
from torquerig.study.results import DriveResult
from torquerig.study.run_study import run_drive, run_study

CATALOG = load_catalog(shipped_folder())
SMALL = (
    "study.motors=[bldc-12n14p, HDS6A-0104A]", "study.gearboxes=[reference-5-1]", "study.draws=1",
    "study.duration=1 s", "study.filters.names=[none, order_lines, order_lines_low_pass]",
)  # fmt: skip


@cache
def study(*further: str) -> Study:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return open_study(overridden(document, (*SMALL, *further)), CATALOG)


def figures(drive: DriveResult) -> Mapping[str, object]:
    chains = {name: (asdict(one.truth_error), one.random_error, one.effect) for name, one in drive.chains.items()}
    return {"shares": drive.shares, "disturbance": drive.disturbance, "chains": chains, "margins": drive.margins}


@pytest.mark.long
def test_the_figures_do_not_depend_on_the_workers_or_on_the_other_drives() -> None:
    one, two = (run_study(study(), workers=workers) for workers in (1, 2))
    assert [figures(drive) for drive in one.drives] == [figures(drive) for drive in two.drives]
    alone = run_drive(candidates(study())[1], study())
    assert figures(alone) == figures(one.drives[1])
    assert alone.recording is not None
    assert one.drives[1].recording is not None
    np.testing.assert_array_equal(alone.recording.torque(), one.drives[1].recording.torque())


@pytest.mark.long
def test_the_figures_are_those_of_single_runs() -> None:
    asked, candidate = study(), candidates(study())[1]
    found = run_drive(candidate, asked)
    pairs, errors = [], []
    for number in (0, 1):
        made = scenario_of(candidate, asked, seed=1 + number)
        wander = made.operating_point.slow_speed_wander
        settling = max(made.recording.settling, settling_of(asked.settings.speed_loop))
        pair = simulated_reading_pair(
            made.rig, duration=1.0, seed=1, settling=settling, wander=wander, phase_seed=1 + number if number else None
        )
        pairs.append(pair)
        chain = asked.chains(made)["order_lines_low_pass"]
        errors.append(truth_error(chain.apply(pair.reading), pair.reading))
        if number == 0:
            shares = reading_shares(made.rig, duration=1.0, seed=1, settling=settling, wander=wander)
    # not to the bit: rigs that are stepped together multiply their waves in another order
    assert found.shares is not None
    assert asdict(found.shares) == pytest.approx(asdict(shares), rel=1e-8)
    assert found.disturbance.value == pytest.approx(np.median([pair.disturbance for pair in pairs]), rel=1e-8)
    assert found.chains["order_lines_low_pass"].truth_error.value == pytest.approx(np.median(errors), rel=1e-8)


@pytest.mark.long
def test_a_criterion_behind_the_filter_has_both_readings_filtered() -> None:
    asked = study(
        "study.draws=0", "study.motors=[bldc-12n14p]", "study.filters.names=[order_lines]",
        "study.criteria.disturbance.metric=residual_disturbance",
    )  # fmt: skip
    found = run_drive(candidates(asked)[0], asked)
    left = found.chains["order_lines"].residual_disturbance.value
    assert left is not None
    assert found.disturbance.value is not None
    assert 0 < left < found.disturbance.value


class Counted:
    """Adds a number to the torque, and counts how often it is asked."""

    def __init__(self, added: float) -> None:
        self.added, self.asked = added, 0

    def apply(self, recording: Recording) -> Recording:
        self.asked += 1
        name = recording.torque_name()
        return recording.with_values(name, recording.channels[name].values + self.added)


def test_what_chains_begin_with_in_common_is_computed_once() -> None:
    torque = Channel(values=np.arange(5.0), quantity="torque", unit="N*m")
    recording = Recording(sample_rate=10.0, channels={"torque_Nm": torque}, run=Run())
    first, second, third = Counted(1.0), Counted(2.0), Counted(4.0)
    stages = {"none": (), "one": (first,), "two": (first, second), "three": (first, second, third), "last": (third,)}
    chains = {name: Chain(name=name, stages=listed) for name, listed in stages.items()}
    made = dict(filtered_by(chains, recording))
    assert (first.asked, second.asked, third.asked) == (1, 1, 2)
    for name, chain in chains.items():
        np.testing.assert_array_equal(made[name].torque(), chain.apply(recording).torque())
