"""A catalog that leaves counts open gives a scenario once for each rig that they allow."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import Document, read_document
from torquerig.scenario.catalog_values.readings import other_readings
from torquerig.scenario.reading import read_scenario

STATED = "bldc-12n14p, torque_limit: 2.0 N*m"


def wear_rig_with(motor: str, folder: Path) -> Document:
    text = (shipped_scenarios() / "wear_rig.yaml").read_text(encoding="utf-8").split("study:")[0]
    assert STATED in text
    path = folder / "rig.yaml"
    path.write_text(text.replace(STATED, motor), encoding="utf-8")
    return read_document(path)


@pytest.mark.long
@pytest.mark.parametrize("seed", [0, 7])
def test_each_set_of_counts_is_read_once(seed: int, tmp_path: Path) -> None:
    """A class of motors with 4 or 5 pole pairs and 9 or 12 slots: the one that was drawn, and three others."""
    document, catalog = wear_rig_with("ESM06X-401-302", tmp_path), load_catalog(shipped_folder())
    drawn, others = read_scenario(document, catalog, seed=seed), other_readings(document, catalog, seed=seed)
    counts = [(one.choices()["motor.pole_pairs"], one.choices()["motor.slots"]) for one in (drawn, *others)]
    assert sorted(counts) == [(4, 9), (4, 12), (5, 9), (5, 12)]
    names = {tuple(part.name for part in one.rig.parts) for one in (drawn, *others)}
    assert len(names) == 2, "the lines of a winding stand at 2p and 6p"


def test_where_all_counts_are_stated_there_is_one_reading(tmp_path: Path) -> None:
    document, catalog = wear_rig_with(STATED, tmp_path), load_catalog(shipped_folder())
    assert read_scenario(document, catalog, seed=0).choices() == {}
    assert other_readings(document, catalog, seed=0) == ()
