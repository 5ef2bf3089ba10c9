"""Share of the wear part's load in the reading: above and below the crossover of the speed loop, and its bandwidth."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

import numpy as np

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.rig.assembly import Rig
from torquerig.rig.load_lever import load_lever
from torquerig.rig.terms import Inertia, Load, Spring
from torquerig.scenario.kinematics import kinematics_of
from torquerig.simulation.twin.linear_twin import twin_of
from torquerig.simulation.twin.plant import load_input

FLAT = 0.10  # [1] largest error of the reading relative to the load
SLOW = 0.15  # [1/rev] periods of slow load per turn of the output shaft: slower than all that turns
_OF_FIRST_MODE = np.geomspace(2.5e-4, 10.0, 800)  # [1] of the first mode; 1.3 % from one frequency to the next


def load_fidelity(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``load_fidelity``: the share of the load that reaches the sensor outside the speed loop [1].

    Above the loop's crossover and below the first mode, only the inertia of the motor side reacts to the load, and
    ``J1 / (J1 + J2)`` of the load is in the sensor, J1 before and J2 behind it.
    """
    return {
        "load_fidelity": over_intervals(
            drive.data, lambda v: rigid_fidelity(drive.with_values(v)), source="J1 / (J1 + J2)"
        )
    }


def loop_fidelity(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``loop_fidelity`` [1], the share of slow load, and ``flat_to`` [Hz], the bandwidth of the reading.

    Slow load has 0.15 periods in a turn of the output shaft: 0.5 Hz at 200 rpm. Below the crossover the share is 1
    (for an integrating controller); flat is within 10 % of the load, up to ten times the first mode. Both are from
    the linear twin with its loop closed, without amplifier, gaps and saturation.
    """
    rotor = {name: known for name, known in drive.data.items() if "inertia" in name}
    found: dict[tuple[float, ...], tuple[float, float]] = {}

    def of_twin(values: Values, place: int) -> float:
        key = tuple(values[name] for name in rotor)
        if key not in found:
            found[key] = twin_fidelity(drive.with_values(values))
        return found[key][place]

    if not any(isinstance(term, Load) for term in drive.rig.terms()):
        absent = Figure(missing="a load at the wear part")
        return {"loop_fidelity": absent, "flat_to": absent}
    source = "linear twin, speed loop closed"
    return {
        "loop_fidelity": over_intervals(rotor, lambda v: of_twin(v, 0), source=source),
        "flat_to": over_intervals(rotor, lambda v: of_twin(v, 1), unit="Hz", source=source),
    }


def rigid_fidelity(rig: Rig) -> float:
    """Return ``J1 / (J1 + J2)``: inertia before the sensor over all, referred to the sensor's shaft [1]."""
    terms = rig.terms()
    springs = [term for term in terms if isinstance(term, Spring)]
    sensed = next(spring for spring in springs if spring.name == rig.measured)
    before = _joined(sensed.a, [spring for spring in springs if spring is not sensed])
    ratios = rig.speed_ratios(sensed.b)
    shares = [0.0, 0.0]
    for term in terms:
        if isinstance(term, Inertia):
            shares[term.node in before] += term.inertia * ratios.get(term.node, 0.0) ** 2
    return shares[True] / sum(shares)


def twin_fidelity(rig: Rig) -> tuple[float, float]:
    """Return the share of slow load in the reading, and the frequency up to which it is within 10 % [Hz]."""
    frequencies = frequencies_of(rig)
    slow = SLOW * abs(rig.run.speed or 0.0) / (2 * pi * kinematics_of(rig).ratio) or frequencies[0]
    gain = np.abs(reading_per_load(rig, np.append(frequencies, slow), closed=True))
    off = np.flatnonzero(np.abs(gain[:-1] - 1) > FLAT)
    return float(gain[-1]), float(frequencies[off[0] if off.size else -1])


def frequencies_of(rig: Rig) -> np.ndarray:
    """Return frequencies [Hz] from far below the first mode of a rig to ten times that, shape (frequencies,)."""
    first = next((mode.undamped for mode in twin_of(rig).modes()), 1.0)
    return np.asarray(_OF_FIRST_MODE * first)


def reading_per_load(rig: Rig, frequencies: np.ndarray, *, closed: bool) -> np.ndarray:
    """Return the torque in the sensor per load referred to its shaft, complex, shape (frequencies,)."""
    twin = twin_of(rig)
    row = next(row for row, term in enumerate(twin.lowered.load_terms) if isinstance(term, Load))
    worn = twin.lowered.nodes[int(twin.lowered.arrays.loads.on[row])]
    system = twin.closed_loop if closed else twin.open_loop
    outputs = [twin.sensor, f"opposing torque on {worn}"]
    read, opposing = (
        system.only(inputs=[load_input(twin.lowered, row)], outputs=outputs).response(frequencies)[:, :, 0].T
    )
    return np.asarray(read / (opposing * load_lever(rig, worn)))


def _joined(start: str, springs: list[Spring]) -> set[str]:
    found, waiting = {start}, [start]
    while waiting:
        here = waiting.pop()
        for spring in springs:
            for near, far in ((spring.a, spring.b), (spring.b, spring.a)):
                if near == here and far not in found:
                    found.add(far)
                    waiting.append(far)
    return found
