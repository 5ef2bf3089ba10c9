"""Times and frequencies on which a filter is evaluated: the decay of the load's hits, and the frequency bands."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from torquerig.errors import InputError


@dataclass(frozen=True)
class LoadScale:
    """The fastest thing that the load does, and the bands in which its error is listed.

    Parameters
    ----------
    hit_decay : float
        Time constant of a hit of the load [s], > 0; the default is that of the reference rig at 0.5 mm. Windows and
        distances of hits, the window of a step response and the largest delay are multiples of it.
    edges : tuple of float
        Edges of the frequency bands [Hz], rising from 0; the last band extends to half the sample rate.
    """

    hit_decay: float = 4e-3
    edges: tuple[float, ...] = (0.0, 1.0, 10.0, 50.0, 100.0, 200.0, 500.0, 2000.0)

    def __post_init__(self) -> None:
        if not (self.hit_decay > 0 and isfinite(self.hit_decay)):
            raise InputError(f"a hit decay of {self.hit_decay:g} s is not possible; write more than 0, such as 4 ms")
        rising = all(low < high for low, high in zip(self.edges, self.edges[1:], strict=False))
        if not self.edges or self.edges[0] != 0 or not rising or not isfinite(self.edges[-1]):
            shown = ", ".join(f"{edge:g}" for edge in self.edges)
            raise InputError(f"the band edges {shown} Hz do not rise from 0; write for example 10 Hz, 100 Hz")


WEAR_PART = LoadScale()
