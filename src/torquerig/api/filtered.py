"""``filter``: a recording through a filter chain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from torquerig.api.inputs import drive_from, recording_from
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.errors import InputError, did_you_mean
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.recorded_drive import chains_for


def filter(  # noqa: A001 (the public name; this module does not use the built-in)
    recording: Recording | str | Path, chain: str = "order_lines", *, filters: str | Path | None = None,
    motor: str | None = None, ratio: float | None = None, gearbox: str | None = None,
    scenario: Scenario | str | Path | None = None, channel: str | None = None, catalogs: Sequence[str | Path] = (),
) -> Recording:  # fmt: skip
    """Return a recording after a filter chain.

    Parameters
    ----------
    recording : Recording, or path of its file
    chain : str
        Name of the filter chain in ``filters``.
    filters : str or Path, optional
        A YAML file of filter chains; the shipped ``filters.yaml`` without it.
    motor : str, optional
        Motor of the catalog whose order lines are removed, where the run does not name it.
    ratio : float, optional
        Motor turns per output turn [1], where the run does not state it.
    gearbox : str, optional
        Gearbox of the catalog, for its ratio and its gear mesh lines.
    scenario : Scenario or path, optional
        The rig, instead of the three above: the lines of all its shafts, meshes, belts and bearings.
    channel : str, optional
        Channel with the measured torque, where several have one and none has the role ``compared``.
    catalogs : sequence of path
        Further catalog folders.

    Returns
    -------
    Recording
        With the torque channel filtered; the other channels are unchanged.

    Raises
    ------
    InputError
        For an unknown chain, or a scenario together with motor, ratio or gearbox.
    RecordingError
        Where the recording does not tell the speed or angle that the chain needs.

    Examples
    --------
    >>> import torquerig as tr
    >>> rec = tr.simulate("wear_rig.yaml", duration=2.0)
    >>> clean = tr.filter(rec, "order_lines")
    >>> bool(clean.torque().std() < rec.torque().std())
    True
    """
    read = recording_from(recording)
    read = read if channel is None else read.comparing(channel)
    drive = drive_from(read, scenario=scenario, motor=motor, ratio=ratio, gearbox=gearbox, catalogs=catalogs)
    read = replace(read, run=drive.run_of(read.run))
    known = chains_for(drive, Path(filters) if filters else shipped_scenarios() / "filters.yaml", (chain,))
    if chain not in known:
        raise InputError(f"there is no filter chain {chain!r}; {did_you_mean(chain, known)}")
    return known[chain].apply(read)
