"""Modes, lines and loop of a rig in one picture: the Campbell diagram and its Bode curves."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from torquerig.reporting.figures.bode_figure import draw_loop, draw_transfers
from torquerig.reporting.figures.campbell_figure import draw_campbell
from torquerig.reporting.figures.picture import new_figure
from torquerig.simulation.twin.crossings import Crossing
from torquerig.simulation.twin.linear_twin import Twin
from torquerig.simulation.twin.lines import OrderLine


def modes_figure(
    twin: Twin, lines: Sequence[OrderLine], crossings: Sequence[Crossing], *, top_speed: float, title: str = ""
) -> Figure:
    """Return the Campbell diagram up to ``top_speed`` [rad/s] with the transfers to the sensor and the loop gain.

    The numbers at the crossings are the rows of the table that ``torquerig modes`` prints.
    """
    figure = new_figure(13.0, 7.4)
    found, loops = twin.modes(), twin.margins()
    parts = figure.add_gridspec(3 if loops else 1, 2, width_ratios=(1.35, 1.0))
    speed = float(twin.point.speeds[twin.lowered.node(twin.lowered.leader())])
    campbell = figure.add_subplot(parts[:, 0])
    draw_campbell(campbell, found, lines, crossings, speed=speed, top_speed=top_speed)
    lowest, highest = 0.5, min(0.45 * twin.rate, 4 * max((mode.magnitude for mode in found), default=100.0))
    transfers = figure.add_subplot(parts[0, 1])
    draw_transfers(transfers, twin, lowest=lowest, highest=highest)
    if loops:
        gain = figure.add_subplot(parts[1, 1], sharex=transfers)
        phase = figure.add_subplot(parts[2, 1], sharex=transfers)
        draw_loop(gain, phase, twin, loops[0], lowest=lowest, highest=highest)
    else:
        transfers.set_xlabel("frequency [Hz]")
    if title:
        figure.suptitle(title, x=0.01, ha="left")
    return figure
