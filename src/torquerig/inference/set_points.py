"""Whether steady runs turn at the speeds that their sidecars state."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

from torquerig.inference.measured_run import MeasuredRun

_BEYOND = 1.5  # largest errors of a set-point: a drive that is further off is not the one of the data sheet


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
        if not (run.is_steady and stated) or abs(real / stated - 1) <= _BEYOND * error:
            continue
        rpm, said = real * 30 / pi, stated * 30 / pi
        evidence = "its measured angle shows" if run.has_encoder else "the lines of its torque fit"
        counts = ", the counts per turn" if run.has_encoder else ""
        yield (
            f"{run.name}: the sidecar states {said:.4g} rpm, but {evidence} {rpm:.4g} rpm. The set-point may be off by "
            f"{100 * error:.3g} %. The measured speed is used. Check sample_rate_Hz{counts} and the set-point."
        )
