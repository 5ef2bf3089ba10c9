"""Frequency response from load to reading of the linear twin, as used by the load inverse."""

from __future__ import annotations

import numpy as np

from torquerig.errors import InputError
from torquerig.filters.load_response import LoadResponse
from torquerig.rig.assembly import Rig
from torquerig.rig.load_lever import load_lever
from torquerig.rig.terms import Load
from torquerig.sensor_stages.amplifier import AmplifierLowPass
from torquerig.simulation.sampling import SAMPLE_RATE
from torquerig.simulation.twin.linear_twin import twin_of
from torquerig.simulation.twin.plant import load_input

LOWEST, HIGHEST, POINTS = 2e-6, 0.5, 6_000  # of the sample rate; 0.2 % a step, a tenth of the sharpest mode


def load_response(rig: Rig, *, rate: float = SAMPLE_RATE) -> LoadResponse:
    """Return the reading per true load of the rig's twin at its operating point, speed loop and amplifier included.

    Up to half the sample rate ``rate`` [Hz], at which the speed loop runs too. The true load is all that opposes the
    wear part's motion, friction included, referred to the measured shaft: the twin's transfer from the load to the
    measured torque over that from the load to the opposing torque.

    Raises
    ------
    InputError
        For a rig without a load.
    """
    twin = twin_of(rig, rate=rate)
    rows = [row for row, term in enumerate(twin.lowered.load_terms) if isinstance(term, Load)]
    if not rows:
        raise InputError("the rig has no load whose torque could be read back; add one, such as a particle_load")
    frequencies = rate * np.geomspace(LOWEST, HIGHEST, POINTS)
    cause = load_input(twin.lowered, rows[0])
    worn = twin.lowered.nodes[int(twin.lowered.arrays.loads.on[rows[0]])]
    system = twin.closed_loop.only(inputs=[cause], outputs=[twin.sensor, f"opposing torque on {worn}"])
    read, opposing = system.response(frequencies)[:, :, 0].T
    opposing = opposing * load_lever(rig, worn)
    for stage in rig.stages():
        if isinstance(stage, AmplifierLowPass):
            read = read * _butterworth(frequencies / stage.cutoff, stage.order)
    return LoadResponse(frequencies, read / opposing, "the linear twin of the scenario's rig")


def _butterworth(ratio: np.ndarray, order: int) -> np.ndarray:
    """Return the analog Butterworth low-pass at ``ratio`` times its cutoff."""
    poles = np.exp(1j * np.pi * (2 * np.arange(order) + order + 1) / (2 * order))
    return np.asarray(np.prod(-poles / (1j * ratio[:, None] - poles), axis=1))
