"""What is known of the drive that made a recording: from a scenario, from the catalog, or from the sidecar."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.filters.chains.chain_file import needs_response, read_chains
from torquerig.orders.angle.measured_angle import has_motion
from torquerig.rig.parts import InductionDrive
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.load_response import load_response
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.recorded.recording_lines import SAME_RATIO, kinematics_of_recording
from torquerig.simulation.sampling import SAMPLE_RATE

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.orders.kinematics.kinematic_lines import Kinematics
    from torquerig.recordings.recording import Recording
    from torquerig.recordings.run import Run
    from torquerig.rig.assembly import Rig


@dataclass(frozen=True, kw_only=True)
class RecordedDrive:
    """The drive that made a recording.

    Parameters
    ----------
    kinematics : Kinematics
        Its shafts and lines.
    rig : Rig or None
        The rig of the scenario, where one is given.
    sample_rate : float
        Of the recording [Hz].
    assumed : tuple of str
        One sentence for each thing that nothing states.
    """

    kinematics: Kinematics
    rig: Rig | None = None
    sample_rate: float = SAMPLE_RATE
    assumed: tuple[str, ...] = ()

    def run_of(self, run: Run) -> Run:
        """Return ``run`` with the travel per turn of the scenario's rig, where one is given and the run states none."""
        travel = None if self.rig is None else self.rig.run.travel_per_turn
        return run if travel is None or run.travel_per_turn is not None else replace(run, travel_per_turn=travel)


def recorded_drive(
    recording: Recording, *, scenario: Path | None = None, motor: str | None = None, ratio: float | None = None,
    gearbox: str | None = None, catalogs: Sequence[Path] = (),
    remedies: tuple[str, str] = ("--motor NAME", "--ratio N"),
) -> RecordedDrive:  # fmt: skip
    """Return the drive that made ``recording``; a scenario or a gearbox of the catalog goes before the sidecar.

    Parameters
    ----------
    recording : Recording
        Its run may state motor, gear ratio, poles, slots and teeth.
    scenario : Path, optional
        The scenario of the rig.
    motor, gearbox : str, optional
        Of the catalog.
    ratio : float, optional
        Motor turns per output turn [1].
    catalogs : sequence of Path
        Further catalog folders.
    remedies : tuple of str
        How the caller takes a motor and a ratio, for the sentences.

    Raises
    ------
    InputError
        Where a scenario is given together with one of the others, or its gears contradict the sidecar's ratio.
    """
    if scenario is None:
        kinematics, assumed = kinematics_of_recording(
            recording, catalog_for(None, catalogs), motor=motor, ratio=ratio, gearbox=gearbox, remedies=remedies
        )
        return RecordedDrive(kinematics=kinematics, sample_rate=recording.sample_rate, assumed=assumed)
    if motor is not None or ratio is not None or gearbox is not None:
        raise InputError("--scenario states motor and gearbox; remove --motor, --ratio and --gearbox")
    rig = read_scenario(read_document(scenario), catalog_for(scenario, catalogs), seed=1).rig
    kinematics = at_stated_ratio(kinematics_of(rig), recording, scenario)
    refuse_other_travel(rig, recording, scenario)
    slipping = _slipping(rig, recording)
    return RecordedDrive(kinematics=kinematics, rig=rig, sample_rate=recording.sample_rate, assumed=slipping)


def _slipping(rig: Rig, recording: Recording) -> tuple[str, ...]:
    """Return the sentence that the set-point of an induction motor is not the speed of its shaft, where it counts."""
    if has_motion(recording) or not rig.parts_of(InductionDrive):
        return ()
    sentence = (
        "the set-point of an induction motor is the speed of its field, the shaft turns slower by the slip, and no "
        "channel measures its angle or speed: lines at orders of the shaft are only near; record a tacho or an encoder"
    )
    return (sentence,)


def at_stated_ratio(kinematics: Kinematics, recording: Recording, scenario: str | Path) -> Kinematics:
    """Return the kinematics; InputError where the recording's sidecar states another gear ratio than the scenario."""
    stated = recording.run.gear_ratio
    if stated is not None and abs(kinematics.ratio / stated - 1) > SAME_RATIO:
        raise InputError(
            f"{recording.name}: the sidecar states gear_ratio: {stated:g}, and the gears of {scenario} give "
            f"{kinematics.ratio:g}; correct one of them"
        )
    return kinematics


def refuse_other_travel(rig: Rig, recording: Recording, scenario: str | Path) -> None:
    """Raise InputError where the recording's sidecar states another travel per turn than the rig's screw has."""
    stated, travel = recording.run.travel_per_turn, rig.run.travel_per_turn
    if stated is not None and travel is not None and abs(travel / stated - 1) > SAME_RATIO:
        raise InputError(
            f"{recording.name}: the sidecar states travel_per_turn_mm: {1e3 * stated:g}, and {scenario} gives "
            f"{1e3 * travel:g} mm; correct one of them"
        )


def chains_for(drive: RecordedDrive, filters: Path, names: Sequence[str]) -> Mapping[str, Chain]:
    """Return the filter chains of a file for one drive; with a rig the load inverse has its model.

    ``names`` are the chains that are wanted: the model is computed only where one of them needs it.
    """
    document = read_document(filters)
    has_model = drive.rig is not None and needs_response(document, names)
    response = load_response(drive.rig, rate=drive.sample_rate) if has_model and drive.rig is not None else None
    return read_chains(document, kinematics=drive.kinematics, response=response)
