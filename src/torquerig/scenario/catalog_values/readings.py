"""Alternatives of a scenario for the possible counts of the catalog, such as pole pairs and slots."""

from __future__ import annotations

from torquerig.catalog.reading import Catalog
from torquerig.document import Document
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

_DRAWS = 24  # of four equally likely rigs, all but one in a thousand are met
_MOST = 8  # readings: each costs a calibration


def other_readings(document: Document, catalog: Catalog, *, seed: int) -> tuple[Scenario, ...]:
    """Return the scenario with other samples, one for each set of lines other than that of ``seed``, at most seven.

    Empty where no count that determines lines is open.

    Raises
    ------
    InputError
        As ``read_scenario``.
    """
    first = read_scenario(document, catalog, seed=seed)
    if not first.choices():
        return ()
    found = {_lines(first): first}
    for other in range(seed + 1, seed + 1 + _DRAWS):
        drawn = read_scenario(document, catalog, seed=other)
        found.setdefault(_lines(drawn), drawn)
    return tuple(found.values())[1:_MOST]


def _lines(scenario: Scenario) -> tuple[float, ...]:
    """Return the orders of the motor at which the scenario's rig has lines [1/rev]."""
    return tuple(sorted({round(line.motor_order, 6) for line in kinematics_of(scenario.rig).lines()}))
