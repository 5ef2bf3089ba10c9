"""``modes``: the modes of a rig, the margins of its speed loop, and which line meets which mode."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.inputs import scenario_from
from torquerig.api.result import Result, records
from torquerig.errors import InputError
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.simulation.twin.crossings import Crossing
from torquerig.simulation.twin.linear_twin import Twin, twin_of
from torquerig.simulation.twin.lines import OrderLine

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

HIGHEST_SPEED = 3000.0  # [rpm] of the Campbell diagram of a rig without set-point
BEYOND = 1.5  # times the set-point up to which crossings are listed


@dataclass(frozen=True, kw_only=True)
class RigModes(Result):
    """The linear model of a rig about its operating point.

    Parameters
    ----------
    twin : Twin
        Its transfer functions are python-control systems: ``twin.closed_loop.to_control()``.
    lines : tuple of OrderLine
        The order lines of motor, gears and effects.
    crossings : tuple of Crossing
        Where a line meets a mode, the strongest at the sensor first; empty where no spring is read.
    title : str
    top_speed : float
        Highest motor speed that was looked at [rad/s].
    """

    twin: Twin
    lines: tuple[OrderLine, ...]
    crossings: tuple[Crossing, ...]
    title: str
    top_speed: float

    @property
    def stable(self) -> bool:
        """Whether nothing grows with the sampled speed loop closed."""
        return self.twin.stable

    @property
    def margins(self) -> pd.DataFrame:
        """One row per speed loop: crossover [Hz], phase margin [deg], gain margin [1], modulus margin [1]."""
        import pandas as pd

        rows = [
            {
                "controller": one.controller, "crossover_Hz": one.crossovers[0] if one.crossovers else None,
                "phase_margin_deg": one.phase_margin, "gain_margin": one.gain_margin,
                "modulus_margin": one.modulus_margin, "stable": one.stable,
            }
            for one in self.twin.margins()
        ]  # fmt: skip
        columns = ["controller", "crossover_Hz", "phase_margin_deg", "gain_margin", "modulus_margin", "stable"]
        return pd.DataFrame(rows, columns=columns)

    def summary(self) -> str:
        """Return the natural frequencies and whether the loop is stable, in one sentence."""
        found = ", ".join(f"{one.undamped:.4g}" for one in self.twin.modes()) or "none"
        loop = "" if not self.twin.lowered.drive_names else f"; the speed loop is {'' if self.stable else 'un'}stable"
        return f"{self.title}: undamped natural frequencies {found} Hz{loop}"

    def to_frame(self) -> pd.DataFrame:
        """Return one row per mode: undamped and damped frequency [Hz], damping ratio [1], shape in words.

        An overdamped mode has no damped frequency (NaN); rigid-body motions are not among them.
        """
        import pandas as pd

        rows = [
            {
                "undamped_Hz": one.undamped, "damped_Hz": float("nan") if one.is_overdamped else one.damped,
                "damping_ratio": one.damping, "shape": one.words,
            }
            for one in self.twin.modes()
        ]  # fmt: skip
        frame = pd.DataFrame(rows, columns=["undamped_Hz", "damped_Hz", "damping_ratio", "shape"])
        frame.index = pd.RangeIndex(1, len(frame) + 1, name="mode")
        return frame

    def as_dict(self) -> dict[str, Any]:
        """Return modes and margins as plain values."""
        return {"summary": self.summary(), "modes": records(self.to_frame()), "margins": records(self.margins)}

    def plot(self) -> Figure:
        """Return the Campbell diagram and the Bode curves."""
        from torquerig.reporting.figures.modes_figure import modes_figure

        if not self.twin.reads_a_spring:
            raise InputError(f"{self.title}: no spring is read, so that there is no transfer function to draw")
        return modes_figure(self.twin, self.lines, self.crossings, top_speed=self.top_speed, title=self.title)


def modes(
    scenario: Scenario | str | Path, *, speed_max: float | None = None, sample_rate: float | None = None
) -> RigModes:
    """Return the modes of a rig, the margins of its speed loop, and at which speeds a line meets a mode.

    Parameters
    ----------
    scenario : Scenario, or path of its file
    speed_max : float, optional
        Highest motor speed [rpm], > 0; 1.5 times the set-point without it.
    sample_rate : float, optional
        Of the sampled speed controller [Hz], > 0; that of the scenario's section recording without it.

    Returns
    -------
    RigModes
        ``.to_frame()`` (modes), ``.margins``, ``.crossings``, ``.plot()``.

    Raises
    ------
    InputError
        Where the rig has no one operating point.

    Notes
    -----
    The rig is linear about its operating point; ``twin.point.left_out`` lists what that leaves out.

    Examples
    --------
    >>> import torquerig as tr
    >>> found = tr.modes("wear_rig.yaml")
    >>> bool(found.to_frame()["undamped_Hz"].is_monotonic_increasing), found.stable
    (True, True)
    """
    if (sample_rate is not None and not sample_rate > 0) or (speed_max is not None and not speed_max > 0):
        raise InputError("sample_rate and speed_max must be more than 0; give for example speed_max=3000")
    made = scenario_from(scenario)
    twin = twin_of(made.rig, rate=sample_rate or made.recording.sample_rate, seed=made.seed)
    rpm = speed_max or BEYOND * abs(twin.motor_speed_rpm) or HIGHEST_SPEED
    lines = tuple(twin.order_lines(kinematics_of(made.rig).lines()))
    crossings = twin.crossings(lines, top_speed=rpm * pi / 30) if twin.reads_a_spring else ()
    return RigModes(twin=twin, lines=lines, crossings=tuple(crossings), title=made.title, top_speed=rpm * pi / 30)
