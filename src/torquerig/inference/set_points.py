"""Whether steady runs turn at the speeds that their sidecars state."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

from torquerig.inference.measured_run import MeasuredRun

_TWO_SPEEDS = 3.0  # largest errors of a set-point, beyond which the sidecar and the recording have two speeds


def off_set_points(runs: Sequence[MeasuredRun], *, error: float) -> Iterator[str]:
    """Yield a sentence for each steady run that turns at another speed than its sidecar states.

    Parameters
    ----------
    runs : sequence of MeasuredRun
        Whose set-points are the stated ones times the factor that all runs share.
    error : float
        Largest error of a set-point [1].
    """
    for run in runs:
        stated, real = abs((run.run.speed or 0.0) / run.speed_factor), run.mean_speed
        if not (run.is_steady and stated) or abs(real / stated - 1) <= _TWO_SPEEDS * error:
            continue
        rpm, said = real * 30 / pi, stated * 30 / pi
        evidence = "its measured angle shows" if run.has_encoder else "the lines of its torque fit"
        remedy = ", or the counts per turn" if run.has_encoder else ""
        yield (
            f"{run.name}: the sidecar states {said:.0f} rpm, but {evidence} {rpm:.0f} rpm. The diagnosis uses the "
            f"latter. Correct the sidecar{remedy}."
        )
