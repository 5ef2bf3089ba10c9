"""One reader for many seeds: the scenarios of separate readings, and nothing of an earlier seed."""

from __future__ import annotations

from dataclasses import fields

import pytest

from torquerig.catalog.chosen_draws import ChosenDraws
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import ScenarioReader, read_scenario

CATALOG = load_catalog(shipped_folder())
RIGS = [path for path in sorted(shipped_scenarios().glob("*.yaml")) if "rig" in read_document(path).data]


def content(scenario: Scenario) -> str:
    """Return everything that was read but the file and the catalog, which are the same."""
    return repr([getattr(scenario, one.name) for one in fields(scenario) if one.name not in ("document", "catalog")])


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_a_reader_gives_what_a_new_reading_gives(path) -> None:
    document = read_document(path)
    reader = ScenarioReader(document, CATALOG)
    for seed in (1, 2, 3, 1):
        assert content(reader.at(seed)) == content(read_scenario(document, CATALOG, seed=seed))


def test_stated_quantiles_and_the_names_of_draws_are_those_of_a_new_reading() -> None:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    reader = ScenarioReader(document, CATALOG)
    for quantiles in ({}, {"HDS6A-0104A.rotor_inertia": 0.9}, {"HDS6A-0104A.winding": 0.1}):
        one, other = ChosenDraws(4, quantiles), ChosenDraws(4, quantiles)
        assert content(reader.at(one)) == content(read_scenario(document, CATALOG, seed=other))
    first = ChosenDraws(5)
    ScenarioReader(document, CATALOG).at(first)
    assert list(first.drawn) == list(_drawn_by_a_reading(document))


def _drawn_by_a_reading(document) -> dict[str, None]:
    seed = ChosenDraws(6)
    read_scenario(document, CATALOG, seed=seed)
    return seed.drawn


def test_an_interval_in_the_file_is_drawn_at_every_seed() -> None:
    text = (
        "measured: shaft\noperating_point: {motor_speed: 100 rpm, load: {occupancy: {low: 1 %, high: 9 %}}}\n"
        "rig:\n  motor: {kind: motor, inertia: 1e-4 kg*m^2, torque_limit: 1 N*m}\n"
        "  shaft: {kind: coupling, stiffness: {low: 100 N*m/rad, high: 900 N*m/rad}, damping: 0.1 N*m*s/rad}\n"
        "  load: {kind: body, inertia: 1e-3 kg*m^2}\n"
    )
    reader = ScenarioReader(parse_document(text, RIGS[0].with_name("drawn.yaml")), CATALOG)
    made = [reader.at(seed) for seed in (1, 2)]
    assert len({one.rig.part("shaft").stiffness for one in made}) == 2  # type: ignore[attr-defined]
    assert len({one.operating_point.load.occupancy for one in made}) == 2
    assert made[0].rig.part("load") is made[1].rig.part("load")  # which draws nothing, and is not read again


def test_an_error_is_the_same_at_every_seed() -> None:
    text = "measured: motor\nrig:\n  motor: {kind: motor, inertia: 1e-4, torque_limit: 1 N*m}\n"
    reader = ScenarioReader(parse_document(text, RIGS[0].with_name("wrong.yaml")), CATALOG)
    said = []
    for seed in (1, 2):
        with pytest.raises(InputError, match=r"wrong\.yaml:3: rig\.motor\.inertia: 0\.0001 has no unit") as caught:
            reader.at(seed)
        said.append(str(caught.value))
    assert said[0] == said[1]
