"""The samples of a drive: one length, one settling and one load; the median is printed; draws carry no new motor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.metrics.figure import Figure
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidates
from torquerig.study.definition import Study, open_study
from torquerig.study.drawn_motors import best_new_motor_text, is_drawn, ranking_of_draws
from torquerig.study.load_randomness import load_randomness
from torquerig.study.results import DriveResult, StudyRuns
from torquerig.study.run_study import run_drive, run_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.verdict import verdict

CATALOG = load_catalog(shipped_folder())
SMALL = (
    "study.motors=[bldc-12n14p, HDS6A-0104A, ESM06X-401-302]", "study.gearboxes=[reference-5-1]", "study.draws=2",
    "study.duration=1 s", "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip


def study(*further: str) -> Study:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return open_study(overridden(document, (*SMALL, *further)), CATALOG)


@cache
def decided() -> Decided:
    return decide(run_study(study(), workers=2))


@pytest.mark.long
def test_without_open_values_all_samples_are_one_and_the_load_s_randomness_remains() -> None:
    """A motor whose catalog entry leaves nothing open that the reading depends on: only drawn phases differ."""
    drive = run_drive(candidates(study("study.filters.names=[low_pass_20Hz]", "study.draws=3"))[0],
                      study("study.filters.names=[low_pass_20Hz]", "study.draws=3"))  # fmt: skip
    error = drive.chains["low_pass_20Hz"].truth_error
    assert error.value is not None
    assert error.low is not None
    assert error.high is not None
    assert error.low <= error.value <= error.high
    assert error.high - error.low < 0.1 * error.value
    random = drive.chains["low_pass_20Hz"].random_error
    assert random is not None
    assert random > error.high - error.low


@pytest.mark.long
def test_the_value_is_the_median_of_the_samples_and_the_first_is_no_worst_one() -> None:
    drives = list(decided().alternatives.values())
    figures = [made.drive.chains[made.chain].truth_error for made in drives]
    for figure in figures:
        assert figure.source == "simulated, median of 3 samples"
        assert figure.low is not None
        assert figure.high is not None
        assert figure.value is not None
        assert figure.low <= figure.value <= figure.high
    inside = [figure for figure in figures if figure.low < figure.value < figure.high]  # type: ignore[operator]
    assert len(inside) >= 0.8 * len(figures)


@pytest.mark.long
def test_the_loads_of_all_drives_are_one_and_the_reports_say_why_the_sensor_reads_others() -> None:
    from torquerig.reporting.study.csv_tables import shares_csv
    from torquerig.reporting.study.tables import shares_table

    drives = {made.drive.candidate.name: made.drive for made in decided().alternatives.values()}
    loads = [drive.shares.true_load for drive in drives.values() if drive.shares is not None]
    assert np.ptp(loads) < 0.02 * np.mean(loads)  # type: ignore[arg-type]
    found = load_randomness(drives.values())
    assert found is not None
    assert found.duration == 1.0
    assert 0 < found.low <= found.high < 0.5
    assert "The load is random: over 1 s" in found.sentence()
    one = next(iter(drives.values()))
    assert shares_table("M", [one]).head[-4:] == ("true load [N m]", "J1/(J1+J2)", "largest gain", "at [Hz]")
    runs = StudyRuns(study=study(), drives=(one,), mean_load=1.0, occupancy_percent=5.0, particle_size=5e-4,
                     output_speed=20.0)  # fmt: skip
    assert "true load rms [N*m]" in shares_csv(runs).splitlines()[0]


@pytest.mark.long
def test_a_ranking_of_draws_is_called_so_first_and_names_no_new_motor_that_the_draws_do_not_carry() -> None:
    made = decided()
    answer = verdict(made)
    assert ranking_of_draws(made) == (
        "Of the 3 ranked motors, 2 have no data sheet with their cogging and ripple: their order among each other is "
        "one of draws from the intervals of their class. "
    )
    assert any(remark.startswith("Of the 3 ranked motors, 2 have no data sheet") for remark in answer.remarks)
    text = best_new_motor_text(made, [name for name in made.ranked() if "bldc" not in name])
    assert text.startswith((" The best new motor is ", " No new motor is clearly best: "))
    assert ("% of the samples of the data" in text) == text.startswith(" The best")
    assert best_new_motor_text(made, []) == ""


def test_a_motor_is_drawn_where_its_lines_are_assumed() -> None:
    candidate = candidates(study())[0]
    bare = DriveResult(
        candidate=candidate, margins={}, out_of_reach="x", motor_speed=1.0, torque_limit=1.0, kp=1.0, assumed={},
        shares=None, disturbance=Figure(unit="N*m"), chains={},
    )  # fmt: skip
    assert not is_drawn(bare)
    assert not is_drawn(replace(bare, assumed={"motor.inertia": "of an interval"}))
    assert is_drawn(replace(bare, assumed={"motor.ripple.cogging_native": "of an interval"}))
