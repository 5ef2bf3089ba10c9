"""One step of a signal chain, be it in the sensor or in a filter: Recording in, Recording out."""

from __future__ import annotations

from typing import Protocol

from torquerig.signals.recording import Recording


class Stage(Protocol):
    """A frozen dataclass with one verb. It changes the torque channel (or what its docstring says) and nothing else.

    Randomness comes from ``recording.random(purpose)``, so that the same recording and stage give the same bytes.
    """

    def apply(self, recording: Recording) -> Recording:
        """Return the recording after this stage; the input is left as it was."""
        ...
