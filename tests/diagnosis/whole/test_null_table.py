"""Thresholds belong to a scenario's content: to nothing that means nothing, and to everything that does."""

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.diagnosis.null_table import SHIPPED, NullTable, content_key, null_table, without_table
from torquerig.document import read_document
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario

WEAR_RIG = shipped_scenarios() / "wear_rig.yaml"


def read(path=WEAR_RIG, *settings, seed=0):
    return read_scenario(overridden(read_document(path), settings), load_catalog(shipped_folder()), seed=seed)


def test_title_comments_and_seed_do_not_count(tmp_path):
    text = WEAR_RIG.read_text(encoding="utf-8")
    copy = tmp_path / "copy.yaml"
    copy.write_text("# another comment\n" + text.replace("\nscenario:", "\nscenario: other # "), encoding="utf-8")
    assert content_key(read(copy)) == content_key(read()) == content_key(read(seed=3))


def test_a_default_that_is_written_out_does_not_count():
    """So a part that gains a field leaves the tables of scenarios without it as they are."""
    assert content_key(read(WEAR_RIG, "torque_sensor.noise_colour=0")) == content_key(read())
    assert content_key(read(WEAR_RIG, "torque_sensor.noise_colour=0.5")) != content_key(read())


@pytest.mark.parametrize("setting", ["gearbox.ratio=10", "torque_sensor.bandwidth=2 kHz"])
def test_a_value_counts(setting):
    assert content_key(read(WEAR_RIG, setting)) != content_key(read())


def test_what_is_drawn_from_an_interval_does_not_count():
    first, other = (read(shipped_scenarios() / "two_stage_branch.yaml", seed=seed) for seed in (0, 1))
    assert content_key(first) == content_key(other)


def test_a_table_is_found_by_content_alone(tmp_path):
    key = content_key(read())
    path = tmp_path / "tables.yaml"
    path.write_text(
        f"tables:\n- {{scenario: {key}, made_by: python -m proof --seed 1, seeds: [1], clean_rigs: 60, chance: 0.002,\n"
        "   thresholds: {gear_mesh: 55.5, backlash: 3}}\n",
        encoding="utf-8",
    )
    table = null_table(read(), path)
    assert table == NullTable(
        key=key, made_by="python -m proof --seed 1", seeds=(1,), clean_rigs=60, chance=0.002,
        thresholds={"gear_mesh": 55.5, "backlash": 3.0},
    )  # fmt: skip
    assert table.least_gain("gear_mesh", built_in=40.0) == 55.5
    assert table.least_gain("backlash", built_in=40.0) == 40.0  # clean gains never lower what was asked before
    assert table.least_gain("cogging", built_in=40.0) == 40.0
    assert null_table(read(WEAR_RIG, "gearbox.ratio=10"), path) is None
    assert null_table(read(), tmp_path / "none.yaml") is None
    assert key[:12] in without_table(read())


def test_the_shipped_tables_can_be_read_and_say_how_they_were_made():
    assert null_table(read()) is not None
    for row in read_document(SHIPPED).data["tables"]:
        assert row["made_by"].startswith("python -m proof.null")
        assert row["seeds"]
