"""Whether the recordings of one call can be runs of the scenario's rig, before anything is computed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10, pi

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.outcome import Mismatch
from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import (
    ImposedMotion,
    InductionDrive,
    Motor,
    ReactionTorqueSensor,
    SpeedController,
    TorqueController,
)

SPEED_ERROR = 0.01  # of a set-point, where the scenario states no largest error
TWO_SPEEDS = 3.0  # largest errors of a set-point, beyond which the sidecar and the encoder have two speeds


def check_rig(rig: Rig) -> None:
    """Raise where nothing drives the scenario's rig, or what is measured has no spring."""
    driven = any(rig.parts_of(drive) for drive in (SpeedController, TorqueController, InductionDrive))
    imposed = next(iter(rig.parts_of(ImposedMotion)), None)
    if imposed is not None and not driven:
        raise InputError(
            f"the scenario imposes the motion {imposed.name!r} but measures {rig.measured!r}; write from: channel NAME "
            f"into {imposed.name}, so that each recording states its motion, or measured: {imposed.name}, or add a "
            "speed_controller that drives the motor"
        )
    if not driven and not rig.parts_of(Motor):
        raise InputError(
            "the rig has no motor, and nothing states how it moves; record the position or velocity of the part that "
            "is pushed, add motion: {kind: imposed_motion, at: PART, from: channel NAME} for it, and write measured: "
            "motion to compare the force that moves it, or measured: SENSOR for a sensor behind it"
        )
    if not driven:
        raise InputError(
            "nothing in the scenario drives a motor; add a speed_controller, for a recorded torque of the motor a "
            "torque_controller with from: channel NAME, or for a recorded motion an imposed_motion with from: channel "
            "NAME, or one named under measured:"
        )
    if isinstance(rig.part(rig.measured), ReactionTorqueSensor):
        raise InputError(
            f"the scenario compares {rig.measured!r}, the torque at a motor's foot, which no diagnosis explains yet; "
            "name the torque_sensor, coupling or gear to compare first under measured:"
        )
    if not rig.part(rig.measured).opens_node:
        raise InputError(
            f"the scenario measures {rig.measured!r}, which transmits no torque; name a torque_sensor, a coupling or a "
            "gear under measured:"
        )


def check_recordings(recordings: Sequence[Recording]) -> None:
    """Raise where a recording has no torque, or the sheets state several motors."""
    for recording in recordings:
        recording.torque_name()
    motors = {recording.run.motor for recording in recordings if recording.run.motor}
    if len(motors) > 1:
        raise InputError(
            f"the recordings are of different rigs: their sidecars state the motor as {' and '.join(sorted(motors))}; "
            "diagnose the runs of one rig in one call"
        )


def off_set_points(
    recordings: Sequence[Recording], runs: Sequence[Observed], *, error_max: float
) -> Iterator[tuple[str, Mismatch]]:
    """Yield a sentence and a mismatch for each steady run that turns at another speed than its sheet says.

    By its angle channel, or by the lines of its torque. ``error_max`` is the largest error of a set-point that the
    scenario states [1]; 0 where it states none.
    """
    for recording, run in zip(recordings, runs, strict=True):
        stated, real = abs(recording.run.speed or 0.0), abs(run.mean_speed)
        # lines of the torque alone give the speed no better than SPEED_ERROR
        error = (error_max or SPEED_ERROR) if run.angle_measured else max(error_max, SPEED_ERROR)
        if not (run.steady and stated) or abs(real / stated - 1) <= TWO_SPEEDS * error:
            continue
        rpm, said = real * 30 / pi, stated * 30 / pi
        by = run.origin.removeprefix("from ")
        evidence = f"{by} shows" if run.angle_measured else "the lines of its torque fit"
        sentence = (
            f"{run.name}: the sidecar states {said:.0f} rpm, but {evidence} {rpm:.0f} rpm. The diagnosis uses the "
            f"latter. Correct the sidecar{', or the counts per turn' if run.angle_measured else ''}."
        )
        yield sentence, Mismatch(
            domain="speed", axis="rpm", at=rpm, width=abs(rpm - said), recordings=(run.name,),
            excess_dB=20 * abs(log10(rpm / said)), share_of_misfit=0.0, p_value=0.0,
        )  # fmt: skip
