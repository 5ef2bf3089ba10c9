"""Blocks of a run at one speed: their lines and bands, averaged."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block
from torquerig.inference.features.bands import Bands

Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Segment:
    """Blocks of a run at one speed, whose lines and bands are averaged.

    Parameters
    ----------
    blocks : tuple of Block
    speed : float
        Mean speed of the motor [rad/s], with its sign.
    speeds : ndarray, shape (1 or SPEEDS,)
        From the slowest to the fastest [rad/s]; a single one in a steady run.
    line_power : ndarray, shape (places,)
        Mean square of the amplitudes, noise included [(N m)^2]; NaN where no block shows the line.
    line_noise_bandwidth : ndarray, shape (places,)
        The noise adds so many times its density [Hz] to ``line_power``.
    line_half_width : ndarray, shape (places,)
        [Hz]
    line_excluded : ndarray, shape (places,)
        Within so much of its frequency [Hz] the bands have no bins.
    line_count : ndarray, shape (places,)
        Blocks that show the line.
    bands : Bands
    block_lines : ndarray, shape (blocks, places)
        Square of the amplitudes in each block, noise included [(N m)^2]; NaN where it does not show the line.
    """

    blocks: tuple[Block, ...]
    speed: float
    speeds: Floats
    line_power: Floats
    line_noise_bandwidth: Floats
    line_half_width: Floats
    line_excluded: Floats
    line_count: Floats
    bands: Bands
    block_lines: Floats


@dataclass(frozen=True, kw_only=True, eq=False)
class LineTable:
    """Lines of all segments, shape (segments, places) each; the fields are those of ``Segment``."""

    power: Floats
    count: Floats
    noise_bandwidth: Floats
    half_width: Floats
