"""What a rig's sensor makes of the load at the wear part: a frequency response, as values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class LoadResponse:
    """The reading per true load, both in N m, at some frequencies; it comes from a linear model of the rig.

    Parameters
    ----------
    frequencies : ndarray, shape (frequencies,)
        Rising [Hz], > 0, dense enough that a straight line between two of them will do.
    values : ndarray, shape (frequencies,), complex
        The reading per load [1]. Below the first frequency and above the last they are as there.
    origin : str
        Where it comes from, in words.
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
        asked = frequencies / stretch
        real = np.interp(asked, self.frequencies, self.values.real)
        return np.asarray(real + 1j * np.interp(asked, self.frequencies, self.values.imag))
