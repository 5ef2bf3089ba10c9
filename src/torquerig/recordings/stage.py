"""One step of a signal chain, be it in the sensor or in a filter: Recording in, Recording out."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from torquerig.recordings.recording import Recording


class Stage(Protocol):
    """A frozen dataclass with one verb. It changes the torque channel (or what its docstring says) and nothing else.

    Randomness comes from ``recording.random(purpose)``, so that the same recording and stage give the same bytes.
    """

    def apply(self, recording: Recording) -> Recording:
        """Return the recording after this stage; the input is left as it was."""
        ...


@runtime_checkable
class LocalStage(Protocol):
    """A stage whose answer at a sample follows from the samples near it, so that it can work block by block.

    A long recording is then filtered in blocks that overlap by the reach, and the overlap is thrown away
    (``signals.streaming``). A causal stage states how long it remembers.
    """

    def reach(self, head: Recording) -> float:
        """Return how far on either side of a sample the stage looks [s].

        Beyond it, what a block lacks changes the answer by less than the stage's docstring says. ``head`` is the first
        block of the recording, with its rate, its run and its channels.
        """
        ...
