"""A continuous ratio: a gearbox of the catalog's data with another ratio, refused where none is near."""

from __future__ import annotations

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.rig.parts import Gear
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidate_of, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.optimisation.bounds import Bounds
from torquerig.study.optimisation.scaled_gearbox import ratio_bounds
from torquerig.study.optimisation.search import optimised
from torquerig.study.optimisation.tried_drives import ScaledDrive

MOTOR, BOX = "bldc-12n14p", "reference-5-1"
SMALL = (
    f"study.motors=[{MOTOR}]", f"study.gearboxes=[{BOX}]", "study.draws=0", "study.duration=1 s",
    "study.filters.names=[none]", "study.present.filter=none", "recording.settling=2.5 s",
)  # fmt: skip


def study(*further: str, scenario: str = "wear_rig.yaml") -> Study:
    document = read_document(shipped_scenarios() / scenario)
    edits = (*SMALL, *further) if scenario == "wear_rig.yaml" else further
    return open_study(overridden(document, edits), load_catalog(shipped_folder()))


def test_only_the_ratio_and_the_teeth_differ_from_the_gearbox_of_the_catalog() -> None:
    asked = study()
    drive = ScaledDrive(asked, MOTOR, ratio_bounds(asked, 3.0, 9.0, [BOX])).at(6.5)
    known = scenario_of(candidate_of(asked, motor=MOTOR, gearbox=BOX), asked, seed=1)
    made, there = (one.rig.part("gearbox") for one in (drive.scenario, known))
    assert isinstance(made, Gear)
    assert isinstance(there, Gear)
    for field in ("efficiency", "stiffness", "damping", "backlash", "input_inertia"):
        assert getattr(made, field) == getattr(there, field)
    assert (made.ratio, made.teeth) == (6.5, ())
    assert drive.scenario.rig.run.speed == pytest.approx(6.5 / 5 * (known.rig.run.speed or 0))  # one output speed
    assert drive.candidate.name == f"{MOTOR} like {BOX} 6.5:1"


def test_at_the_ratio_of_the_catalog_the_reading_is_that_of_the_catalog_but_for_the_teeth() -> None:
    asked = study()
    drive = ScaledDrive(asked, MOTOR, ratio_bounds(asked, 3.0, 9.0, [BOX])).at(5.0)
    known = scenario_of(candidate_of(asked, motor=MOTOR, gearbox=BOX), asked, seed=1)
    for part in known.rig.parts:
        if part.name != "gearbox":
            assert drive.scenario.rig.part(part.name) == part


def test_the_nearest_gearbox_is_scaled() -> None:
    bounds = ratio_bounds(study(), 3.0, 35.0, [BOX, "GB060-20", "yaskawa-100W-21"])
    assert bounds.nearest(4.0) == BOX
    assert bounds.nearest(9.9) == BOX
    assert bounds.nearest(19.0) == "GB060-20"
    assert bounds.nearest(30.0) == "yaskawa-100W-21"


@pytest.mark.parametrize(
    ("low", "high", "boxes", "said"),
    [
        (9.0, 3.0, [BOX], "is no range of ratios"),
        (0.2, 3.0, [BOX], "motor turns per output turn from 1 on"),
        (3.0, 20.0, [BOX], r"the ratio 20 is more than 2 times away .*\(their ratios: 5\).*or write 3\.\.10"),
        (5.0, 80.0, [BOX, "GB060-20"], r"the ratio 80 is more than 2 times away"),
        (2.5, 12.0, ["spur-2.5-1", "GB060-20"], r"the ratio 7\.07 is more than 2 times away"),
        (3.0, 9.0, ["nothing"], "nothing is no gearbox of the catalog"),
    ],
)
def test_limits_that_cannot_be_are_refused(low: float, high: float, boxes: list[str], said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        ratio_bounds(study(), low, high, boxes)
    assert "\n" not in str(caught.value)


def test_a_study_without_a_gear_or_with_a_stated_ratio_has_no_continuous_one() -> None:
    with pytest.raises(InputError, match=r"gearbox\.ratio states the ratio; leave one of the two out"):
        ratio_bounds(study("gearbox.ratio=6"), 3.0, 9.0, [BOX])
    with pytest.raises(InputError, match="exchanges no stage; leave --ratio out"):
        ratio_bounds(study(scenario="shaft_line_design.yaml"), 3.0, 9.0, [])


@pytest.mark.long
def test_the_search_stays_within_the_ratios_and_reads_as_the_drive_alone() -> None:
    asked = study()
    bounds = Bounds(
        gearboxes=(BOX,), crossover=(8.0, 40.0), integral_corner=(0.5, 3.0), evaluations=48,
        ratio=ratio_bounds(asked, 3.0, 9.0, [BOX]),
    )  # fmt: skip
    found = optimised(asked, MOTOR, bounds)
    assert found.by_rule == ()
    ratios = [float(one.drive.split()[-1].removesuffix(":1")) for one in found.tried]
    assert min(ratios) >= 3.0
    assert max(ratios) <= 9.0
    assert len(set(ratios)) > 10
