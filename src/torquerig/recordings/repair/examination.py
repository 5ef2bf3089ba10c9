"""What is known of recordings while detector after detector looks at them: the samples repaired so far, and faults."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.coarse_codes import Codes
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.flat_tops import FlatTops
from torquerig.recordings.repair.moments import Moments
from torquerig.recordings.repair.sharp_dropouts import Dropouts


@dataclass(frozen=True, kw_only=True)
class Examination:
    """Recordings of one rig, and what their samples show so far.

    Parameters
    ----------
    recorded, recordings : tuple of Recording
        As they were read, and repaired so far.
    converter_step, full_range : float
        Of the converter [V]; 0 and infinity where they are not known.
    lost : tuple of Moments
        Moments of each recording that hold no torque and are bridged.
    faults : tuple of Fault
        In the order in which they were found.
    renewed : tuple of float or None
        After how many samples each is renewed, where it is held in between.
    codes, dropouts : Codes, Dropouts or None
    limit : FlatTops or None
        Where the readings stop; ``behind`` where hum, an alias or noise was added to that.
    rebuilt, broken : tuple of str
        Names of recordings whose moments at a limit were rebuilt, and whose time base is broken.
    stepping : bool
        Whether a mean steps.
    swept : tuple of (float, float)
        Lowest and highest frequency [Hz] over which a line swept that was removed.
    to_the_other : tuple of float
        What leads each recording to the other level of its telegraph noise [V].
    struck : tuple of Moments
        Moments of each that blows of what slips and grips took.
    """

    recorded: tuple[Recording, ...]
    recordings: tuple[Recording, ...]
    lost: tuple[Moments, ...]
    converter_step: float = 0.0
    full_range: float = inf
    faults: tuple[Fault, ...] = ()
    renewed: tuple[float | None, ...] = ()
    codes: Codes | None = None
    dropouts: Dropouts | None = None
    limit: FlatTops | None = None
    behind: bool = False
    rebuilt: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()
    stepping: bool = False
    swept: tuple[tuple[float, float], ...] = ()
    to_the_other: tuple[float, ...] = ()
    struck: tuple[Moments, ...] = ()

    @property
    def resolution(self) -> float:
        """Half a code [V], 0 where it is not known."""
        return 0.5 * (self.codes.step if self.codes else self.converter_step)

    @property
    def clipped(self) -> tuple[str, ...]:
        """The recordings whose readings stop at a limit."""
        return () if self.limit is None else self.limit.runs

    @property
    def standing(self) -> tuple[str, ...]:
        """The recordings with flat tops or coarse codes: where their signal stands still, that is no gain."""
        return self.clipped if self.codes is None else tuple(each.name for each in self.recordings)

    def with_faults(self, *faults: Fault) -> Examination:
        """Return the same with further faults."""
        return replace(self, faults=(*self.faults, *faults))


Detector = Callable[[Examination], Examination]
"""Finds one kind of fault, adds a sentence and a place for each, and repairs the samples as far as it can."""


def recordings_to_examine(
    recordings: tuple[Recording, ...], *, converter_step: float, full_range: float
) -> Examination:
    """Return what is known before any detector has looked."""
    nothing: tuple[Moments, ...] = tuple([] for _ in recordings)
    return Examination(
        recorded=recordings, recordings=recordings, lost=nothing, converter_step=converter_step, full_range=full_range,
        renewed=(None,) * len(recordings), struck=nothing, to_the_other=(0.0,) * len(recordings),
    )  # fmt: skip
