"""What parts and mechanisms have in common: a name, a place on the shaft, and terms and stages to give."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

if TYPE_CHECKING:
    from torquerig.recordings.stage import Stage
    from torquerig.rig.assembly import Rig
    from torquerig.rig.terms import Term, Wave


@dataclass(frozen=True, kw_only=True)
class PlacedStage:
    """A stage of the measuring chain and where in the chain it stands, counted from the shaft to the file.

    MECHANICAL is the measuring body and its bridge, AMPLIFIER its low-pass, CABLE what the amplifier's output picks up
    on its way, NOISE the noise floor, INPUT the range that the converter's input can follow, CONVERTER the converter,
    FILE what happens to its numbers.
    """

    MECHANICAL: ClassVar[int] = 0
    AMPLIFIER: ClassVar[int] = 1
    CABLE: ClassVar[int] = 2
    NOISE: ClassVar[int] = 3
    INPUT: ClassVar[int] = 4
    CONVERTER: ClassVar[int] = 5
    FILE: ClassVar[int] = 6

    position: int
    stage: Stage


@dataclass(frozen=True, kw_only=True)
class Part:
    """One thing that the machine is made of, or one effect that disturbs it.

    Parameters
    ----------
    name : str
        Unique in the rig; the nodes are known by it.
    after : str or None
        The part whose output shaft this one is fixed to; None starts a shaft of its own (or, for an effect, none).
    kind : str
        The word by which a scenario calls this class.
    group : str
        Which share of the reading it is counted to: mechanical, cogging, electrical or load; sensor for what changes
        the reading and not the shafts; empty for parts.
    """

    name: str
    after: str | None = None
    kind: str = ""
    group: str = ""

    __pydantic_config__: ClassVar[dict[str, str]] = {"extra": "forbid"}

    on_shaft: ClassVar[bool] = False
    """True for what sits on a shaft: in a scenario it follows the shaft part before it, unless ``after`` is stated."""
    ends_shaft: ClassVar[bool] = False
    """True for a branch of its own: what stands behind it in a scenario goes on from where the branch began."""
    opens_node: ClassVar[bool] = False
    """True for what has a spring inside (gear, sensor, coupling): its output shaft is a node of its own."""

    in_a_line: ClassVar[bool] = False
    """True for what moves in a line: kg, N and m in place of kg m^2, N m and rad."""

    @property
    def host(self) -> str | None:
        """The part that an effect sits on and moves with: ``at`` or ``gear``, and of a branch ``after``."""
        at: str | None = getattr(self, "at", getattr(self, "gear", None))
        return self.after if at is None and self.ends_shaft else at

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the physics that this part adds to the shafts."""
        return ()

    def drive_ripple(self, motor: str, rig: Rig) -> tuple[Wave, ...]:
        """Return the ripple in proportion to the torque of the motor ``motor``; none for most parts."""
        return ()

    def kinematic_error(self, gear: str, rig: Rig) -> tuple[Wave, ...]:
        """Return the kinematic error [rad] that this part gives to the gear or coupling ``gear``; mostly none."""
        return ()

    def stiffness_waves(self, gear: str, rig: Rig) -> tuple[Wave, ...]:
        """Return by how much of its mean [1] this part lets the stiffness of the gear or coupling ``gear`` vary."""
        return ()

    def encoder_error(self, shaft: str, rig: Rig) -> tuple[Wave, ...]:
        """Return the angle error [rad] that this part gives to an encoder on the node ``shaft``; none for most."""
        return ()

    def extra_gap(self, gear: str) -> float:
        """Return the gap [rad] that this part adds to the gear ``gear``; none for most parts."""
        return 0.0

    def amplifier_cutoff(self, sensor: str) -> float | None:
        """Return the cutoff [Hz] that this part leaves to the amplifier of ``sensor``; None: its own."""
        return None

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return what this part does to the signal on its way to the file."""
        return ()
