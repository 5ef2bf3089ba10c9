"""A recording as plots that move inside a notebook: one frame that needs nothing from outside."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from html import escape
from typing import TYPE_CHECKING

from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.page_picture import plot_name
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.html import html
from torquerig.reporting.moving.channels_plot import HEIGHT, bridged, channels_plot
from torquerig.reporting.moving.page_scripts import data_script, page_scripts
from torquerig.reporting.moving.spectrum_plot import spectrum_plot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST_VALUES = 4_000_000  # of all drawn channels: some 8 MB of the notebook
MOST_CHANNELS = 6  # panels of one plot
HIGHEST = 2000.0  # [Hz] end of the first view of the spectrum
_AROUND, _SPECTRUM = 230, 460  # [px] of captions and buttons; of the spectrum, captions included


def notebook_frame(recording: Recording, figure: Figure, *, main: str) -> str:
    """Return the page of a recording in a frame for a notebook.

    Scripts, styles and samples are in it, so that it works offline, and two frames of a notebook do not mix.
    """
    names = _shown(recording, main)
    height = _AROUND + HEIGHT * len(names) + (_SPECTRUM if _has_spectrum(recording) else 0)
    page = escape(recording_page(recording, figure, names), quote=True)
    style = f"width:100%;height:{height}px;border:0"
    return f'<iframe title="{escape(recording.name)}" style="{style}" srcdoc="{page}"></iframe>'


def recording_page(recording: Recording, figure: Figure, names: Sequence[str]) -> str:
    """Return the page: channels over time, and the spectrum of the torque where there is one."""
    kept = min(recording.samples, MOST_VALUES // len(names))
    shown = _beginning(recording, kept)
    omitted = len(recording.channels) - len(names)
    notes = [
        f"The first {shown.duration:.4g} s of {recording.duration:.4g} s." if kept < recording.samples else "",
        f"{omitted} more channels are in to_frame()." if omitted else "",
    ]
    channels = picture(
        figure, caption=" ".join(["Drag to zoom; the time axes move together.", *filter(None, notes)]),
        alt_text="each channel over time", name="channels",
        plot=channels_plot(shown, names, target=plot_name("channels")),
    )  # fmt: skip
    spectrum = None
    if _has_spectrum(recording):
        made = spectrum_plot(
            shown, shown, target=plot_name("spectrum"), lines=(), motor_speed=0.0, highest=HIGHEST,
        )  # fmt: skip
        made["legend"] = []  # there is one curve, and no filter
        spectrum = data_script(f"data-{plot_name('spectrum')}", made)
    return html(
        "recording.html",
        {"title": recording.summary(), "channels": channels, "spectrum": spectrum,
         "scripts": page_scripts(with_matrices=False)},
    )  # fmt: skip


def _shown(recording: Recording, main: str) -> list[str]:
    return [main, *(name for name in recording.channels if name != main)][:MOST_CHANNELS]


def _has_spectrum(recording: Recording) -> bool:
    return recording.samples > 3 and (recording.find("torque") or recording.find("force")) is not None


def _beginning(recording: Recording, samples: int) -> Recording:
    """Return the first samples, bridged where there is no number."""
    cut = {name: replace(one, values=bridged(one.values[:samples])) for name, one in recording.channels.items()}
    return replace(recording, channels=cut)
