"""One motor on every gearbox of the catalog, and the best ratio of the alpha-beta method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.metrics.sizing.best_ratio import AlphaBeta, alpha_beta
from torquerig.metrics.sizing.drive_sizing import EXCEEDS, Sizing, sizing
from torquerig.study.candidates import candidate_of
from torquerig.study.exchange import pinned_ratio
from torquerig.study.sized_candidates import sized_candidate

if TYPE_CHECKING:
    from torquerig.metrics.figure import Figure
    from torquerig.metrics.sizing.sized_drive import SizedDrive
    from torquerig.study.definition import Study

SHOWN = ("rms_torque", "rms_torque_use", "peak_torque_use", "speed_limit_use", "gearbox_life_use", "gearbox_peak_use",
         "sensor_overload", "inertia_ratio", "load_fidelity")  # fmt: skip
LIMITS = ("rms_torque_use", "peak_torque_use", "speed_limit_use", "gearbox_life_use", "gearbox_peak_use")


@dataclass(frozen=True, kw_only=True)
class SweptGearbox:
    """The motor on one gearbox, and the limits that it exceeds for all values of the intervals.

    ``ratio`` is that of the whole chain to the measured shaft [1], ``ratio_text`` names the stage's too.
    """

    gearbox: str
    ratio: float
    sized: Sizing
    ratio_text: str = ""

    @property
    def rms_torque(self) -> Figure:
        """The rms torque of the motor [N m], with the inertia and efficiency of this gearbox."""
        return self.sized.figures["rms_torque"]

    @property
    def exceeded(self) -> tuple[str, ...]:
        """The limits that are exceeded for all values of the intervals, by name."""
        return tuple(name for name in LIMITS if name in self.sized.figures and self.sized.word(name) == EXCEEDS)


@dataclass(frozen=True, kw_only=True)
class RatioSweep:
    """All gearboxes by rising ratio, and the closed form for the same duty cycle."""

    motor: str
    drive: SizedDrive
    ideal: AlphaBeta
    swept: tuple[SweptGearbox, ...]

    @property
    def best(self) -> SweptGearbox | None:
        """The gearbox of the least rms torque that exceeds no limit; None where each exceeds one."""
        allowed = [one for one in self.swept if not one.exceeded]
        return min(allowed, key=lambda one: middle(one.rms_torque), default=None)

    def sentence(self, reached: Figure) -> str:
        """Return both results as text; ``reached`` is the ideal ratio within the speed limit of the motor."""
        if self.best is None:
            return f"No gearbox of the catalog fits {self.motor}: each exceeds a limit."
        least = middle(self.best.rms_torque)
        known = middle(reached)
        by_form = self.ideal.rms_torque(known)
        why = "limited by the motor speed" if known < self.ideal.best * 0.999 else "the unconstrained minimum"
        return (
            f"Alpha-beta: {reached.shown()}:1, {why}, {by_form:.3g} N*m rms without gearbox inertia and motor "
            f"friction. Catalog: {self.best.gearbox} with {self.best.ratio_text}, {least:.3g} N*m rms with both, "
            f"{100 * (least / by_form - 1):+.0f} %."
        )


def ratio_sweep(drive: SizedDrive, study: Study) -> RatioSweep:
    """Return a drive's motor on every gearbox of the study's catalog, over the same cycle."""
    made = [
        candidate_of(study, motor=drive.motor.name, gearbox=box.name)
        for box in sorted(study.catalog.gearboxes.values(), key=lambda box: (box.ratio, box.name))
    ]
    found = [
        SweptGearbox(
            gearbox=one.gearbox,
            ratio=one.ratio if one.whole_ratio is None else one.whole_ratio,
            sized=sizing(sized_candidate(one, study), names=SHOWN),
            ratio_text=one.ratio_text,
        )
        for one in made
    ]
    return RatioSweep(motor=drive.motor_name, drive=drive, ideal=alpha_beta(drive), swept=tuple(found))


def can_sweep(study: Study) -> bool:
    """Return whether the gearboxes of the catalog can take a place in the chain that turns: no ratio is fixed there."""
    stage = study.exchanged.stage
    return bool(stage) and study.effort_unit == "N*m" and pinned_ratio(study.document, stage) is None


def middle(figure: Figure) -> float:
    """Return the value, or the middle of the interval; infinite where it is unknown."""
    if figure.value is not None:
        return figure.value
    return float("inf") if figure.low is None or figure.high is None else 0.5 * (figure.low + figure.high)
