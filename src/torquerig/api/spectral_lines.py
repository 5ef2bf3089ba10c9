"""``order_lines``: the lines of a recording over the order of its shaft, and their causes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.api.inputs import drive_from, recording_from
from torquerig.api.result import Result
from torquerig.orders.analysis.angle_resampling import output_turns
from torquerig.orders.analysis.line_detection import DetectedLine, detected_lines
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class OrderLines(Result):
    """The lines that exceed the noise floor of a recording.

    Parameters
    ----------
    recording : Recording
    kinematics : Kinematics
        The motor and gearbox that the causes follow from.
    lines : tuple of DetectedLine
        Lines of the shaft first, then fixed frequencies, then those that one speed cannot separate.
    angle_origin : str
        Where the angle of the shaft comes from.
    turns : ndarray, shape (samples,)
        Of the output shaft.
    """

    recording: Recording
    kinematics: Kinematics
    lines: tuple[DetectedLine, ...]
    angle_origin: str
    turns: NDArray[np.float64] = field(repr=False)

    def summary(self) -> str:
        """Return how many lines were found, and of which kind."""
        kinds = [one.axis for one in self.lines]
        return (
            f"{self.recording.name}: {len(kinds)} spectral lines exceed the noise floor: {kinds.count('order')} of the "
            f"shaft, {kinds.count('frequency')} at a fixed frequency, {kinds.count('either')} not decided; angle "
            f"{self.angle_origin}"
        )

    def to_frame(self) -> pd.DataFrame:
        """Return one row per line: order [1/rev] or frequency [Hz], amplitude [N m], level [dB], cause."""
        import pandas as pd

        words = {"order": "shaft", "frequency": "fixed frequency", "either": "not decided"}
        rows = [
            {
                "belongs_to": words[one.axis],
                "output_order": one.place if one.detected_over == "order" else None,
                "frequency_Hz": one.place if one.detected_over == "frequency" else None,
                "amplitude_Nm": one.amplitude, "above_floor_dB": one.above_dB, "cause": one.label,
            }
            for one in self.lines
        ]  # fmt: skip
        columns = ["belongs_to", "output_order", "frequency_Hz", "amplitude_Nm", "above_floor_dB", "cause"]
        return pd.DataFrame(rows, columns=columns)

    def plot(self) -> Figure:
        """Return order spectrum, order map and measured Campbell diagram."""
        from torquerig.reporting.figures.order_figure import order_figure, order_picture

        shown = order_picture(self.recording, self.turns, lines=self.kinematics.lines(), found=self.lines,
                              ratio=self.kinematics.ratio, counted=self.kinematics.fastest_shaft[1])  # fmt: skip
        return order_figure(shown, title=f"{self.recording.name}: orders of the torque")


def order_lines(
    recording: Recording | str | Path, *, scenario: Scenario | str | Path | None = None, motor: str | None = None,
    ratio: float | None = None, gearbox: str | None = None, mains: float = 50.0, harmonics: int = 4,
    channel: str | None = None, catalogs: Sequence[str | Path] = (),
) -> OrderLines:  # fmt: skip
    """Return the spectral lines of a recording, those of the shaft separated from fixed frequencies.

    Parameters
    ----------
    recording : Recording, or path of its file
    scenario : Scenario or path, optional
        The rig, whose motor, gears and teeth name the causes.
    motor, ratio, gearbox
        Of the catalog, where there is no scenario and the run does not state them.
    mains : float
        Frequency of the grid [Hz], > 0.
    harmonics : int
        Lines of each cause that are looked up.
    channel : str, optional
        Channel with the measured torque, where several have one and none has the role ``compared``.
    catalogs : sequence of path
        Further catalog folders.

    Returns
    -------
    OrderLines
        ``.lines``, ``.to_frame()``, ``.plot()``.

    Raises
    ------
    InputError
        Where motor or ratio are not known.
    RecordingError
        Where no channel and no line of the torque tells the angle of the shaft.

    Notes
    -----
    A line of the shaft keeps its order when the speed changes, a fixed one its frequency; a run at one speed cannot
    separate them, and its lines are reported as not decided.

    Examples
    --------
    >>> import torquerig as tr
    >>> found = tr.order_lines(tr.simulate("wear_rig.yaml", duration=3.0))
    >>> bool((found.to_frame()["cause"] != "").any())
    True
    """
    read = recording_from(recording)
    read = read if channel is None else read.comparing(channel)
    drive = drive_from(read, scenario=scenario, motor=motor, ratio=ratio, gearbox=gearbox, catalogs=catalogs)
    kinematics, read = drive.kinematics, replace(read, run=drive.run_of(read.run))
    lines = kinematics.lines(harmonics)
    angle = best_motor_angle(read, lines, ratio=kinematics.ratio)
    turns = output_turns(angle.values, ratio=kinematics.ratio)
    found = detected_lines(read, turns, kinematics, harmonics=harmonics, mains=mains)
    return OrderLines(recording=read, kinematics=kinematics, lines=found, angle_origin=angle.origin, turns=turns)
