"""The load at the wear part from the sensor's reading, by the inverse of the rig's response (Wiener filter)."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import log
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from torquerig.errors import InputError, RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.filters.load_response import LoadResponse
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

LOWEST = 5.0  # [Hz] from which the spectra are fitted: above the reference rig's slow load and speed loop's corner
_HIGHEST_SHARE = 0.2  # [1] share of the rate up to which they are
_SEGMENT = 10.0  # [periods of the lowest frequency] length of each averaged periodogram
_MARGIN = 5.0  # [periods of the lowest frequency] length of the point-symmetric continuation of both ends
_TRIALS = 15  # number of stretches of the frequency axis that are tried


class Spectra(NamedTuple):
    """Spectra of a reading: load ``level / (1 + (f / corner)^2)`` times the rig's response, and white noise.

    ``level`` and ``noise`` are power densities [unit^2/Hz], ``corner`` is in Hz; ``stretch`` is the ratio of the rig's
    frequencies to the model's [1].
    """

    level: float
    corner: float
    noise: float
    stretch: float

    def load(self, frequencies: Floats) -> Floats:
        """Return the load's power density at ``frequencies`` [Hz]."""
        return np.asarray(self.level / (1 + (frequencies / self.corner) ** 2))


@dataclass(frozen=True, kw_only=True)
class LoadInverse:
    """Wiener's estimate of the load: ``conj(H) S_load / (|H|^2 S_load + S_noise)`` times the reading's transform.

    It removes the rig's ringing caused by the load, and suppresses frequencies where noise dominates. The spectra of
    load and noise are fitted to the recording.

    Parameters
    ----------
    response : LoadResponse
        H: the reading per true load, from a linear model of the rig.
    retune : float
        Largest relative difference of the rig's frequencies from the model's [1], 0 to 0.5; the stretch with the best
        fit of the reading's spectrum is used. 0: the model is not changed.
    lowest : float
        Frequency from which the spectra are fitted [Hz], > 0.

    Notes
    -----
    Source: Wiener 1949, Extrapolation, Interpolation, and Smoothing of Stationary Time Series, ch. 3; spectra by
    Whittle 1953 (Ark. Mat. 2, 423-434). Remove the lines first, because a line counts as load here. Limits: narrow-band
    load (its peak is fitted as one of the rig), backlash and other nonlinearities, a response that is wrong in more
    than its frequencies.
    """

    response: LoadResponse = field(compare=False)
    retune: float = 0.15
    lowest: float = LOWEST

    def __post_init__(self) -> None:
        if not 0 <= self.retune <= 0.5:
            raise InputError(f"a model cannot be retuned by {self.retune:g}; write a share from 0 to 0.5")
        if not self.lowest > 0:
            raise InputError(f"spectra cannot be fitted from {self.lowest:g} Hz on; write more than 0, such as 5 Hz")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque replaced by the load; RecordingError where it is too short."""
        name, rate = recording.torque_name(), recording.sample_rate
        values = recording.channels[name].values
        shortest = 4 * _SEGMENT / self.lowest
        if values.size < shortest * rate or _HIGHEST_SHARE * rate <= self.lowest:
            raise RecordingError(
                f"{recording.name}: {values.size} samples at {rate:g} Hz are too few to separate load and noise; "
                f"take {shortest:g} s or more, at more than {self.lowest / _HIGHEST_SHARE:g} Hz"
            )
        spectra = fitted_spectra(values, rate, self.response, retune=self.retune, lowest=self.lowest)
        margin = round(_MARGIN / self.lowest * rate)
        return recording.with_values(name, _filtered(values, rate, self.response, spectra, margin=margin))


def fitted_spectra(
    values: Floats, rate: float, response: LoadResponse, *, retune: float, lowest: float = LOWEST
) -> Spectra:
    """Return the spectra of load and noise and the stretch of the model that fit the signal's spectrum best."""
    from scipy.signal import welch

    frequencies, power = welch(values, fs=rate, nperseg=round(_SEGMENT / lowest * rate))
    seen = (frequencies >= lowest) & (frequencies <= _HIGHEST_SHARE * rate)
    frequencies, power = frequencies[seen], np.maximum(power[seen], 1e-300)
    start = np.array([log(float(np.median(power[frequencies < 6 * lowest]))), log(8 * lowest),
                      log(float(np.median(power[-power.size // 4 :])))])  # fmt: skip
    stretches = np.linspace(1 - retune, 1 + retune, _TRIALS) if retune else np.ones(1)
    trials = [_best_fit(start, frequencies, power, response, stretch) for stretch in stretches]
    best = int(np.argmin([cost for cost, _ in trials]))
    stretch, (_, logarithms) = stretches[best], trials[best]
    if retune:
        finer = stretch + (stretches[1] - stretches[0]) * np.linspace(-1, 1, _TRIALS)
        closer = [_best_fit(logarithms, frequencies, power, response, one) for one in finer]
        best = int(np.argmin([cost for cost, _ in closer]))
        stretch, (_, logarithms) = finer[best], closer[best]
    level, corner, noise = np.exp(logarithms)
    return Spectra(float(level), float(corner), float(noise), float(stretch))


def _best_fit(
    start: Floats, frequencies: Floats, power: Floats, response: LoadResponse, stretch: float
) -> tuple[float, Floats]:
    """Return Whittle's negative log-likelihood of the best level, corner and noise, and their logarithms."""
    from scipy.optimize import minimize

    gain = np.abs(response.at(frequencies, stretch=stretch)) ** 2

    def negative_log_likelihood(guess: Floats) -> float:
        level, corner, noise = np.exp(np.clip(guess, -200, 200))
        expected = gain * level / (1 + (frequencies / corner) ** 2) + noise
        return float(np.mean(np.log(expected) + power / expected))

    options = {"xatol": 1e-3, "fatol": 1e-7, "maxiter": 400}
    found = minimize(negative_log_likelihood, start, method="Nelder-Mead", options=options)
    return float(found.fun), np.asarray(found.x)


def _filtered(values: Floats, rate: float, response: LoadResponse, spectra: Spectra, *, margin: int) -> Floats:
    from scipy.fft import irfft, next_fast_len, rfft

    head, tail = 2 * values[0] - values[margin:0:-1], 2 * values[-1] - values[-2 : -margin - 2 : -1]
    longer = np.concatenate([head, values, tail])
    size = next_fast_len(longer.size, real=True)
    # the padding leads from the last value back to the first, so that the periodic continuation has no step
    bridge = np.linspace(longer[-1], longer[0], size - longer.size + 2)[1:-1]
    transform = rfft(np.concatenate([longer, bridge]))
    frequencies = np.arange(transform.size) * rate / size
    gain, load = response.at(frequencies, stretch=spectra.stretch), spectra.load(frequencies)
    wiener = gain.conj() * load / (np.abs(gain) ** 2 * load + spectra.noise)
    wiener[0] = 1 / gain[0].real  # the mean is not attenuated
    return np.asarray(irfft(transform * wiener, n=size)[margin : margin + values.size])
