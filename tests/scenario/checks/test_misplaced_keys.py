"""A key in the wrong place is refused whichever command reads the scenario, and its right place is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.scenario.reading import read_scenario

WEAR_RIG = (shipped_scenarios() / "wear_rig.yaml").read_text()
PLACES: dict[str, tuple[str, str, str]] = {
    # name: (what stands there, what is written instead, the place and what is said)
    "a mechanism under study": (
        "study:\n", "study:\n  ripple: {kind: torque_ripple, amplitudes: {1: 1 N*m}}\n",
        r"w\.yaml:\d+: study\.ripple: unknown key; a torque_ripple is part of the rig; move it to rig\.ripple",
    ),
    "a mechanism at the top level": (
        "study:\n", "mesh: {kind: gear_mesh}\nstudy:\n", r"w\.yaml:\d+: mesh: .* move it to rig\.mesh",
    ),
    "a mechanism under operating_point": (
        "  profile: steady\n", "  mesh: {kind: gear_mesh}\n", r"operating_point\.mesh: .* move it to rig\.mesh",
    ),
    "a set-point under study": (
        "study:\n", "study:\n  output_speed: 3 rpm\n", r"study\.output_speed: .*to operating_point\.output_speed",
    ),
    "a rule of the study at the top level": (
        "study:\n", "speed_loop: 3\nstudy:\n", r"speed_loop: .*move it to study\.speed_loop",
    ),
    "a section within another": (
        "study:\n", "study:\n  measured: torque_sensor\n", r"study\.measured: .*move it to the top level of the file",
    ),
    "a key of another part": (
        "catalog: reference-coupling}", "catalog: reference-coupling, noise_rms: 1 V}",
        r"rig\.coupling\.noise_rms: .*move it to rig\.torque_sensor\.noise_rms",
    ),
    "a key of a part that is not there": (
        "catalog: reference-coupling}", "catalog: reference-coupling, balls: 7}",
        r"rig\.coupling\.balls: .*only a part of kind bearing_defect has it",
    ),
    "a slip is a slip before it is misplaced": (
        "study:\n", "study:\n  sensor_limits: 3 N*m\n", r"study\.sensor_limits: .*did you mean 'sensor_limit'\?",
    ),
    "a value of the study": ("draws: 4", "draws: -4", r"w\.yaml:\d+: study\.draws: -4 is out of range"),
    "a study without its filters": ("  filters: {file", "  filter: {file", r"study\.filter: unknown key; did you mean"),
}  # fmt: skip


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


@pytest.mark.parametrize("name", PLACES)
def test_a_key_in_the_wrong_place_is_refused_and_its_place_named(name: str, catalog: Catalog) -> None:
    there, instead, said = PLACES[name]
    assert there in WEAR_RIG
    with pytest.raises(InputError, match=said):
        read_scenario(parse_document(WEAR_RIG.replace(there, instead, 1), Path("w.yaml")), catalog, seed=1)


def test_old_names_in_a_study_are_still_read(catalog: Catalog) -> None:
    old = WEAR_RIG.replace("  requirements:\n", "  demands:\n")
    assert read_scenario(parse_document(old, Path("w.yaml")), catalog, seed=1).title == "wear_rig"
