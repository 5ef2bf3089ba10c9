"""What lines add to a reading, by a second run of the same draws."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate
from torquerig.simulation.true_lines import TRUE_LINES, with_true_lines, without_lines

SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "wear_rig.yaml"


def test_less_the_lines_the_error_is_that_of_the_run_without_them():
    rig = read_scenario(read_document(SCENARIO), catalog_for(SCENARIO, ()), seed=1).rig
    full = simulate(rig, duration=0.5, seed=3)
    known = with_true_lines(full, rig, seed=3)
    clean = simulate(without_lines(rig), duration=0.5, seed=3)
    lines = known.channels[TRUE_LINES].values
    perfect = known.with_values("torque_V", known.torque() - lines)
    assert np.isclose(truth_error(perfect, known), truth_error(clean, clean), rtol=1e-9)
    assert lines.std() > 0.05
    assert {part.group for part in without_lines(rig).parts} <= {"", "load", "sensor"}


def test_a_rig_without_lines_has_none_and_a_recording_without_load_is_left_alone():
    rig = without_lines(read_scenario(read_document(SCENARIO), catalog_for(SCENARIO, ()), seed=1).rig)
    full = simulate(rig, duration=0.2, seed=3)
    assert not with_true_lines(full, rig, seed=3).channels[TRUE_LINES].values.any()
    unknown = replace(full, channels={name: one for name, one in full.channels.items() if name != TRUE_LOAD})
    assert with_true_lines(unknown, rig, seed=3) is unknown
