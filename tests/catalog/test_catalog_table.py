"""The rows of the catalog command: documented values as numbers, the rest as a question mark with what is known."""

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.catalog.table import catalog_tables, motor_rows

CATALOG = load_catalog(shipped_folder())


def test_a_documented_value_is_a_number_and_an_unknown_one_a_question_mark_with_its_interval():
    row = next(row for row in motor_rows(CATALOG) if row["name"] == "HDS6A-0104A")
    assert (row["rated torque"], row["max speed"]) == ("1.27 N*m", "6000 rpm")
    assert row["inertia"] == "? (0.17..0.7 kg*cm^2)"
    assert (row["pole pairs"], row["slots"]) == ("? (4 or 5)", "? (9 or 12)")
    assert row["also listed as"] == "HDS6A-104A"


def test_every_entry_has_one_row_with_the_same_columns():
    for shelf, rows in catalog_tables(CATALOG).items():
        assert [row["name"] for row in rows] == [*getattr(CATALOG, shelf)]
        assert len({tuple(row) for row in rows}) == 1
        assert not [row for row in rows if "e+" in "".join(row.values())]
