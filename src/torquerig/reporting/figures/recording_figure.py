"""A recording in memory at a glance: channels over time, spectrum and levels of its torque."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from torquerig.errors import RecordingError
from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.reporting.figures.info_figure import info_figure
from torquerig.reporting.figures.picture import NotebookFigure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from torquerig.recordings.recording import Recording


def recording_figure(recording: Recording) -> Figure:
    """Return the picture of a recording; without a torque its first channel takes that place.

    The axis of orders is drawn where the run states motor speed and gear ratio. A notebook shows plots to zoom with all
    samples instead.
    """
    if not recording.channels:
        raise RecordingError(f"{recording.name}: has no channel that could be drawn")
    main = recording.find("torque") or recording.find("force") or next(iter(recording.channels))
    run = recording.run
    speed = run.speed / run.gear_ratio if run.speed and run.gear_ratio else None
    made = info_figure(recording_info(recording), main=main, output_speed=speed)
    if isinstance(made, NotebookFigure):
        made.moving = partial(_moving, recording, made, main)
    return made


def _moving(recording: Recording, figure: Figure, main: str) -> str:
    from torquerig.reporting.moving.notebook_page import notebook_frame

    return notebook_frame(recording, figure, main=main)
