"""Whether the recordings of one call can be runs of the scenario's rig, before anything is computed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10, pi

from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.looking.observed import Observed
from torquerig.errors import InputError, RecordingError
from torquerig.rig.parts import Gear
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.signals.recording import Recording

_RATIO_KEPT = 0.02
SPEED_KEPT = 0.03  # a set-point is kept within a per cent; beyond this the sheet and the encoder tell of two speeds


def check_recordings(recordings: Sequence[Recording], rig: Rig) -> None:
    """Raise where the sheets contradict each other or the scenario: other motor, other gear ratio, no torque."""
    for recording in recordings:
        recording.torque_name()
    for what, values in (
        ("motor", {recording.run.motor for recording in recordings if recording.run.motor}),
        ("gear ratio", {recording.run.gear_ratio for recording in recordings if recording.run.gear_ratio}),
    ):
        if len(values) > 1:
            listed = " and ".join(sorted(str(value) for value in values))
            raise InputError(
                f"the recordings are of different rigs: their sheets state the {what} as {listed}; diagnose the runs "
                "of one rig in one call"
            )
    ratio = kinematics_of(rig).ratio
    for recording in recordings:
        stated = recording.run.gear_ratio
        if stated and rig.parts_of(Gear) and abs(stated / ratio - 1) > _RATIO_KEPT:
            raise RecordingError(
                f"{recording.name}: its sheet states a gear ratio of {stated:g}, the scenario's rig has {ratio:g}; "
                "correct the sheet, or diagnose with the scenario of that rig"
            )


def off_set_points(recordings: Sequence[Recording], runs: Sequence[Observed]) -> Iterator[tuple[str, Mismatch]]:
    """Yield a sentence and a mismatch for each steady run that turns at another speed than its sheet says.

    By its angle channel, or by the lines of its torque.
    """
    for recording, run in zip(recordings, runs, strict=True):
        stated, real = recording.run.speed, abs(run.mean_speed)
        if not (run.steady and stated) or abs(real / stated - 1) <= SPEED_KEPT:
            continue
        rpm, said = real * 30 / pi, stated * 30 / pi
        teller = f"its {run.origin} turns at" if run.angle_measured else "the lines of its torque fit"
        sentence = (
            f"{run.name}: its sheet sets {said:.0f} rpm, {teller} {rpm:.0f} rpm; diagnosed at the "
            f"latter, so correct the sheet{', or the counts per turn' if run.angle_measured else ''}"
        )
        yield sentence, Mismatch(
            domain="speed", axis="rpm", at=rpm, width=abs(rpm - said), recordings=(run.name,),
            excess_dB=20 * abs(log10(rpm / said)), share_of_misfit=0.0, p_value=0.0,
        )  # fmt: skip
