"""``read_scenario``: a rig from its scenario file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from torquerig.api.values import folders, settings_of
from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import read_document
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden


def read_scenario(
    path: str | Path, *, changes: Mapping[str, Any] | None = None, motor: str | None = None, gearbox: str | None = None,
    catalogs: Sequence[str | Path] = (), seed: int = 1,
) -> Scenario:  # fmt: skip
    """Return the rig that a scenario file describes.

    Parameters
    ----------
    path : str or Path
        The file; the name of a shipped scenario serves too where there is no such file.
    changes : mapping of str to value, optional
        Values to change without editing the file, by the end of their dotted path.
    motor, gearbox : str, optional
        Another entry of the catalog, run as the scenario's study would run it.
    catalogs : sequence of path
        Further catalog folders; they go before the shipped one.
    seed : int
        Fixes what is drawn where the catalog has only an interval.

    Returns
    -------
    Scenario
        Frozen; ``scenario + tr.mechanisms.GearMesh(...)`` is the rig with one more effect.

    Raises
    ------
    InputError
        With file, line, key and remedy, for everything that cannot be used.

    Examples
    --------
    >>> import torquerig as tr
    >>> rig = tr.read_scenario("wear_rig.yaml", changes={"load.occupancy": 0})
    >>> rig.rig.run.occupancy_percent
    0.0
    """
    from torquerig.study.one_drive import scenario_or_candidate

    file = scenario_file(path)
    document = overridden(read_document(file), settings_of(changes))
    return scenario_or_candidate(
        document, catalog_for(file, folders(catalogs)), motor=motor, gearbox=gearbox, seed=seed
    )  # fmt: skip


def scenario_file(path: str | Path) -> Path:
    """Return the file of a scenario: as named, or among the shipped scenarios."""
    named = Path(path)
    shipped = shipped_scenarios() / named.name
    return shipped if not named.exists() and named == Path(named.name) and shipped.is_file() else named
