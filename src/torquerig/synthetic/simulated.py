"""Contribution of each sensor stage and each mechanism of a rig to its reading, as a labelled mixture."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.simulation.measured_places import reading_channel
from torquerig.simulation.simulator import simulate
from torquerig.synthetic.grid import on_grid
from torquerig.synthetic.mixture import TRUE_LOAD, TRUE_NOISE, component_name, truth

SHAFT_GROUPS = ("mechanical", "cogging", "electrical", "load")
_SENSOR_TORQUE = "true_sensor_torque_Nm"
DIFFERENCE = "difference of runs"
STAGE = "stage of the sensor"
BARE = "run of the bare rig"


def separated_contributions(
    rig: Rig, *, duration: float, seed: int, wander: float = 0.0, scenario: str = ""
) -> Recording:
    """Return a rig's reading with the contribution of each effect as a channel ``component_..._Nm`` [N m].

    A stage of the sensor adds its output minus its input. The mechanisms on the shafts are switched on one after the
    other, the loads first: each adds its run minus the run before it, labelled ``difference of runs`` in the origin.
    This is the contribution in addition to those before it. It depends on the order, because mechanisms interact.
    ``bare`` is the run without any. All components sum to the reading to the last bit (the reading is rounded to a grid
    of 1e-12 for that).

    Parameters
    ----------
    duration : float
        [s].
    wander : float
        As in :func:`simulate`.

    Notes
    -----
    One run for each mechanism, and one more. Phases, load and noise are drawn by their own names, so that they are the
    same in every run.
    """

    def run(one: Rig) -> Recording:
        return simulate(one, duration=duration, seed=seed, wander=wander, scenario=scenario)

    effects = [part for part in rig.parts if part.group in SHAFT_GROUPS and _is_effect(part)]
    effects.sort(key=lambda part: part.group != "load")
    rigs = [rig]
    for part in reversed(effects):
        rigs.insert(0, rigs[0].without(part.name))
    parts: dict[str, NDArray[np.float64]] = {}
    labels: dict[str, str] = {}
    before = np.zeros(0)
    for added, one in zip([None, *effects], rigs, strict=True):
        full = run(one)
        torque = on_grid(full.channels[_SENSOR_TORQUE].values)
        name = added.name.replace(".", "_") if added else "bare"
        parts[name] = torque - before if added else torque
        labels[name] = DIFFERENCE if added else BARE
        before = torque
    for name, values in _stage_shares(rig, full, before):
        parts[name] = values
        labels[name] = STAGE
    return _recording(full, parts, labels)


def _is_effect(part: Part) -> bool:
    return not part.on_shaft and not part.opens_node


def _stage_shares(rig: Rig, full: Recording, torque: NDArray[np.float64]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Yield the contribution of each stage to the torque [N m], in the order of the measuring chain."""
    name = full.torque_name()
    volts = reading_channel(rig, rig.measured, full.channels[_SENSOR_TORQUE].values)
    # what stages add to the recording (an encoder) must not be there twice
    given = {key: one for key, one in full.channels.items() if one.truth} | {name: volts}
    recording, before = replace(full, channels=given), torque
    used: dict[str, int] = {}
    for stage in rig.stages():
        recording = stage.apply(recording)
        after = on_grid(recording.torque())
        if not np.array_equal(after, before):
            word = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", type(stage).__name__).lower()
            used[word] = used.get(word, 0) + 1
            yield word if used[word] == 1 else f"{word}_{used[word]}", after - before
        before = after


def _recording(full: Recording, parts: Mapping[str, NDArray[np.float64]], labels: Mapping[str, str]) -> Recording:
    reading = sum(parts.values(), np.zeros(full.samples))
    name = full.torque_name()
    channel = full.channels[name]
    channels = {key: one for key, one in full.channels.items() if not one.truth or key == TRUE_LOAD}
    channels[name] = replace(channel, values=reading / channel.si_per_unit)
    load = on_grid(channels[TRUE_LOAD].values)
    channels |= {TRUE_LOAD: truth(load), TRUE_NOISE: truth(reading - load)}
    channels |= {component_name(key): truth(values) for key, values in parts.items()}
    return replace(full, channels=channels, origin={**full.origin, "components": dict(labels)})
