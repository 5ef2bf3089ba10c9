"""A study on any chain: the motor, or one named stage, is exchanged; the other stages stay as they are."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import TorquerigError
from torquerig.metrics.sizing.drive_sizing import sizing
from torquerig.rig.parts import BeltStage, Gear, Motor
from torquerig.scenario.kinematics import kinematics_of, torque_gain
from torquerig.scenario.mean_load import mean_load
from torquerig.study.candidates import candidate_of, candidates, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.exchanged_data import look_up_stage
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.study.ratio_sweep import can_sweep
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide
from torquerig.study.sized_candidates import sized_candidate
from torquerig.study.verdict import verdict

CATALOG = load_catalog(shipped_folder())
BELT = (
    "kind: belt, pinion_teeth: 20, wheel_teeth: 50, belt_teeth: 120, pitch: 5 mm, belt_stiffness: 132.5 kN, "
    "strand_damping: 253 N*s/m, efficiency: 0.96, wheel_inertia: 12 kg*cm^2"
)
WIDER = BELT.replace("wheel_teeth: 50, belt_teeth: 120", "wheel_teeth: 60, belt_teeth: 130")
BOX = "gearbox: {kind: gear, catalog: reference-5-1}"
CHAIN = (BOX, f"belt: {{{BELT}}}")
RULES = """\
  duration: 0.5 s
  filters: {file: filters.yaml, names: [none, order_lines]}
  speed_loop: {crossover: 20 Hz, integral_corner: 1.0 Hz}
  sensor_limit: 10 N*m
  requirements:
    speed reserve: {metric: speed_reserve, unit: "1", min: 1.0, purpose: speed}
  criteria:
    error: {metric: truth_error, unit: N*m, better: less, weight: 0.6, points: {0.0: 5, 1.0: 1}, purpose: small}
    price: {metric: price, unit: EUR, better: less, kind: economic, weight: 0.4, points: {0: 5, 900: 1}, purpose: p}
"""


def study_of(*stages: str, study: str, load: str = "drum", sensor: str = "") -> Study:
    listed = "\n".join(f"  {one}" for one in stages)
    text = f"""\
operating_point: {{output_speed: 60 rpm, load: {{occupancy: 5 %}}}}
measured: torque_sensor
rig:
  motor: {{kind: motor, catalog: HDS6A-0104A}}
{listed}
  torque_sensor: {{kind: torque_sensor, catalog: reference-10nm{sensor}}}
  coupling: {{kind: coupling, catalog: bellows-10nm, damping: 0.3 N*m*s/rad}}
  drum: {{kind: body, inertia: 50 kg*cm^2, viscous: 0.02 N*m*s/rad}}
  speed_controller: {{kind: speed_controller, kp: 0.06 N*m*s/rad, ki: 0.6 N*m/rad}}
  load: {{kind: particle_load, at: {load}, mean_by_occupancy_percent: {{0: 0.05 N*m, 5: 1.5 N*m}}}}
study:
{study}
{RULES}"""
    return open_study(parse_document(text, shipped_folder().parent / "scenarios" / "chain.yaml"), CATALOG)


EXCHANGED = f"""\
  exchange: {{stage: belt}}
  present: {{motor: HDS6A-0104A, gearbox: belt}}
  motors: [HDS6A-0104A, ESM06X-401-302]
  gearboxes: [belt, spur-2.5-1, belt-3]
  stages: {{belt-3: {{price: 45 EUR, part: {{{WIDER}}}}}}}
