"""The order lines that the motor and gearbox of a recording can have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.catalog.winding import winding_of
from torquerig.errors import InputError
from torquerig.orders.kinematics.kinematic_lines import Kinematics

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog
    from torquerig.recordings.recording import Recording


def kinematics_of_recording(
    recording: Recording, catalog: Catalog, *, motor: str | None = None, ratio: float | None = None,
    gearbox: str | None = None, remedies: tuple[str, str] = ("--motor NAME", "--ratio N"),
) -> tuple[Kinematics, str]:  # fmt: skip
    """Return the kinematics of the drive that made a recording, and in words what was assumed of its motor.

    Parameters
    ----------
    recording : Recording
        Its run states motor, gear ratio and maybe pole pairs and slots.
    motor, ratio, gearbox
        Go before what the run states; a gearbox of the catalog brings its ratio and its teeth.
    remedies : tuple of str
        How the caller takes a motor and a ratio, for the error.

    Raises
    ------
    InputError
        Where neither the arguments nor the run state motor and ratio.
    UnknownNameError
        Where the catalog has no such motor or gearbox.
    """
    box = catalog.gearbox(gearbox) if gearbox else None
    turns = ratio if ratio is not None else box.ratio if box else recording.run.gear_ratio
    name = motor or recording.run.motor
    if turns is None or name is None:
        missing = remedies[1] if name else remedies[0]
        raise InputError(
            f"{recording.name}: the sidecar does not name the motor and gear_ratio of the run; add {missing}"
        )
    pole_pairs, slots, assumed = winding_of(catalog.motor(name))
    stated = recording.run.others
    if motor is None and isinstance(stated.get("pole_pairs"), int):
        pole_pairs, slots, assumed = stated["pole_pairs"], stated.get("slots"), ""
    teeth = box.tooth_sets()[:1] if box else ()
    words = f"{name}: {assumed}" if assumed else ""
    return Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=turns, teeth=teeth), words
