"""Whether the runs turn at the speeds that their sheets state."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10, pi

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.recording import Recording

SPEED_ERROR = 0.01  # of a set-point, where the scenario states no largest error
TWO_SPEEDS = 3.0  # largest errors of a set-point, beyond which the sidecar and the encoder have two speeds


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
