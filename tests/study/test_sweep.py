"""A study at several values of quantities of its scenario: which points are computed, and what is refused."""

import re

import pytest
from click.testing import CliRunner

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli.compare import command
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.scenario.overrides import overridden
from torquerig.scenario.sections import read_operating_point
from torquerig.study.sweep import sweep, sweep_axes

SCENARIO = shipped_scenarios() / "wear_rig.yaml"
SMALL = ("study.draws=3", "study.motors=[bldc-12n14p]")


@pytest.fixture(scope="module")
def document():
    return overridden(read_document(SCENARIO), SMALL)


def test_every_combination_is_computed_with_one_sample_each(document):
    axes = sweep_axes(document, ["load.occupancy=5 %,11 %", "operating_point.output_speed=[100 rpm, 200 rpm]"])
    seen = []

    def run(study, title):
        point, _ = read_operating_point(study.document, seed=1)
        seen.append((title, point.load.occupancy, study.document.data["operating_point"]["output_speed"]))
        assert study.settings.draws == 0
        return study

    points = sweep(document, load_catalog(shipped_folder()), axes, run=run)
    assert [one.values for one in points] == [
        {"load.occupancy": occupancy, "operating_point.output_speed": speed}
        for occupancy in ("5 %", "11 %") for speed in ("100 rpm", "200 rpm")
    ]  # fmt: skip
    assert seen[1:3] == [("point 2 of 4", 5.0, "200 rpm"), ("point 3 of 4", 11.0, "100 rpm")]
    assert points[0].text == "load.occupancy 5 %, operating_point.output_speed 100 rpm"


def test_a_scenario_may_state_its_sweep_and_without_one_nothing_is_computed(document):
    assert sweep_axes(document) == {}
    assert sweep(document, load_catalog(shipped_folder()), {}, run=None) == ()
    stated = overridden(document, ["study.sweep={load.occupancy: [6, 8, 11]}"])
    assert sweep_axes(stated) == {"load.occupancy": ("6", "8", "11")}
    assert sweep_axes(stated, ["load.occupancy=5,7"]) == {"load.occupancy": ("5", "7")}  # the option counts


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("load.occupancy", "not of the form path=value,value"),
        ("load.occupancy=5", "needs two or more different values"),
        ("load.occupancy=5,5", "needs two or more different values"),
        ("load.occupancy=[5, [6]]", "needs two or more different values"),
        ("load.occupancy=" + ",".join(map(str, range(1, 50))), "the sweep has 49 points"),
    ],
)
def test_a_sweep_that_cannot_be_used_is_refused_with_an_example(document, written, said):
    with pytest.raises(InputError, match=re.escape(said)):
        sweep_axes(document, [written])


def test_a_wrong_path_or_value_is_refused_before_the_first_run(document):
    catalog = load_catalog(shipped_folder())
    with pytest.raises(InputError, match=r"load\.occupancyy"):
        sweep(document, catalog, {"load.occupancyy": ("5", "6")}, run=None)
    with pytest.raises(InputError, match=r"study\.sweep"):
        sweep_axes(overridden(document, ["study.sweep={load.occupancy: [6]}"]))


def test_the_command_refuses_a_sweep_of_all_points(monkeypatch):
    monkeypatch.setattr("torquerig.cli.compare.run_study", None)  # nothing is simulated
    found = CliRunner().invoke(command, [str(SCENARIO), "--all-points", "--sweep", "load.occupancy=5,6"])
    assert isinstance(found.exception, InputError | SystemExit)
    assert "remove --all-points" in str(found.exception) + found.output
