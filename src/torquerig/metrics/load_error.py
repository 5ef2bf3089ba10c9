"""How a reading differs from the true load: altogether, by band of frequencies, in energy, in its hits, in time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.bands import band_rms, bands_below
from torquerig.filters.evaluation.delay import Delay, delay_behind
from torquerig.filters.evaluation.hits import HitsShown, hits_shown
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.recordings.recording import Recording

TRUE_SPEED = "true_output_speed_rad_s"


@dataclass(frozen=True, kw_only=True)
class LoadError:
    """The difference of a reading to the true load.

    Parameters
    ----------
    rms : float
        Mean included [N m].
    mean : float
        Mean of reading less load [N m].
    bands : tuple of (low, high)
        [Hz]; they join, so that the squares of ``in_band`` add up to ``rms`` squared.
    in_band : tuple of float
        Rms of the difference in each band [N m].
    load_in_band : tuple of float
        Rms of the load itself in each band [N m].
    energy_percent : float or None
        Energy by the reading less energy by the load, over the latter, both at the true speed of the wear part [%];
        None where that speed is no channel.
    delay : Delay or None
        Of the reading behind the load.
    hits : HitsShown or None
        How the reading shows the load's largest hits; None where there are fewer than three.
    """

    rms: float
    mean: float
    bands: tuple[tuple[float, float], ...]
    in_band: tuple[float, ...]
    load_in_band: tuple[float, ...]
    energy_percent: float | None
    delay: Delay | None
    hits: HitsShown | None


def load_error(reading: Recording, truth: Recording) -> LoadError:
    """Return how ``reading`` differs from the true load that ``truth`` knows.

    Raises
    ------
    RecordingError
        When the true load is not known, or the two are not of one length.

    Notes
    -----
    The hits are looked for where the reading's delay puts them, when that is within the search and the two are alike
    (correlation above 0.5); a delay is otherwise taken as 0.
    """
    rms = truth_error(reading, truth)
    load, torque, rate = truth.channels[TRUE_LOAD].in_si(), reading.torque(), reading.sample_rate
    if load.size < 8:
        raise RecordingError(f"{truth.name}: {load.size} samples are too few to judge; take a longer recording")
    bands = bands_below(rate)
    delay = delay_behind(torque, load, rate=rate)
    late = delay.seconds if delay is not None and delay.correlation > 0.5 else 0.0
    return LoadError(
        rms=rms,
        mean=float((torque - load).mean()),
        bands=bands,
        in_band=tuple(float(one) for one in band_rms(torque - load, rate, bands)),
        load_in_band=tuple(float(one) for one in band_rms(load, rate, bands)),
        energy_percent=_energy_percent(torque, load, truth),
        delay=delay,
        hits=hits_shown(torque, load, rate=rate, delay=late),
    )


def _energy_percent(torque: np.ndarray, load: np.ndarray, truth: Recording) -> float | None:
    if TRUE_SPEED not in truth.channels:
        return None
    speed = truth.channels[TRUE_SPEED].in_si()
    true = float(np.trapezoid(load * speed))
    return 100 * (float(np.trapezoid(torque * speed)) / true - 1) if true else None
