"""The interface of sensor stages and filters: Recording in, Recording out."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from torquerig.recordings.recording import Recording


class Stage(Protocol):
    """One step of the measuring chain or of a filter chain; a frozen dataclass.

    It changes the torque channel (or the channel that its docstring names) and nothing else. Random numbers come from
    ``recording.random(purpose)``, so that the same recording and stage give the same bytes.
    """

    def apply(self, recording: Recording) -> Recording:
        """Return the recording after this stage; the input is not changed."""
        ...


@runtime_checkable
class LocalStage(Protocol):
    """A stage whose output at a sample depends only on samples near it, so that it can work block by block.

    A long recording is filtered in blocks that overlap by the reach, and the overlap is discarded
    (``filters.block_filtering``). A causal stage states the length of its impulse response.
    """

    def reach(self, head: Recording) -> float:
        """Return the reach [s]: how far from a sample, on either side, other samples influence it.

        Samples beyond it change the output by less than the stage's docstring states. ``head`` is the first block of
        the recording, with its rate, run and channels.
        """
        ...
