"""The frequency response of a rig from the load at the wear part to the sensor's reading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class LoadResponse:
    """The reading per load, both in N m, at given frequencies, from a linear model of the rig.

    Parameters
    ----------
    frequencies : ndarray, shape (frequencies,)
        Rising [Hz], > 0, dense enough for linear interpolation.
    values : ndarray, shape (frequencies,), complex
        The reading per load [1]; constant below the first frequency and above the last.
    origin : str
        The source in words.
    """

    frequencies: NDArray[np.float64]
    values: NDArray[np.complex128]
    origin: str = "a model"

    def __post_init__(self) -> None:
        rising = self.frequencies.size > 1 and self.frequencies[0] > 0 and bool((np.diff(self.frequencies) > 0).all())
        if not rising or self.values.shape != self.frequencies.shape or not np.isfinite(self.values).all():
            raise InputError("a frequency response needs rising frequencies above 0 Hz and a finite value at each")

    def at(self, frequencies: NDArray[np.float64], *, stretch: float = 1.0) -> NDArray[np.complex128]:
        """Return the response of a rig whose frequencies are ``stretch`` times the model's, shape (frequencies,)."""
        unstretched = frequencies / stretch
        real = np.interp(unstretched, self.frequencies, self.values.real)
        return np.asarray(real + 1j * np.interp(unstretched, self.frequencies, self.values.imag))
