"""The shipped purchase question: every candidate of ``bldc_or_servo.yaml`` gets its ripple from its phases."""

from __future__ import annotations

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import FieldOrientedControl, SixStepCommutation
from torquerig.rig.host_changes import DriveRipple, waves_of
from torquerig.rig.parts import MotorPhases
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import open_study

CATALOG = load_catalog(shipped_folder())
STUDY = open_study(read_document(shipped_scenarios() / "bldc_or_servo.yaml"), CATALOG)


@pytest.mark.long
def test_each_candidate_has_the_commutation_of_its_kind_and_the_brushless_one_the_deepest() -> None:
    """At 2.5:1 and 5:1, for two drawn copies: no servo reaches half of the brushless motor's 6p."""
    for seed in (1, 2):
        depth: dict[str, float] = {}
        for candidate in candidates(STUDY):
            rig = scenario_of(candidate, STUDY, seed=seed).rig
            commutation = rig.part("motor.commutation")
            brushless = CATALOG.motor(candidate.motor).kind == "bldc"
            assert isinstance(commutation, SixStepCommutation if brushless else FieldOrientedControl)
            (phases,) = rig.parts_of(MotorPhases)
            waves = {wave.order: wave.amplitude for wave in waves_of(commutation.changes_in_host(rig), DriveRipple)}
            depth[candidate.name] = waves.get(6.0 * phases.pole_pairs, 0.0)
        for ratio in ("2.5:1", "5:1"):
            brushless = depth.pop(f"bldc-12n14p {ratio}")
            assert brushless > 0.05
            assert all(share < 0.5 * brushless for name, share in depth.items() if name.endswith(f" {ratio}"))


def test_the_scenario_is_the_wear_rig_but_for_the_ripple() -> None:
    """Its parts and their values are kept beside those of wear_rig.yaml by hand; this holds them together."""
    wear = read_document(shipped_scenarios() / "wear_rig.yaml").data
    own = read_document(shipped_scenarios() / "bldc_or_servo.yaml").data
    motor = {key: value for key, value in own["rig"]["motor"].items() if key != "ripple"}
    assert {**own["rig"], "motor": motor} == wear["rig"]
    assert own["operating_point"] == {key: wear["operating_point"][key] for key in own["operating_point"]}
