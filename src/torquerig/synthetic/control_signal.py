"""The reference report's control signal: all frequencies from 0 to half the sample rate at equal amplitude."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError


def control_signal(samples: int, *, amplitude: float, rng: np.random.Generator) -> NDArray[np.float64]:
    """Return a signal whose spectrum has ``amplitude`` on every bin, the mean and half the sample rate included.

    The spectrum behind a filter then shows its gain directly. The phases are random, so that the energy is distributed
    over the recording. A window mixes adjacent bins of different phase; use the spectrum without one
    (``amplitude_spectrum``).

    Parameters
    ----------
    samples : int
        At least 2.
    amplitude : float
        Zero to peak of each sine [any unit]; the rms is amplitude * sqrt(samples / 2) or so.
    rng : Generator
        Draws the phases.

    Notes
    -----
    Source: reference report, section 4.3.1, Figures 4.4 and 4.5 (the signal is not printed; the figures show
    equal amplitude).
    """
    if samples < 2:
        raise InputError(f"a control signal of {samples} samples has no spectrum; use a longer one")
    bins = samples // 2 + 1
    spectrum = 0.5 * samples * amplitude * np.exp(1j * rng.uniform(0, 2 * np.pi, bins))
    spectrum[0] = samples * amplitude
    if samples % 2 == 0:
        # the bin at half the sample rate has no conjugate and no phase
        spectrum[-1] = samples * amplitude
    return np.asarray(np.fft.irfft(spectrum, n=samples))
