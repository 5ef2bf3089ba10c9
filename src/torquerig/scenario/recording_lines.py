"""The order lines that the motor and gearbox of a recording can have."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING

from torquerig.catalog.winding import winding_of
from torquerig.errors import InputError
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.teeth_reading import read_teeth

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog
    from torquerig.orders.kinematics.teeth import Teeth
    from torquerig.recordings.recording import Recording


def kinematics_of_recording(
    recording: Recording, catalog: Catalog, *, motor: str | None = None, ratio: float | None = None,
    gearbox: str | None = None, remedies: tuple[str, str] = ("--motor NAME", "--ratio N"),
) -> tuple[Kinematics, tuple[str, ...]]:  # fmt: skip
    """Return the kinematics of the drive that made a recording, and one sentence for each thing that is not stated.

    Without a motor the lines of its poles and slots are left out; without a ratio the output shaft is taken to turn
    with the motor.

    Parameters
    ----------
    recording : Recording
        Its run states motor, gear ratio and maybe pole pairs and slots.
    motor, ratio, gearbox
        Go before what the run states; a gearbox of the catalog brings its ratio and its teeth.
    remedies : tuple of str
        How the caller takes a motor and a ratio, for the sentences.

    Raises
    ------
    UnknownNameError
        Where the catalog has no such motor or gearbox.
    InputError
        For teeth in the sidecar that are no set of teeth, or contradict the ratio.
    """
    box = catalog.gearbox(gearbox) if gearbox else None
    turns = ratio if ratio is not None else box.ratio if box else recording.run.gear_ratio
    name = motor or recording.run.motor
    said = []
    pole_pairs, slots = None, None
    if name is not None:
        pole_pairs, slots, assumed = winding_of(catalog.motor(name))
        said += [f"assumed of {name}: {assumed}"] if assumed else []
    stated = recording.run.others
    if motor is None and isinstance(stated.get("pole_pairs"), int):
        pole_pairs, slots = stated["pole_pairs"], stated.get("slots")
        said = []
    elif name is None:
        said.append(
            f"the motor is not stated, so the lines of its poles and slots are not known; add {remedies[0]}, or run: "
            "{motor: NAME} to the sidecar"
        )
    teeth = box.tooth_sets()[:1] if box else _stated_teeth(recording)
    if turns is None and teeth:
        turns = prod(stage.ratio for stage in teeth)
    if turns is None:
        said.append(
            f"no gear ratio is stated, so the output shaft is taken to turn with the motor; add {remedies[1]}, or run: "
            "{gear_ratio: NUMBER} to the sidecar"
        )
    return Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=turns or 1.0, teeth=teeth), tuple(said)


def _stated_teeth(recording: Recording) -> tuple[Teeth, ...]:
    """Return the gear stages that the sidecar states, from the motor to the output."""
    written = recording.run.others.get("teeth")
    try:
        return () if written is None else read_teeth(written)
    except InputError as error:
        raise InputError(f"{recording.name}: teeth in the sidecar: {error}") from None
