"""The order lines that the motor and gearbox of a recording can have."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING

from torquerig.catalog.winding import winding_of
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.teeth_reading import read_teeth

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog
    from torquerig.orders.kinematics.teeth import Teeth
    from torquerig.recordings.recording import Recording


SAME_RATIO = 0.02  # [1] relative deviation of a nominal ratio (5:1) from that of its teeth, as catalogs print it


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
    pole_pairs, slots, said = _winding(recording, catalog, motor, remedies[0])
    sets = box.tooth_sets() if box else _stated_teeth(recording)
    possible = sets if box and len(sets) > 1 else ()
    teeth = () if possible else sets
    if turns is None and teeth:
        turns = prod(stage.ratio for stage in teeth)
    if turns is None:
        said.append(
            f"no gear ratio is stated, so the output shaft is taken to turn with the motor; add {remedies[1]}, or run: "
            "{gear_ratio: NUMBER} to the sidecar"
        )
    stated = recording.run.gear_ratio
    if box and stated is not None and turns is not None and abs(turns / stated - 1) > SAME_RATIO:
        said.append(
            f"the sidecar states a gear ratio of {stated:g}; the lines are those of {turns:g}:1 ({gearbox}), as given"
        )
    kinematics = Kinematics(
        pole_pairs=pole_pairs, slots=slots, ratio=turns or 1.0, teeth=teeth, possible_teeth=possible,
        gear_unknown=turns is None,
    )  # fmt: skip
    return kinematics, tuple(said)


def _winding(
    recording: Recording, catalog: Catalog, motor: str | None, remedy: str
) -> tuple[int | None, int | None, list[str]]:
    """Return pole pairs and slots as given, else as the run states them, and what was assumed or is not known."""
    name = motor or recording.run.motor
    stated = recording.run.others
    if motor is None and isinstance(stated.get("pole_pairs"), int):
        return stated["pole_pairs"], stated.get("slots"), []
    if name is None:
        unknown = (
            f"the motor is not stated, so the lines of its poles and slots are not known; add {remedy}, or run: "
            "{motor: NAME} to the sidecar"
        )
        return None, None, [unknown]
    try:
        entry = catalog.motor(name)
    except UnknownNameError:
        near = did_you_mean(name, catalog.motors)
        if motor is not None or near.startswith("did you mean"):
            raise
        unlisted = (
            f"the sidecar's motor {name!r} is not in the catalog, so the lines of its poles and slots are not known; "
            f"add {remedy}, or run: {{pole_pairs: NUMBER, slots: NUMBER}} to the sidecar"
        )
        return None, None, [unlisted]
    pole_pairs, slots, assumed = winding_of(entry)
    return pole_pairs, slots, [f"assumed of {name}: {assumed}"] if assumed else []


def _stated_teeth(recording: Recording) -> tuple[Teeth, ...]:
    """Return the gear stages that the sidecar states, from the motor to the output."""
    written = recording.run.others.get("teeth")
    try:
        return () if written is None else read_teeth(written)
    except InputError as error:
        raise InputError(f"{recording.name}: teeth in the sidecar: {error}") from None
