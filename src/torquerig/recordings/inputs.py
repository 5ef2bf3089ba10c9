"""The measured inputs of one recording: the channels that drive the model while it is simulated for that recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from torquerig.errors import RecordingError, did_you_mean
from torquerig.recordings.recording import EFFORTS, Recording
from torquerig.recordings.replay import ReplayedMotion, ReplayedTorque, replayed_motion, replayed_torque


@dataclass(frozen=True, eq=False)
class Inputs:
    """A recording whose channels drive a model; two are equal only where they are the same.

    Parameters
    ----------
    recording : Recording
        With its input channels; what a model compares is not used.
    """

    recording: Recording
    _made: dict[object, ReplayedTorque | ReplayedMotion] = field(default_factory=dict, repr=False)

    def torque(
        self, wanted: str, *, at: str, factor: float = 1.0, torque_constant: float | None = None
    ) -> ReplayedTorque:  # fmt: skip
        """Return the torque of a channel, by its name or quantity, for the part ``at``; see ``replayed_torque``."""
        key = ("torque", wanted, at, factor, torque_constant)
        if key not in self._made:
            name = input_channel(self.recording, wanted, at=at)
            self._made[key] = replayed_torque(self.recording, name, factor=factor, torque_constant=torque_constant)
        made = self._made[key]
        assert isinstance(made, ReplayedTorque)
        return made

    def motion(self, wanted: str, *, at: str, factor: float = 1.0) -> ReplayedMotion:
        """Return the motion of a channel, by its name or quantity, for the part ``at``; see ``replayed_motion``."""
        key = ("motion", wanted, at, factor)
        if key not in self._made:
            self._made[key] = replayed_motion(
                self.recording, input_channel(self.recording, wanted, at=at), factor=factor
            )
        made = self._made[key]
        assert isinstance(made, ReplayedMotion)
        return made


def driven_by(recording: Recording) -> Recording:
    """Return a recording whose run has the recording's channels as inputs."""
    whole = replace(recording, run=replace(recording.run, inputs=None))
    return replace(recording, run=replace(recording.run, inputs=Inputs(whole)))


def input_channel(recording: Recording, wanted: str, *, at: str) -> str:
    """Return the name of the channel that drives the part ``at``.

    By its name. By its quantity: the one whose role is ``input``, of several that ``of`` the part; where none has the
    role, the one that is ``of`` the part; else the only one, but never a torque or force, which may be a reading.

    Raises
    ------
    RecordingError
        No such channel; several and nothing states which; one that is compared.
    """
    channels = {name: one for name, one in recording.channels.items() if not one.truth}
    if wanted in channels:
        if channels[wanted].role == "compared":
            raise RecordingError(
                f"{recording.name}: {wanted} is compared with the model and cannot drive it; name another channel, or "
                "write role: input into its entry of the sidecar"
            )
        return wanted
    alike = {name: one for name, one in channels.items() if one.quantity == wanted and one.role in (None, "input")}
    inputs = [name for name, one in alike.items() if one.role == "input"]
    here = [name for name, one in alike.items() if one.of == at]
    choices = (
        [name for name in inputs if name in here] or inputs,
        here,
        [] if wanted in EFFORTS else [name for name, one in alike.items() if one.of in (None, at)],
    )
    found = next((names for names in choices if names), [])
    if len(found) == 1:
        return found[0]
    raise RecordingError(_missing(recording, wanted, [*channels], [*alike], at=at, several=found))


def _missing(
    recording: Recording, wanted: str, known: Sequence[str], alike: Sequence[str], *, at: str, several: Sequence[str]
) -> str:  # fmt: skip
    if several or alike:
        listed = several or alike
        return (
            f"{recording.name}: nothing states which of {', '.join(listed)} is the input at {at!r}; write role: input, "
            f"of: {at} into its entry of the sidecar, or name it: from: channel NAME"
        )
    others = [
        f"{name} is {recording.channels[name].role}" for name in known if recording.channels[name].quantity == wanted
    ]
    if others:
        return (
            f"{recording.name} has no {wanted} that is an input at {at!r}: {', '.join(others)}; write role: input into "
            "the sidecar's entry of the right one, or name it: from: channel NAME"
        )
    near = did_you_mean(wanted, [*known, *(recording.channels[name].quantity for name in known)])
    return (
        f"{recording.name} has no channel {wanted!r}, the input at {at!r}; {near}; record it, or name another channel: "
        "from: channel NAME"
    )
