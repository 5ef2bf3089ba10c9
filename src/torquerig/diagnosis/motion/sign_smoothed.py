"""Over what speed a stated dry friction changes sign: a number of the model, which no data sheet states."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part

_SPREAD = 0.7  # of its logarithm: within a factor of two, one sigma


def knobs_of_the_sign(rig: Rig, known: Sequence[Knob]) -> tuple[Knob, ...]:
    """Return a knob for the smoothing speed of every dry friction on the imposed shaft that has none among ``known``.

    ``tanh(v / smoothing)`` stands for a sign so that it can be integrated. Near standstill, where a part creeps, it
    decides what the friction is: a wrong one is a wrong number, and no missing physics. Behind a spring it hardly
    shows, and a sharper sign there asks for tiny steps.
    """
    taken = {(knob.part, knob.field) for knob in known}
    imposed = imposed_part(rig)
    answer: list[Knob] = []
    for part in rig.parts:
        dry = getattr(part, "coulomb", 0.0) and getattr(part, "smoothing", 0.0)
        direct = imposed is not None and dry and rig.node(getattr(part, "at", part.name)) == rig.node(imposed.at)
        if direct and (part.name, "smoothing") not in taken:
            answer.append(Knob(part.name, "smoothing", _SPREAD))
    return tuple(answer)
