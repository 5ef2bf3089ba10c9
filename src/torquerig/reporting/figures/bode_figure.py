"""Bode diagrams of a linearised rig: transfer to the sensor with open and closed loop, and loop gain with margins."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from torquerig.rig.assembly import Rig
from torquerig.rig.reading_place import reading_place
from torquerig.simulation.twin.linear_twin import Twin
from torquerig.simulation.twin.margins import Margins, grid, loop_gain

Floats = NDArray[np.float64]

MOTOR, LOAD, LOOP, QUIET = "#d1495b", "#1b9e77", "#12395b", "#9aa5b1"


def draw_transfers(axes: Axes, twin: Twin, *, lowest: float, highest: float) -> None:
    """Draw the torque at the sensor per torque on the motor and per torque on the far side, loop open and closed.

    Parameters
    ----------
    lowest, highest : float
        Ends of the frequency axis [Hz].
    """
    frequencies = np.geomspace(lowest, highest, 1500)
    motor, far = twin.lowered.leader(), twin.rig.node(reading_place(twin.rig))
    far = twin.lowered.load_terms[0].on if twin.lowered.load_terms else far
    for node, colour, name in ((motor, MOTOR, "motor"), (far, LOAD, "load")):
        for system, style, how in ((twin.closed_loop, "-", "loop closed"), (twin.open_loop, ":", "open")):
            values = np.abs(system.transfer(f"torque on {node}", twin.sensor, frequencies))
            axes.loglog(frequencies, values, color=colour, linestyle=style, linewidth=1.2, label=f"{name}, {how}")
    axes.set_ylabel(f"sensor [{_units(twin.rig)}]")
    axes.set_title("transfer to the sensor", loc="left")
    axes.legend(fontsize=7, framealpha=0.9)
    _dressed(axes)


def _units(rig: Rig) -> str:
    """Return the units of the sensor's reading per those of motor and load."""
    is_force = rig.in_a_line(rig.part(reading_place(rig)))
    return "N per N m of the motor, per N of the load" if is_force else "N m per N m"


def draw_loop(gain_axes: Axes, phase_axes: Axes, twin: Twin, found: Margins, *, lowest: float, highest: float) -> None:
    """Draw the loop gain of one controller over frequency, its margins marked where they are read."""
    frequencies = grid(twin.open_loop, rate=twin.rate)
    frequencies = frequencies[(frequencies >= lowest) & (frequencies <= highest)]
    row = twin.lowered.drive_names.index(found.controller)
    values = loop_gain(twin.open_loop, twin.lowered, controller=row, rate=twin.rate)(frequencies)
    gain_axes.loglog(frequencies, np.abs(values), color=LOOP, linewidth=1.2)
    gain_axes.axhline(1.0, color=QUIET, linewidth=0.8)
    phase = np.degrees(np.unwrap(np.angle(values)))
    phase -= 360 * np.round(phase[0] / 360)
    phase_axes.semilogx(frequencies, phase, color=LOOP, linewidth=1.2)
    phase_axes.axhline(-180.0, color=QUIET, linewidth=0.8)
    if found.phase_margin is not None and found.phase_at is not None and lowest < found.phase_at < highest:
        at = float(np.interp(found.phase_at, frequencies, phase))
        phase_axes.plot([found.phase_at] * 2, [at, at - found.phase_margin], color=MOTOR, linewidth=1.6)
        phase_axes.text(found.phase_at * 1.1, at - 0.5 * found.phase_margin, f"{found.phase_margin:.0f}°",
                        color=MOTOR, fontsize=8)  # fmt: skip
        gain_axes.plot(found.phase_at, 1.0, "o", color=MOTOR, markersize=4)
    if found.gain_margin is not None and found.gain_at is not None and lowest < found.gain_at < highest:
        gain_axes.plot([found.gain_at] * 2, [1 / found.gain_margin, 1.0], color=MOTOR, linewidth=1.6)
        gain_axes.text(
            found.gain_at * 1.1, found.gain_margin**-0.5, f"x {found.gain_margin:.3g}", color=MOTOR, fontsize=8
        )
    gain_axes.set_ylabel("loop gain [1]")
    gain_axes.set_title(f"loop of {found.controller}", loc="left")
    phase_axes.set_ylabel("phase [°]")
    phase_axes.set_yticks([tick for tick in range(-1080, 361, 90) if phase.min() - 60 <= tick <= phase.max() + 60])
    phase_axes.set_xlabel("frequency [Hz]")
    _dressed(gain_axes)
    _dressed(phase_axes)


def _dressed(axes: Axes) -> None:
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
