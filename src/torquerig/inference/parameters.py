"""Parameters of the nominal model with their priors: what the scenario leaves open, and what it never states."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import sqrt
from typing import get_type_hints

import numpy as np

from torquerig.inference.knobs import Knob, declarations, nuisance_knobs
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.shared_orders import phases
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.model import Scenario

_RECTANGULAR = sqrt(3)  # half-width over standard deviation of a tolerance (JCGM 100:2008, 4.3.7)
_ZERO = 0.05  # of the largest torque: standard deviation of a zero of which nothing is stated
_SCALE = 0.002  # [1] standard deviation of a sensitivity of which nothing is stated
_AMPLITUDE = (
    0.25  # of the logarithm of a line's amplitude of which nothing is stated: no copy of a rig repeats it better
)


def parameters(scenario: Scenario, rig: Rig, runs: Sequence[MeasuredRun]) -> tuple[Knob, ...]:
    """Return the parameters of the nominal model: numbers of the parts, and scale and zero of the sensor."""
    occupancies = [run.run.occupancy_percent or 0.0 for run in runs]
    knobs = nuisance_knobs(rig, scenario.uncertainties, occupancies=occupancies)
    known = {knob.name for knob in knobs}
    others = (*amplitudes(rig), *phases(rig), *_of_sensor(rig, runs))
    return (*knobs, *(knob for knob in others if knob.name not in known))


def amplitudes(rig: Rig) -> Iterator[Knob]:
    """Yield the amplitudes of all stated lines: what a part declares as zero-to-peak, each entry of it."""
    for part in rig.parts:
        for name in _amplitude_fields(type(part)):
            held = getattr(part, name)
            entries = held if isinstance(held, Mapping) else dict(enumerate(held)) if isinstance(held, tuple) else None
            if entries is None:
                entries = {None: held}
            yield from (Knob(part.name, name, _AMPLITUDE, key=key) for key, value in entries.items() if value)


def _amplitude_fields(kind: type[Part]) -> tuple[str, ...]:
    hints = get_type_hints(kind, include_extras=True)
    return tuple(
        name for name, hint in hints.items()
        if any(phrase in one.meaning for one in declarations(hint) for phrase in ("zero-to-peak", "zero to peak"))
    )  # fmt: skip


def _of_sensor(rig: Rig, runs: Sequence[MeasuredRun]) -> tuple[Knob, ...]:
    sensor = rig.part(rig.measured)
    if not sensor.is_sensor or not hasattr(sensor, "zero"):
        return ()
    tolerance = getattr(sensor, "gain_tolerance", 0.0)
    within = getattr(sensor, "zero_tolerance", None)
    largest = max(float(np.abs(run.torque).max(initial=0.0)) for run in runs)
    zero = _ZERO * largest if within is None else within / _RECTANGULAR
    return (
        Knob(sensor.name, "scale", tolerance / _RECTANGULAR or _SCALE),
        *([Knob(sensor.name, "zero", zero, factor=False)] if zero and not getattr(sensor, "tare", False) else []),
    )
