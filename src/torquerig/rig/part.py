"""What parts and mechanisms have in common: a name, a place on the shaft, and terms and stages to give."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from torquerig.rig.host_changes import HostChange

if TYPE_CHECKING:
    from torquerig.recordings.stage import Stage
    from torquerig.rig.assembly import Rig
    from torquerig.rig.terms import Term


HOST_FIELDS = ("at", "gear", "coupling", "sensor")  # by which an effect names its host


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

    takes: ClassVar[tuple[type[HostChange], ...]] = ()
    """What effects may change inside this part; it collects each of these by ``rig.changes_in(self.name)``."""

    @property
    def host(self) -> str | None:
        """The part that an effect sits in and moves with, by one of ``HOST_FIELDS``; of a branch ``after``."""
        at = next((getattr(self, name) for name in HOST_FIELDS if hasattr(self, name)), None)
        return self.after if at is None and self.ends_shaft else at

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the physics that this part adds to the shafts."""
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return what this effect changes inside its ``host``: ripple, errors, a gap, a cutoff; nothing for parts."""
        return ()

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return what this part does to the signal on its way to the file."""
        return ()
