"""What changes along steady runs: which of them can be asked part by part, and where what is found of that is told."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.repair.common_dropouts import moments_without_signal

PARTS = 10  # of each run
SHORTEST = 0.4  # [s] a part


def unbroken(runs: Sequence[Observed]) -> list[Observed]:
    """Return the steady runs that are long enough for ``PARTS``.

    Those with moments without signal or at a limit are left out: these ring through the spectrum where they happen to
    be.
    """
    return [
        run
        for run in runs
        if run.steady and not run.rebuilt and not moments_without_signal(run.recording)
        and run.torque.size >= PARTS * int(SHORTEST * run.rate)
    ]  # fmt: skip


def at_their_end(runs: Sequence[Observed], *, excess_dB: float, p_value: float) -> Mismatch:
    """Return the mismatch of what is so much larger in the last part of the runs than in the first."""
    longest = max(run.recording.duration for run in runs)
    return Mismatch(
        domain="time", axis="s", at=(1 - 0.5 / PARTS) * longest, width=longest / PARTS,
        recordings=tuple(run.name for run in runs), excess_dB=excess_dB, share_of_misfit=0.0, p_value=p_value,
    )  # fmt: skip
