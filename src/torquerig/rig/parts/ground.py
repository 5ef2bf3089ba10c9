"""A locked end: the shaft or slide that it is fixed to does not move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from torquerig.rig.assembly import Part


@dataclass(frozen=True, kw_only=True)
class Ground(Part):
    """The frame: ``theta = 0`` for the shaft at whose end it is; a spring that ends there is a spring to the frame.

    As the first part it starts a shaft at the frame. What is fixed to a locked shaft rests: its inertia and friction
    have no effect, and a load, a motor or an imposed motion there is refused. The zero of the springs that end there is
    their ``rest_angle``.
    """

    on_shaft: ClassVar[bool] = True
    locks_shaft: ClassVar[bool] = True

    kind: Literal["ground"] = "ground"
