"""The published table of mechanisms that can be named agrees with the hypotheses and with the library."""

from __future__ import annotations

from pathlib import Path
from pkgutil import iter_modules

from torquerig import mechanisms
from torquerig.inference import additions, sample_faults

TABLE = Path(__file__).parents[2] / "docs" / "nameable-mechanisms.md"
FEWEST = 30  # mechanisms that can be named


def rows(heading):
    """Return the cells of the table under a heading, by mechanism."""
    section = TABLE.read_text(encoding="utf-8").split(f"## {heading}\n")[1].split("\n## ")[0]
    cells = [[cell.strip() for cell in line.strip("|\n ").split("|")] for line in section.splitlines() if "|" in line]
    return {name: others for name, *others in cells[2:]}


def test_every_mechanism_is_in_one_of_the_two_tables():
    named, others = rows("Named"), rows("Not named")
    assert not named.keys() & others.keys()
    assert named.keys() | others.keys() == {each.name for each in iter_modules(mechanisms.__path__)}
    assert all(reason for (reason,) in others.values())


def test_the_table_has_what_the_hypotheses_can_name():
    able = {name for module in additions.modules() for name in additions.names_of(module)} | set(sample_faults.NAMES)
    assert rows("Named").keys() == able
    assert len(able) >= FEWEST
