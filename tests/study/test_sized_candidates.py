"""Sizing in a study: figures as criteria, the duty cycle, the ratio swept beside the closed form."""

from __future__ import annotations

from dataclasses import replace
from typing import get_args

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.filters.chains.filter_chain import Chain
from torquerig.metrics.residual_disturbance import simulated_reading_pair
from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS
from torquerig.study.candidate import Candidate
from torquerig.study.candidates import scenario_of
from torquerig.study.criteria import UNITS, criteria_of, unit_of
from torquerig.study.definition import open_study
from torquerig.study.ratio_sweep import middle, ratio_sweep
from torquerig.study.run_study import run_drive
from torquerig.study.settings import CriterionRow, Metric
from torquerig.study.sized_candidates import sized_candidate, sizing_figures, with_cycle

PRESENT = Candidate(motor="bldc-12n14p", gearbox="reference-5-1", ratio=5.0)


@pytest.fixture(scope="module")
def study():
    opened = open_study(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()))
    return replace(opened, settings=opened.settings.model_copy(update={"draws": 0, "duration": 1.0}))


def test_every_figure_of_a_sizing_may_be_a_criterion():
    assert set(get_args(Metric)) == {*UNITS, *SIZING_UNITS}
    assert [unit_of(name) for name in SIZING_UNITS] == [*SIZING_UNITS.values()]


def test_the_cycle_of_the_scenario_is_what_is_sized(study):
    assert sized_candidate(PRESENT, study).rig.run.profile == "duty_cycle"
    chosen = {**study.document.data, "operating_point": {**study.document.data["operating_point"], "profile": "ramp"}}
    ramp = replace(study.document, data=chosen)
    assert with_cycle(ramp) is ramp


@pytest.mark.long
def test_a_study_measures_what_its_criteria_ask_for(study):
    rows = {
        name: CriterionRow(
            metric=name, unit=unit_of(name), better="less", weight=0.1, points={0.0: 5, 1.0: 1}, purpose=""
        )
        for name in ("thermal_use", "residual_disturbance", "sensor_overload")
    }
    asked = replace(study, settings=study.settings.model_copy(update={"criteria": rows, "requirements": {}}))
    assert [one.name for one in criteria_of(asked)] == list(rows)
    found = run_drive(PRESENT, asked)
    assert found.margins["sensor_overload"].low == pytest.approx(0.97 / 2)  # 2 N m x 5 x 0.97 over 10 N m x 200 %
    assert (
        found.margins["thermal_use"].shown() == sizing_figures(PRESENT, asked, ["thermal_use"])["thermal_use"].shown()
    )
    left = {name: chain.residual_disturbance.value for name, chain in found.chains.items()}
    assert left["order_lines"] < 0.5 * left["none"]  # it takes the lines out
    plain = run_drive(PRESENT, study)
    assert "thermal_use" not in plain.margins
    assert plain.chains["none"].residual_disturbance.unknown


def test_an_empty_chain_leaves_the_disturbance_as_it_is(study):
    rig = scenario_of(PRESENT, study, seed=1).rig
    both = simulated_reading_pair(rig, duration=1.0, seed=1, settling=0.5)
    assert both.residual_rms(Chain(name="none", stages=())) == pytest.approx(both.before, rel=1e-12)
    assert both.before > 0.05


def test_swept_and_closed_form_agree_where_the_gearbox_adds_nothing(study):
    drive = sized_candidate(PRESENT, study)
    sweep = ratio_sweep(drive, study)
    assert [one.ratio for one in sweep.swept] == sorted(one.ratio for one in sweep.swept)
    own = next(one for one in sweep.swept if one.gearbox == "reference-5-1")
    friction = 0.015 + 1.5e-4 * 104.7  # of the present motor, which the closed form leaves out
    assert sweep.ideal.rms_torque(5.0) == pytest.approx(middle(own.rms_torque), abs=friction)
    assert sweep.best is not None
    assert middle(sweep.best.rms_torque) == min(middle(one.rms_torque) for one in sweep.swept if not one.exceeded)
    assert "yaskawa-100W-5" in {one.gearbox for one in sweep.swept if "gearbox_life_use" in one.exceeded}
