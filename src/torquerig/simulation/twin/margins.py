"""Stability margins of the sampled speed loop: gain, phase and modulus margin."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.loop import sampled_loop
from torquerig.simulation.twin.sensing import measured, with_sensing
from torquerig.simulation.twin.system import LinearSystem, sampled

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]


@dataclass(frozen=True)
class Margins:
    """Margins of one speed loop; a margin is None where the curve never crosses.

    Parameters
    ----------
    controller : str
        Whose loop.
    crossovers : tuple of float
        Where the loop gain is 1 [Hz]; the first is what is mostly called the crossover, a mode may add others.
    phase_margin, phase_at : float or None
        Least distance of the phase from -180 degrees where the gain is 1 [deg], and where [Hz].
    gain_margin, gain_at : float or None
        Least factor by which the gain may grow before the loop is unstable [1], and where the phase is -180 deg [Hz].
    lower_gain : float or None
        Largest factor below 1 at which the phase is -180 degrees [1]: a stable loop must keep more gain than that, an
        unstable one may become stable below it.
    modulus_margin, modulus_at : float
        Least distance of the loop gain from -1 [1], and where [Hz]; its inverse is the largest amplification of a
        disturbance (Maciejowski, Multivariable Feedback Design, section 1.3: 0.5 is a usual demand).
    stable : bool
        Whether every root of the sampled loop lies inside the unit circle (free turning on it).
    """

    controller: str
    crossovers: tuple[float, ...]
    phase_margin: float | None
    phase_at: float | None
    gain_margin: float | None
    gain_at: float | None
    lower_gain: float | None
    modulus_margin: float
    modulus_at: float
    stable: bool


def margins(open_loop: LinearSystem, lowered: Lowered, *, rate: float) -> tuple[Margins, ...]:
    """Return the margins of each speed loop, exact for a controller that works ``rate`` times a second [Hz].

    A rig with several controllers is judged loop by loop, the others open; a drive in torque mode has no loop.
    """
    closed = sampled_loop(open_loop, lowered, rate=rate)
    stable = is_stable(closed)
    return tuple(
        _margins(name, loop_gain(open_loop, lowered, controller=row, rate=rate), rate, open_loop, stable=stable)
        for row, name in enumerate(lowered.drive_names)
        if lowered.drive_terms[row].holds_speed
    )


def is_stable(closed: LinearSystem) -> bool:
    """Whether a sampled closed loop is stable, apart from the angle of rigid rotation."""
    return bool(np.abs(np.linalg.eigvals(closed.A)).max() <= 1 + 1e-7)


def loop_gain(
    open_loop: LinearSystem, lowered: Lowered, *, controller: int = 0, rate: float
) -> Callable[[Floats], Complexes]:
    """Return L(f): controller times held plant, from the speed error to the speed [1], f in [Hz] below ``rate / 2``."""
    drives = lowered.arrays.drives
    commands = [f"command of {name}" for name in lowered.drive_names]
    held = with_sensing(sampled(open_loop, 1 / rate, held=commands), lowered)
    ends = measured(held, lowered, controller)
    small = held.only(inputs=[commands[controller]], outputs=[name for name, _ in ends])
    signs = np.array([sign for _, sign in ends])
    kp, ki = drives.kp[controller], drives.ki[controller]

    def gain(frequencies: Floats) -> Complexes:
        z = np.exp(2j * np.pi * np.asarray(frequencies) / rate)
        speed = small.response(frequencies)[:, :, 0] @ signs
        return np.asarray((kp + ki / rate * z / (z - 1)) * speed)

    return gain


def grid(open_loop: LinearSystem, *, rate: float, points: int = 3000) -> Floats:
    """Return frequencies from 0.01 Hz to half the rate [Hz], dense round every root of the plant."""
    top = 0.499 * rate
    wide = np.geomspace(0.01, top, points)
    roots = np.linalg.eigvals(open_loop.A)
    places = np.abs(roots.imag) / (2 * np.pi)
    widths = np.maximum(np.abs(roots.real) / (2 * np.pi), 1e-6 * places)
    near = (places[:, None] + np.outer(widths, np.linspace(-8, 8, 161))).ravel()
    return np.unique(np.concatenate([wide, near[(near > 0.01) & (near < top)]]))


def _margins(
    name: str, gain: Callable[[Floats], Complexes], rate: float, open_loop: LinearSystem, *, stable: bool
) -> Margins:
    """Return the margins of one loop, found by python-control on its frequency response.

    The response is exact at the grid's frequencies, which are dense round every root; between them python-control
    interpolates it.
    """
    import control

    frequencies = grid(open_loop, rate=rate)
    values = gain(frequencies)
    response = control.FrequencyResponseData(values, 2 * np.pi * frequencies, smooth=True)
    gains, phases, distances, *places = control.stability_margins(response, returnall=True)
    turned, crossovers, nearest = (np.asarray(one) / (2 * np.pi) for one in places)
    phase = min(zip(phases, crossovers, strict=True), key=lambda found: abs(found[0]), default=(None, None))
    above = min((one for one in zip(gains, turned, strict=True) if one[0] > 1), default=(None, None))
    below = max((one for one in gains if one < 1), default=None)
    at_ends = np.abs(1 + values)
    modulus = min([*zip(distances, nearest, strict=True), (at_ends.min(), frequencies[at_ends.argmin()])])
    return Margins(
        controller=name,
        crossovers=tuple(float(one) for one in crossovers),
        phase_margin=_number(phase[0]),
        phase_at=_number(phase[1]),
        gain_margin=_number(above[0]),
        gain_at=_number(above[1]),
        lower_gain=_number(below),
        modulus_margin=float(modulus[0]),
        modulus_at=float(modulus[1]),
        stable=stable,
    )


def _number(value: float | None) -> float | None:
    return None if value is None else float(value)
