"""A sheet that states another gear ratio than the scenario: the lines of the torque tell which of them is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.orders_standing_out import chances_of_orders, taken_together, turns_of
from torquerig.errors import InputError, RecordingError, TorquerigError
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.gear_stage import gear_stages
from torquerig.scenario.kinematics import kinematics_of, shaft_turns_to

_RATIO_KEPT = 0.02
_TOLD = 1e-4  # chance of lines at all orders of a ratio, below which they tell it
_RESOLVED = 3.0  # bins between two lines


def off_ratios(recordings: Sequence[Recording], runs: Sequence[Observed], rig: Rig) -> Iterator[tuple[str, Mismatch]]:
    """Yield a sentence and a mismatch for each run whose sheet states another gear ratio than its lines fit.

    Lines that turn with a shaft behind the gear tell its ratio: of the steady runs whose sheets say the same, those
    that stand out at the rig's ratio but not at the sheet's.

    Raises
    ------
    InputError, RecordingError
        Where the lines fit the sheet, or tell neither ratio.
    """
    ratio = kinematics_of(rig).ratio
    doubtful = [(one, run) for one, run in zip(recordings, runs, strict=True) if _contradicts(one, rig)]
    for stated in dict.fromkeys(one.run.gear_ratio or ratio for one, _ in doubtful):
        alike = [(one, run) for one, run in doubtful if one.run.gear_ratio == stated]
        steady = [run for _, run in alike if run.steady]
        behind, said = (
            _behind_the_gear(rig, steady),
            f"{alike[0][0].name}: its sidecar states a gear ratio of {stated:g}",
        )
        there = [order * ratio / stated for order in behind]
        own, other = _chance(steady, behind, others=there), _chance(steady, there, others=behind)
        if not own < _TOLD < other:
            raise _not_of_this_rig(said, recordings, ratio, fits=other < _TOLD < own)
        for one, _ in alike:
            sentence = (
                f"{one.name}: its sidecar states a gear ratio of {stated:g}, but the lines of its torque fit "
                f"{ratio:g}. The diagnosis uses the latter. Correct the sidecar."
            )
            yield sentence, Mismatch(
                domain="order", axis="output_shaft", at=1.0, width=abs(1 - ratio / stated), recordings=(one.name,),
                excess_dB=20 * abs(log10(ratio / stated)), share_of_misfit=0.0, p_value=own,
            )  # fmt: skip


def _not_of_this_rig(said: str, recordings: Sequence[Recording], ratio: float, *, fits: bool) -> TorquerigError:
    """Return why a run whose sheet has ``said`` another gear ratio is none of the rig's; the lines may say the same."""
    stated = {recording.run.gear_ratio for recording in recordings if recording.run.gear_ratio}
    if len(stated) > 1:
        listed = " and ".join(sorted(f"{one:g}" for one in stated))
        return InputError(
            f"the recordings are of different rigs: their sidecars state the gear ratio as {listed}; diagnose the runs "
            "of one rig in one call"
        )
    if fits:
        return RecordingError(
            f"{said}, which the lines of its torque fit, but the scenario's rig has {ratio:g}; use the scenario of the "
            "recorded rig"
        )
    return RecordingError(
        f"{said}, the scenario's rig has {ratio:g}, and the lines of the torque do not decide; correct the sidecar, or "
        "use the right scenario"
    )


def _contradicts(recording: Recording, rig: Rig) -> bool:
    """Whether the sheet states neither the ratio up to the sensor nor that up to any of the rig's gears."""
    stated = recording.run.gear_ratio
    gears = gear_stages(rig)
    if not (stated and gears):
        return False
    ratios = [shaft_turns_to(rig, last) for last in (rig.measured, *(gear.name for gear in gears))]
    return all(abs(stated / ratio - 1) > _RATIO_KEPT for ratio in ratios)


def _behind_the_gear(rig: Rig, runs: Sequence[Observed]) -> list[float]:
    """Return the orders of the motor at which the rig's lines would stand elsewhere, were the ratio another."""
    orders = {round(line.order, 6) for run in runs for line in Twin(rig.at(run.run)).lines()}
    return sorted(order for order in orders if abs(order - round(order)) > _RATIO_KEPT)


def _chance(runs: Sequence[Observed], orders: Sequence[float], *, others: Sequence[float]) -> float:
    """Return the probability that chance alone makes what stands at the orders that can be told from the others."""
    each = (chances_of_orders(run, _apart(orders, others, run), others=others) for run in runs)
    return taken_together([chance for of_run in each for chance in of_run])


def _apart(orders: Sequence[float], others: Sequence[float], run: Observed) -> list[float]:
    """Return those of the orders that can be told from the others and from the motor's whole ones in the run."""
    bin_ = 1 / turns_of(run)
    return [
        order for order in orders
        if all(abs(order - other) > _RESOLVED * bin_ for other in (*others, round(order)))
    ]  # fmt: skip
