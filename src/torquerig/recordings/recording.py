"""A recording: equally sampled channels with units, the test conditions of the run, and their origin."""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError, did_you_mean
from torquerig.recordings.run import Run
from torquerig.shown import figure, notebook_html

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

EFFORTS = ("torque", "force")
"""Quantities of a measured torque, on a rig that moves in a line of a force."""


@dataclass(frozen=True, kw_only=True)
class Channel:
    """One measured or true signal.

    Parameters
    ----------
    values : ndarray, shape (samples,), float64
        As recorded, in ``unit``.
    quantity : str
        One of ``QUANTITIES``.
    unit : str
        Unit of ``values``, for example ``V``, ``count`` or ``N*m``.
    si_per_unit : float
        SI quantity per ``unit``: N m per V for a torque sensor, rad per count for an encoder.
    truth : bool
        True for a signal that exists only in a simulation; never an input of a diagnosis.
    of : str or None
        The part of the scenario whose torque, force, speed or angle it is; None where it is not stated.
    role : {"compared", "input", "context"} or None
        What the channel is for; an input or a context channel is never taken for the measured torque.
    tare : bool
        True where the zero of the sensor was set before the run.
    """

    values: NDArray[np.float64]
    quantity: str
    unit: str
    si_per_unit: float = 1.0
    truth: bool = False
    of: str | None = None
    role: str | None = None
    tare: bool = False

    def in_si(self) -> NDArray[np.float64]:
        """Return the signal in SI units, shape (samples,)."""
        return self.values if self.si_per_unit == 1.0 else self.values * self.si_per_unit


