"""The load alone and the noise alone of a recording that knows its true load."""

from __future__ import annotations

from dataclasses import replace

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording
from torquerig.synthetic.mixture import TRUE_LOAD, TRUE_NOISE, volts


def load_only(mixture: Recording) -> Recording:
    """Return the reading without noise, with encoder and true load."""
    return _alone(mixture, TRUE_LOAD, "load only")


def noise_only(mixture: Recording) -> Recording:
    """Return the reading without load; its true load is zero."""
    alone = _alone(mixture, TRUE_NOISE, "noise only")
    name = TRUE_LOAD
    return alone.with_values(name, 0.0 * alone.channels[name].values)


def _alone(mixture: Recording, name: str, word: str) -> Recording:
    if name not in mixture.channels:
        raise RecordingError(f"{mixture.name}: its load is not known; there is no channel {name}")
    values = mixture.channels[name].values
    measured = {key: one for key, one in mixture.channels.items() if not one.truth}
    torque = mixture.torque_name()
    channels = {**measured, torque: volts(values), TRUE_LOAD: mixture.channels[TRUE_LOAD]}
    return replace(mixture, channels=channels, origin={**mixture.origin, "part": word})
