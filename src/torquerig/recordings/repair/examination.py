"""What is known of recordings while detector after detector looks at them: the samples repaired so far, and faults."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf
from typing import Protocol

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.flat_tops import FlatTops
from torquerig.recordings.repair.moments import Moments
from torquerig.recordings.repair.sharp_dropouts import Dropouts

_ROUNDING = 1e-9  # of the range of the samples: a smaller difference is the arithmetic's


@dataclass(frozen=True, kw_only=True)
class Examination:
    """Recordings of one rig, and what their samples show so far.

    Parameters
    ----------
    recorded, recordings : tuple of Recording
        As they were read, and repaired so far.
    converter_step, full_range : float
        Of the converter [V]; 0 and infinity where they are not known.
    smallest_step : float
        Smallest difference of two neighbouring samples [V], which takes the place of a converter step nobody stated.
    lost : tuple of Moments
        Moments of each recording that hold no torque and are bridged.
    faults : tuple of Fault
        In the order in which they were found.
    renewed : tuple of float or None
        After how many samples each is renewed, where it is held in between.
    coarse_code : float or None
        Step of codes wider than the converter's [V].
    dropouts : Dropouts or None
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
    smallest_step: float = 0.0
    faults: tuple[Fault, ...] = ()
    renewed: tuple[float | None, ...] = ()
    coarse_code: float | None = None
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
    def code(self) -> float:
        """Distance of two codes of the samples [V], as far as it is known or seen."""
        return self.coarse_code or self.converter_step or self.smallest_step

    @property
    def resolution(self) -> float:
        """Half a code [V]."""
        return 0.5 * self.code

    @property
    def clipped(self) -> tuple[str, ...]:
        """The recordings whose readings stop at a limit."""
        return () if self.limit is None else self.limit.runs

    @property
    def standing(self) -> tuple[str, ...]:
        """The recordings with flat tops or coarse codes: where their signal stands still, that is no gain."""
        return self.clipped if self.coarse_code is None else tuple(each.name for each in self.recordings)

    def with_faults(self, *faults: Fault) -> Examination:
        """Return the same with further faults."""
        return replace(self, faults=(*self.faults, *faults))

    def shows(self, kind: str, recording: Recording) -> bool:
        """Whether a fault of this kind was found in a recording."""
        return any(fault.kind == kind and fault.recording == recording.name for fault in self.faults)


class Detector(Protocol):
    """One kind of fault: found, described in one sentence per recording, and repaired as far as it can be."""

    def __call__(self, seen: Examination, /) -> Examination:
        """Return what is known with this kind of fault: its ``Fault`` objects added, the recordings repaired.

        It knows no rig, and no unit: every size is compared with the recording's noise, so that the same samples in
        mV, V or N m, of either sign, show the same faults.
        """
        ...


def recordings_to_examine(
    recordings: tuple[Recording, ...], *, converter_step: float, full_range: float
) -> Examination:
    """Return what is known before any detector has looked."""
    nothing: tuple[Moments, ...] = tuple([] for _ in recordings)
    return Examination(
        recorded=recordings, recordings=recordings, lost=nothing, converter_step=converter_step, full_range=full_range,
        smallest_step=0.0 if converter_step else _smallest_step(recordings),
        renewed=(None,) * len(recordings), struck=nothing, to_the_other=(0.0,) * len(recordings),
    )  # fmt: skip


def _smallest_step(recordings: tuple[Recording, ...]) -> float:
    """Return the smallest difference of neighbouring samples, 0 where nothing moves."""
    smallest = inf
    for recording in recordings:
        volts = recording.torque_values()
        steps = np.abs(np.diff(volts))
        least = _ROUNDING * float(np.ptp(volts)) if volts.size else 0.0
        smallest = min(smallest, float(np.min(steps, where=steps > least, initial=inf)))
    return smallest if smallest < inf else 0.0