"""


def test_one_named_stage_is_exchanged_and_names_say_its_ratio_and_the_whole_one() -> None:
    study = study_of(*CHAIN, study=EXCHANGED)
    listed = candidates(study)
    assert [one.name for one in listed[:3]] == [
        "HDS6A-0104A belt 2.5:1 of 12.5:1", "HDS6A-0104A spur-2.5-1 2.5:1 of 12.5:1", "HDS6A-0104A 3:1 of 15:1"
    ]  # fmt: skip
    assert [one.whole_ratio for one in listed[:3]] == pytest.approx([12.5, 12.5, 15.0])
    for one in listed:
        rig = scenario_of(one, study, seed=1).rig
        assert kinematics_of(rig).ratio == pytest.approx(one.whole_ratio)
        assert isinstance(rig.part("belt"), Gear if one.gearbox == "spur-2.5-1" else BeltStage)
        assert rig.part("gearbox") == scenario_of(listed[0], study, seed=1).rig.part("gearbox")
        motor = rig.part("motor")
        assert isinstance(motor, Motor)
        assert motor.model == one.motor
        assert motor.torque_limit * torque_gain(rig) <= 10 * (1 + 1e-12)


@pytest.mark.long
def test_a_study_of_a_belt_behind_a_gearbox_is_simulated_ranked_and_reported(tmp_path: Path) -> None:
    from torquerig.reporting.study.report import write_study_report

    study = study_of(*CHAIN, study=EXCHANGED)
    runs = run_study(study, workers=1)
    decided = decide(runs)
    assert decided.baseline == "HDS6A-0104A belt 2.5:1 of 12.5:1 | none"
    prices = {drive.candidate.gearbox: drive.margins["price"] for drive in runs.drives[:3]}
    assert (prices["belt"].value, prices["belt-3"].value) == (0.0, 45.0)
    assert prices["spur-2.5-1"].low is not None
    assert runs.mean_load == pytest.approx(1.5 + 0.02 * 2 * pi, rel=0.02)
    pages = write_study_report(runs, decided, verdict(decided), tmp_path / "report")
    text = pages[0].read_text(encoding="utf-8")
    assert "The exchanged stage is belt." in text
    assert "whole ratio" in pages[1].read_text(encoding="utf-8").splitlines()[0]


def test_a_belt_that_must_be_bought_and_has_no_price_leaves_the_price_open() -> None:
    study = study_of(*CHAIN, study=EXCHANGED.replace("price: 45 EUR, ", ""))
    assert look_up_stage("belt-3", study).price.unknown


def test_without_gearboxes_only_the_motor_is_exchanged_on_any_chain() -> None:
    for stages, name in (((), "ESM06X-401-302"), (CHAIN, "ESM06X-401-302 12.5:1")):
        study = study_of(*stages, study="  present: {motor: HDS6A-0104A}\n  motors: [HDS6A-0104A, ESM06X-401-302]\n")
        assert [one.name for one in candidates(study)][1] == name
        assert not can_sweep(study)
        made = scenario_of(candidates(study)[1], study, seed=1)
        assert kinematics_of(made.rig).ratio == pytest.approx(12.5 if stages else 1.0)


@pytest.mark.long
def test_a_direct_drive_is_compared_and_sized() -> None:
    study = study_of(study="  present: {motor: HDS6A-0104A}\n  motors: [HDS6A-0104A, ESM06X-401-302]\n")
    runs = run_study(study, workers=1)
    decided = decide(runs)
    assert decided.baseline == "HDS6A-0104A | none"
    assert runs.drives[1].margins["new_parts"].value == 3
    drive = sized_candidate(runs.drives[0].candidate, study)
    figures = sizing(drive, names=("rms_torque", "gearbox_life_use", "sensor_cycle_use", "inertia_ratio")).figures
    assert "gearbox_life_use" not in figures
    drag = 0.02 * 2 * pi
    cycle = figures["sensor_cycle_use"]
    assert [cycle.low, cycle.high] == pytest.approx([(1.5 + drag) / 10] * 2, rel=1e-3)


def test_a_load_before_the_sensor_is_referred_to_its_shaft_and_must_be_driven_too() -> None:
    """Power balance: what the motor gives is the mean load over the torque gain, wherever the load acts."""
    behind = study_of(*CHAIN, study=EXCHANGED)
    before = study_of(*CHAIN, study=EXCHANGED, load="gearbox")
    rigs = [scenario_of(candidates(one)[0], one, seed=1).rig for one in (behind, before)]
    drag = 0.02 * 2 * pi
    assert mean_load(rigs[0]) == pytest.approx(1.5 + drag, rel=1e-6)
    assert mean_load(rigs[1]) == pytest.approx(1.5 * 2.5 * 0.96 + drag, rel=1e-6)


def test_the_options_exchange_the_named_stage() -> None:
    document = study_of(*CHAIN, study=EXCHANGED).document
    made = scenario_or_candidate(document, CATALOG, motor=None, gearbox="spur-2.5-1", seed=1)
    assert isinstance(made.rig.part("belt"), Gear)
    assert kinematics_of(made.rig).ratio == pytest.approx(12.5)
    other = scenario_or_candidate(document, CATALOG, motor="ESM06X-401-302", gearbox=None, seed=1)
    assert isinstance(other.rig.part("belt"), BeltStage)
    assert candidate_of(open_study(document, CATALOG), motor="HDS6A-0104A", gearbox="belt-3").ratio == 3.0


@pytest.mark.parametrize(
    ("stages", "study", "told"),
    [
        (CHAIN, "  present: {motor: HDS6A-0104A}\n  gearboxes: [spur-2.5-1]\n",
         r"study: the rig has 2 parts that the study could exchange as its stage \(gearbox, belt\); name one with"),
        (CHAIN, "  exchange: {stage: blet}\n  present: {motor: HDS6A-0104A}\n  gearboxes: [spur-2.5-1]\n",
         r"chain\.yaml:\d+: study\.exchange\.stage: 'blet' is no gear, belt, worm or .*; did you mean 'belt'"),
        (CHAIN, "  exchange: {motor: drum}\n  present: {motor: HDS6A-0104A}\n",
         r"study\.exchange\.motor: 'drum' is no motor of the rig"),
        ((), "  present: {motor: HDS6A-0104A}\n  gearboxes: [spur-2.5-1]\n",
         r"study\.gearboxes: the rig has no gear, belt, worm or linear drive to exchange; leave gearboxes out"),
        ((), "  present: {motor: HDS6A-0104A, gearbox: spur-2.5-1}\n",
         r"study\.present\.gearbox: the study exchanges no stage, so 'spur-2.5-1' has no place"),
        (CHAIN, "  exchange: {stage: belt}\n  present: {motor: HDS6A-0104A}\n  gearboxes: [spur-2.5-2]\n",
         r"study\.gearboxes: .*spur-2.5-1.*and it is none of the scenario's stages \('belt'\)"),
        (CHAIN, EXCHANGED.replace("part: {kind: belt, ", "part: {kind: body, "),
         r"study\.stages\.belt-3\.part: 'body' is no kind of stage"),
    ],
)  # fmt: skip
def test_what_cannot_be_exchanged_is_refused_with_its_place(stages: tuple[str, ...], study: str, told: str) -> None:
    with pytest.raises(TorquerigError, match=told):
        candidates(study_of(*stages, study=study))