@dataclass(frozen=True, kw_only=True)
class Recording:
    """Equally sampled channels of one run.

    Parameters
    ----------
    sample_rate : float
        Samples per second [Hz].
    channels : mapping of str to Channel
        All of the same length; the names end with the unit by convention (``torque_V``).
    run : Run
        The set-points of the run.
    origin : mapping
        For a simulated recording ``scenario``, ``seed`` and ``torquerig`` version; empty for a measured one.
    name : str
        The file name, for messages.
    path : Path or None
        The file that it was read from; None for a simulated one.
    """

    sample_rate: float
    channels: Mapping[str, Channel]
    run: Run = field(default_factory=Run)
    origin: Mapping[str, Any] = field(default_factory=dict)
    name: str = "recording"
    path: Path | None = field(default=None, compare=False, repr=False)

    @property
    def samples(self) -> int:
        """The number of samples of every channel."""
        return next((channel.values.size for channel in self.channels.values()), 0)

    @property
    def duration(self) -> float:
        """The length of the recording [s]."""
        return self.samples / self.sample_rate

    def time(self) -> NDArray[np.float64]:
        """Return the time of each sample from the first one [s], shape (samples,)."""
        return np.arange(self.samples) / self.sample_rate

    def find(self, quantity: str, *, truth: bool = False) -> str | None:
        """Return the name of the first channel of ``quantity`` that is not only context, or None."""
        for name, channel in self.channels.items():
            if channel.quantity == quantity and channel.truth == truth and channel.role != "context":
                return name
        return None

    def torque_name(self) -> str:
        """Return the name of the measured torque (or, on a rig that moves in a line, force) channel.

        The one whose role is ``compared``, else the only one that is neither an input nor context. RecordingError where
        there is none, and where there are several and nothing states which of them is meant.
        """
        for role in ("compared", None):
            for quantity in EFFORTS:
                named = [
                    name for name, one in self.channels.items()
                    if one.quantity == quantity and one.role == role and not one.truth
                ]  # fmt: skip
                if len(named) > 1:
                    raise RecordingError(self._several(named, quantity))
                if named:
                    return named[0]
        raise RecordingError(self._no_torque())

    def comparing(self, name: str) -> Recording:
        """Return this recording with the channel ``name`` as the measured torque, and other measured ones as context.

        The true load and lines of a simulation are those at its compared place, and are left out where another one is
        chosen. RecordingError where there is no such channel, or it is no torque, force or torque of the motor.
        """
        chosen = self.channel(name)
        if chosen.quantity not in (*EFFORTS, "motor_torque") or chosen.truth:
            kind = "true channel" if chosen.truth else chosen.quantity
            known = ", ".join(key for key, one in self.channels.items() if one.quantity in EFFORTS and not one.truth)
            raise RecordingError(
                f"{self.name}: {name} is a {kind}, not a measured torque or force; name one of {known or 'those'}"
            )
        quantity = "torque" if chosen.quantity == "motor_torque" else chosen.quantity
        read = {one.of for one in self.channels.values() if one.truth and one.role is None and one.of is not None}
        elsewhere = chosen.of in read and chosen.role != "compared"
        channels = {
            key: replace(one, role="context") if one.quantity in EFFORTS and not one.truth else one
            for key, one in self.channels.items()
            if not (elsewhere and one.truth and one.of is None and one.quantity in EFFORTS)
        }
        return replace(self, channels={**channels, name: replace(chosen, quantity=quantity, role="compared")})

    def _several(self, names: list[str], quantity: str) -> str:
        """Return the sentence that several channels may be the measured torque, with the remedy."""
        return (
            f"{self.name}: several channels are a {quantity}: {', '.join(names)}; name the one that is meant with "
            "--channel (in Python channel=), or write role: compared into its entry of the sidecar"
        )

    def _no_torque(self) -> str:
        """Return the sentence that no channel is a measured torque, with the remedy for those that may be one."""
        near = next((name for name, one in self.channels.items() if one.quantity == "motor_torque"), None)
        if near is not None:
            entry = f"{near}: {{quantity: torque, unit: {self.channels[near].unit}}}"
            return (
                f"{self.name}: there is no torque channel; {near} is taken for the torque of the motor and is used "
                f"with --channel {near} (in Python channel=). If it is the reading of the torque sensor, write into "
                f"the sidecar: channels: {{{entry}}}"
            )
        return (
            f"{self.name}: there is no torque channel among {', '.join(self.channels)}; name its quantity in the "
            "sidecar: channels: {NAME: {quantity: torque, unit: UNIT}}, with its scale where UNIT is not one of torque"
        )

    def torque_values(self) -> NDArray[np.float64]:
        """Return the measured torque as it was recorded, in the unit of its channel, shape (samples,)."""
        return self.channels[self.torque_name()].values

    def torque(self) -> NDArray[np.float64]:
        """Return the measured torque [N m], shape (samples,)."""
        return self.channels[self.torque_name()].in_si()

    def torque_unit(self) -> str:
        """Return the SI unit of the measured torque: N*m, or N where it is a force."""
        return "N" if self.channels[self.torque_name()].quantity == "force" else "N*m"

    def channel(self, name: str) -> Channel:
        """Return the channel ``name``; RecordingError with the close matches where there is none."""
        if name not in self.channels:
            raise RecordingError(f"{self.name}: there is no channel {name!r}; {did_you_mean(name, self.channels)}")
        return self.channels[name]

    def with_channel(self, name: str, channel: Channel) -> Recording:
        """Return this recording with ``channel`` added, or replaced where the name exists."""
        return replace(self, channels={**self.channels, name: channel})

    def with_values(self, name: str, values: NDArray[np.float64]) -> Recording:
        """Return this recording with the samples of the channel ``name`` replaced."""
        return self.with_channel(name, replace(self.channel(name), values=values))

    def without_truth(self) -> Recording:
        """Return this recording without its truth channels, as a real rig records it."""
        measured = {name: channel for name, channel in self.channels.items() if not channel.truth}
        return replace(self, channels=measured)

    def to_frame(self) -> pd.DataFrame:
        """Return all channels as recorded, one column each, over the time [s]."""
        import pandas as pd

        columns = {name: channel.values for name, channel in self.channels.items()}
        return pd.DataFrame(columns, index=pd.Index(self.time(), name="time_s"))

    def summary(self) -> str:
        """Return length, rate and channels in one sentence."""
        names = ", ".join(f"{name} [{channel.unit}]" for name, channel in self.channels.items())
        return f"{self.name}: {self.duration:g} s at {self.sample_rate:g} Hz, {len(self.channels)} channels: {names}"

    def levels(self) -> pd.DataFrame:
        """Return one row per channel: quantity, unit, mean, standard deviation, minimum and maximum in its unit."""
        import pandas as pd

        rows = {
            name: {
                "quantity": channel.quantity, "unit": channel.unit, "mean": channel.values.mean(),
                "std": channel.values.std(), "min": channel.values.min(), "max": channel.values.max(),
                "truth": channel.truth,
            }
            for name, channel in self.channels.items()
        }  # fmt: skip
        return pd.DataFrame.from_dict(rows, orient="index").rename_axis("channel")

    def to_json(self) -> str:
        """Return rate, length and the levels of the channels as JSON; ``torquerig.write`` writes the samples."""
        levels = {name: dict(row) for name, row in self.levels().iterrows()}
        data = {"recording": self.name, "sample_rate_Hz": self.sample_rate, "samples": self.samples, "channels": levels}
        return json.dumps(data, indent=2, ensure_ascii=False, default=float) + "\n"

    def plot(self) -> Figure:
        """Return the channels over time, with the spectrum and the levels of the torque.

        A notebook shows plots to zoom, with all samples and without a request to the net; ``savefig`` writes the
        picture.
        """
        return figure("recording_figure", self)

    def _repr_html_(self) -> str:
        """Return what a notebook shows."""
        return notebook_html(self.summary(), self.levels())

    def random(self, purpose: str) -> np.random.Generator:
        """Return the random generator of one purpose, determined by the recording's seed and the purpose's name."""
        return random_for(int(self.origin.get("seed", 0)), purpose)


def random_for(seed: int, purpose: str) -> np.random.Generator:
    """Return an independent random generator for each purpose of one seed, whatever the order of the calls."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(zlib.crc32(purpose.encode()),)))
