"""The outputs of a run: what the measured places read, the truth channels, and the probes of the rig."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import EFFORTS, Channel
from torquerig.rig.assembly import Rig
from torquerig.rig.load_lever import load_lever
from torquerig.rig.parts import Probe
from torquerig.rig.reading_place import reading_place
from torquerig.rig.terms import Load
from torquerig.simulation import kernel
from torquerig.simulation.arrays import Outputs
from torquerig.simulation.lower import Lowered
from torquerig.simulation.measured_places import (
    Output,
    channel_name,
    on_shaft,
    place_output,
    reading_channel,
    role_of,
    what_is_read,
    words,
)

TRUE_OUTPUTS = 2  # the first outputs: the true value of what is measured, and the true load


def outputs_of(rig: Rig, lowered: Lowered) -> tuple[Output, ...]:
    """Return the outputs: first the measured one (a spring, an imposed motion), then truth channels and probes."""
    motor, part = lowered.node(lowered.leader()), _worn(rig, lowered)
    here, driven = words(rig, reading_place(rig)), words(rig, lowered.leader())
    effort, rate = here.effort, here.rate
    quantity, ending, _ = what_is_read(rig, rig.measured)
    listed = [
        place_output(rig, lowered, rig.measured, name=f"true_sensor_{quantity}_{ending}"),
        Output(f"true_load_{effort[1]}", kernel.OPPOSING_TORQUE, part, effort[0], effort[2],
               factor=1.0 if part == len(lowered.nodes) else load_lever(rig, lowered.nodes[part])),
        Output(_named("motor", driven.place), kernel.ANGLE, motor, driven.motor[2], driven.place[2]),
        Output(_named("motor", driven.rate), kernel.SPEED, motor, driven.motor[1], driven.rate[2]),
        Output(_named("output", rate), kernel.SPEED, part, rate[0], rate[2]),
    ]  # fmt: skip
    if lowered.drive_terms:
        name = _named("motor", driven.effort)
        listed.append(Output(name, kernel.DRIVE_TORQUE, 0, driven.motor[0], driven.effort[2]))
    for row, term in enumerate(lowered.imposed_terms):
        taken = words(rig, term.on)
        if not term.released:
            name = _named(term.name, taken.effort)
            listed.append(Output(name, kernel.IMPOSING_TORQUE, row, taken.motor[0], taken.effort[2]))
    return (*listed, *_at_further_places(rig, lowered), *(_probed(rig, lowered, each) for each in rig.parts_of(Probe)))


def _at_further_places(rig: Rig, lowered: Lowered) -> tuple[Output, ...]:
    """Return the truth of every further measured place; a probe writes what is true already."""
    answer = []
    for place in rig.also_measured:
        if not isinstance(rig.part(place), Probe):
            quantity, ending, _ = what_is_read(rig, place)
            answer.append(place_output(rig, lowered, place, name=f"true_{quantity}_at_{place}_{ending}"))
    return tuple(answer)


def _named(what: str, quantity: tuple[str, str, str]) -> str:
    return f"true_{what}_{quantity[0]}_{quantity[1]}"


def _probed(rig: Rig, lowered: Lowered, probe: Probe) -> Output:
    """Return the output of a probe; a torque that ``measured`` does not name is context, never the compared one."""
    quantity, ending, _ = what_is_read(rig, probe.name)
    made = place_output(rig, lowered, probe.name, name=f"{probe.name}_{ending}", truth=False)
    if quantity in EFFORTS and probe.name not in rig.places:
        return replace(made, role="context")
    quantity, aside = on_shaft(rig, probe.name)
    return replace(made, quantity=quantity, role=aside or role_of(rig, probe.name))


def as_arrays(outputs: tuple[Output, ...]) -> Outputs:
    """Return the outputs in the layout of the kernel."""
    kinds, rows = ([getattr(output, field) for output in outputs] for field in ("kind", "row"))
    return Outputs(np.array(kinds, dtype=np.uint64), np.array(rows, dtype=np.uint64))


def true_channels(outputs: tuple[Output, ...], kept: NDArray[np.float64], *, rate: float) -> dict[str, Channel]:
    """Return one channel per output; the parameters are those of :func:`channels_of`."""
    return {
        output.name: Channel(
            values=output.values(values, rate), quantity=output.quantity, unit=output.unit, truth=output.truth,
            of=output.of, role=output.role,
        )
        for output, values in zip(outputs, kept, strict=True)
    }  # fmt: skip


def channels_of(
    rig: Rig, outputs: tuple[Output, ...], kept: NDArray[np.float64], *, rate: float
) -> dict[str, Channel]:  # fmt: skip
    """Return the channels of a run: those of the measured places before their stages, and one per output.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
        In SI units.
    rate : float
        Samples per second [Hz].
    """
    found = true_channels(outputs, kept, rate=rate)
    true = {one.of: one.values for one in found.values() if one.truth and one.of is not None}
    readings = {
        channel_name(rig, place): reading_channel(rig, place, true[place])
        for place in rig.places if not isinstance(rig.part(place), Probe)
    }  # fmt: skip
    return {**readings, **found}


def _worn(rig: Rig, lowered: Lowered) -> int:
    """Return the node that carries the load; without one, the output side of the measured part."""
    carrying = [term.on for term in lowered.load_terms if isinstance(term, Load)]
    carrying += [term.on for term in lowered.angle_load_terms]
    return lowered.node(carrying[0] if carrying else rig.node(reading_place(rig)))
