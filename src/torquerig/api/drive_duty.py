"""``duty``: how hot the motor of a rig becomes over its duty cycle."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.inputs import scenario_from
from torquerig.api.result import Result
from torquerig.errors import InputError
from torquerig.scenario.checks.recorded_load import refuse_unstated_load
from torquerig.scenario.checks.requirement_check import check_requirement, entry_of
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.scenario.kinematics import ratio_text
from torquerig.scenario.model import Scenario
from torquerig.thermal.duty_temperatures import DutyTemperatures, Span, temperatures_of_duty
from torquerig.thermal.motor_duty import MotorDuty, duty_of_requirement
from torquerig.thermal.motor_variants import ThermalVariants, thermal_variants

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

_UNITS = {"margin": "K", "use": "1", "until": "s", "rms_torque": "N*m", "peak_torque": "N*m", "rms_current": "A"}


@dataclass(frozen=True, kw_only=True)
class MotorHeat(Result):
    """The temperatures of a motor over a duty that is repeated without end.

    Parameters
    ----------
    duty : MotorDuty
        Torque and speed of the motor.
    judged : DutyTemperatures
        Temperatures, margin and time to the limit.
    motors : ThermalVariants
        The motor as the catalog's intervals allow it.
    title : str
    ambient : float
        [C]
    warnings : tuple of str
        What is beyond a rating.
    """

    duty: MotorDuty
    judged: DutyTemperatures
    motors: ThermalVariants
    title: str
    ambient: float
    warnings: tuple[str, ...]

    @property
    def verdict(self) -> str:
        """``safe``, ``too hot`` or ``unsure``."""
        return self.judged.word

    def summary(self) -> str:
        """Return the verdict in one sentence."""
        from torquerig.thermal.duty_text import verdict_sentence

        return f"{self.title}: {verdict_sentence(self.judged, self.motors)}"

    def to_frame(self) -> pd.DataFrame:
        """Return one row per figure: nominal value, lowest and highest over the catalog's intervals, unit."""
        import pandas as pd

        rows = {}
        for one in fields(self.judged):
            found = getattr(self.judged, one.name)
            value, low, high = (found.value, found.low, found.high) if isinstance(found, Span) else (found, None, None)
            rows[one.name] = {"value": value, "low": low, "high": high, "unit": _UNITS.get(one.name, "C")}
        return pd.DataFrame.from_dict(rows, orient="index").rename_axis("figure")

    def as_dict(self) -> dict[str, Any]:
        """Return verdict, summary, warnings and figures as plain values."""
        figures = {str(name): dict(row) for name, row in self.to_frame().iterrows()}
        return {"verdict": self.verdict, "summary": self.summary(), "warnings": list(self.warnings), "figures": figures}

    def plot(self) -> Figure:
        """Return speed and torque of the cycle, the settled cycle of temperatures, and the way there from cold."""
        from torquerig.reporting.sizing.duty_figure import duty_figure

        return duty_figure(self.duty, self.motors, ambient=self.ambient, title=self.title)


def duty(
    scenario: Scenario | str | Path, *, motor: str | None = None, gearbox: str | None = None, ambient: float = 40.0,
    duration: float | None = None,
) -> MotorHeat:  # fmt: skip
    """Return how hot the motor of a rig becomes when the profile of its scenario is repeated without end.

    Parameters
    ----------
    scenario : Scenario, or path of its file
    motor, gearbox : str, optional
        Another entry of the catalog, where ``scenario`` is a path.
    ambient : float
        Temperature of the surroundings [C].
    duration : float, optional
        Length of a profile that states none, such as a ramp [s], > 0; ``recording.duration`` without it.

    Returns
    -------
    MotorHeat
        ``.verdict``, ``.to_frame()``, ``.plot()``.

    Raises
    ------
    InputError
        Where the motor is not of the catalog, so that nothing is known of its heat, or a load is recorded only.

    Examples
    --------
    >>> import torquerig as tr
    >>> heat = tr.duty("wear_rig.yaml", motor="HDS6A-0104A")
    >>> heat.verdict in ("safe", "unsure", "too hot")
    True
    """
    made = scenario_from(scenario, motor=motor, gearbox=gearbox)
    if made.catalog is None or (entry := entry_of(made.rig, made.catalog)) is None:
        raise InputError(f"{made.title}: the driven motor is not in the catalog, so that nothing is known of its heat; "
                         "name one with catalog: in the scenario, or with motor=")  # fmt: skip
    refuse_unstated_load(made)
    points = made.rig.run.set_points
    length = duration or made.recording.duration if points is None else points.breakpoints(top=0.0, duration=0.0).length
    warnings = check_requirement(made, made.catalog, duration=length)
    asked = duty_of_requirement(drive_requirement(made.rig, duration=length))
    motors = thermal_variants(entry)
    title = f"{entry.name}, {ratio_text(made.rig)}, {made.rig.run.profile}, {length:g} s"
    judged = temperatures_of_duty(asked, motors, ambient=ambient)
    return MotorHeat(duty=asked, judged=judged, motors=motors, title=title, ambient=ambient, warnings=warnings)
