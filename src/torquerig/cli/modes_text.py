"""Modes and poles as ``torquerig modes`` prints them: oscillations as frequencies, everything else in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from torquerig.plain_table import grid, wrapped
from torquerig.simulation.twin.linear_twin import Twin
from torquerig.simulation.twin.modes import Mode, Pole, rigid_motions

RAISED = 1e-4  # [1] from here on the printed figures differ


def modes_text(twin: Twin) -> str:
    """Return the table of the modes, their shapes, and the motions that have no frequency."""
    modes, words = twin.modes(), list(_rigid(twin))
    if not modes:
        return "\n".join([wrapped(f"no modes: {_why_none(twin)}"), *map(wrapped, words), ""])
    rows = [
        [str(number), f"{mode.undamped:.5g}", "none" if mode.is_overdamped else f"{mode.damped:.5g}",
         f"{mode.damping:.4f}"]
        for number, mode in enumerate(modes, start=1)
    ]  # fmt: skip
    words += [
        f"mode {number}: {mode.words}{_creeping(mode)}{_raised(mode)}" for number, mode in enumerate(modes, start=1)
    ]
    return "\n".join([
        grid([["mode", "undamped Hz", "damped Hz", "damping ratio"], *rows]), *map(wrapped, words), ""
    ])  # fmt: skip


def poles_text(poles: Sequence[Pole]) -> str:
    """Return the table of the closed loop; a pole that does not oscillate has a time constant and no frequency."""
    rows = [
        [one.what, f"{one.frequency:.5g}" if one.oscillates else "none",
         f"{one.damping:.4f}" if one.oscillates else _course(one.time_constant)]
        for one in poles
    ]  # fmt: skip
    return grid([["closed loop", "natural frequency Hz", "damping ratio"], *rows]) + "\n"


def _rigid(twin: Twin) -> Iterator[str]:
    for nodes in rigid_motions(twin.lowered):
        in_a_line = all(node in twin.lowered.in_a_line for node in nodes)
        moving = "all shafts" if len(nodes) == len(twin.lowered.nodes) else ", ".join(nodes)
        moving = "everything" if in_a_line and moving == "all shafts" else moving
        how = "moves in a line" if moving == "everything" else "move in a line" if in_a_line else "turn"
        yield f"rigid-body motion: {moving} {how} freely; this motion has no frequency"


def _why_none(twin: Twin) -> str:
    if not twin.lowered.arrays.springs.a.size:
        return "this rig has no torsional spring"
    return "both ends of every torsional spring are held, by an imposed motion or a locked end"


def _raised(mode: Mode) -> str:
    if mode.is_overdamped or mode.damped <= mode.undamped * (1 + RAISED):
        return ""
    return (
        "; damped above undamped: damping or friction holds a shaft that swings in the undamped mode, or the loss of a "
        "gear adds to the torque at its input"
    )


def _creeping(mode: Mode) -> str:
    if not mode.is_overdamped:
        return ""
    return f"; overdamped: it does not oscillate, and returns with a time constant of {_seconds(mode.time_constant)}"


def _course(time_constant: float) -> str:
    if time_constant < 0:
        return f"grows, time constant {_seconds(-time_constant)}"
    return f"overdamped, time constant {_seconds(time_constant)}"


def _seconds(value: float) -> str:
    return f"{1000 * value:.3g} ms" if value < 1 else f"{value:.3g} s"
