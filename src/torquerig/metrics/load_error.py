"""Error of a reading against the true load: rms, by frequency band, in energy, at impacts and in delay."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.bands import band_rms, bands_below
from torquerig.filters.evaluation.delay import DECAYS, Delay, delay_behind
from torquerig.filters.evaluation.hits import HitResponse, hit_response
from torquerig.filters.evaluation.load_scale import WEAR_PART, LoadScale
from torquerig.metrics.truth_error import true_load, truth_error

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

TRUE_SPEED = "true_output_speed_rad_s"
TRUE_SPEEDS = (TRUE_SPEED, "true_output_velocity_m_s")


@dataclass(frozen=True, kw_only=True)
class LoadError:
    """The error of a reading against the true load.

    Parameters
    ----------
    rms : float
        Mean included [N m].
    mean : float
        Mean of reading minus load [N m].
    bands : tuple of (low, high)
        [Hz]; contiguous, so that the squares of ``in_band`` add up to ``rms`` squared.
    in_band : tuple of float
        Rms of the difference in each band [N m].
    load_in_band : tuple of float
        Rms of the load itself in each band [N m].
    energy_percent : float or None
        Energy from the reading minus energy from the load, relative to the latter, both at the true speed of the
        wear part [%]; None where that speed is no channel.
    delay : Delay or None
        Delay of the reading against the load.
    hits : HitResponse or None
        The load's largest impacts in the reading; None where there are fewer than three.
    """

    rms: float
    mean: float
    bands: tuple[tuple[float, float], ...]
    in_band: tuple[float, ...]
    load_in_band: tuple[float, ...]
    energy_percent: float | None
    delay: Delay | None
    hits: HitResponse | None


def load_error(reading: Recording, truth: Recording, *, scale: LoadScale = WEAR_PART) -> LoadError:
    """Return the error of ``reading`` against the true load in ``truth``.

    Parameters
    ----------
    scale : LoadScale
        Decay time of the load's hits, and the frequency bands.

    Raises
    ------
    RecordingError
        When the true load is not known, or the two have different lengths.

    Notes
    -----
    The impacts are searched at the delay of the reading, if it is within the search range and the correlation is above
    0.5; otherwise at a delay of 0.
    """
    rms = truth_error(reading, truth)
    load, torque, rate = true_load(truth), reading.torque(), reading.sample_rate
    if load is None or load.size < 8:
        raise RecordingError(
            f"{truth.name}: {truth.samples} samples are too few for an evaluation; take a longer recording"
        )
    bands = bands_below(rate, scale.edges)
    delay = delay_behind(torque, load, rate=rate, longest=DECAYS * scale.hit_decay)
    late = delay.seconds if delay is not None and delay.correlation > 0.5 else 0.0
    return LoadError(
        rms=rms,
        mean=float((torque - load).mean()),
        bands=bands,
        in_band=tuple(float(one) for one in band_rms(torque - load, rate, bands)),
        load_in_band=tuple(float(one) for one in band_rms(load, rate, bands)),
        energy_percent=_energy_percent(torque, load, truth),
        delay=delay,
        hits=hit_response(torque, load, rate=rate, delay=late, decay=scale.hit_decay),
    )


def _energy_percent(torque: np.ndarray, load: np.ndarray, truth: Recording) -> float | None:
    name = next((one for one in TRUE_SPEEDS if one in truth.channels), None)
    if name is None:
        return None
    speed = truth.channels[name].in_si()
    true = float(np.trapezoid(load * speed))
    return 100 * (float(np.trapezoid(torque * speed)) / true - 1) if true else None
