"""Each motor on each gearbox as a rig: catalog values inserted, speed loop tuned, drive limited."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import pi
from typing import Any

from torquerig.document import Document
from torquerig.errors import InputError, UnknownNameError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor, SpeedController
from torquerig.rig.terms import Inertia
from torquerig.scenario.kinematics import torque_gain
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.study.definition import Study
from torquerig.study.settings import SpeedLoopRule


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A motor on a gearbox.

    Parameters
    ----------
    motor, gearbox : str
        Names in the catalog (an alias stays an alias).
    ratio : float
        Motor turns per output turn [1].
    """

    motor: str
    gearbox: str
    ratio: float

    @property
    def name(self) -> str:
        """The name in tables: ``HDS6A-0104A 5:1``."""
        return f"{self.motor} {self.ratio:g}:1"


def candidates(study: Study) -> tuple[Candidate, ...]:
    """Return all motors on all gearboxes; a ratio in the rig's gear fixes the gearbox."""
    settings, catalog = study.settings, study.catalog
    _, gear_part = drive_parts(study.document)
    motors = tuple(catalog.motors) if settings.motors == "all" else settings.motors
    _refuse_unknown(study, motors)
    written = study.document.data["rig"][gear_part]
    if "ratio" in written:
        pinned, place = str(written.get("catalog", gear_part)), study.document.place(("rig", gear_part, "ratio"))
        ratio = written["ratio"]
        if isinstance(ratio, bool) or not isinstance(ratio, int | float) or ratio == 0:
            raise InputError(f"{place}: {ratio!r} is no ratio; write the motor turns per output turn, such as 5")
        return tuple(Candidate(motor=m, gearbox=pinned, ratio=float(ratio)) for m in motors)
    return tuple(
        Candidate(motor=motor, gearbox=gearbox, ratio=catalog.gearbox(gearbox).ratio)
        for motor in motors
        for gearbox in settings.gearboxes
    )


def _refuse_unknown(study: Study, motors: tuple[str, ...]) -> None:
    present, catalog = study.settings.present, study.catalog
    boxes = study.settings.gearboxes
    named: tuple[tuple[tuple[str, ...], tuple[str, ...], Callable[[str], object]], ...] = (
        (("motors",), motors, catalog.motor),
        (("gearboxes",), boxes, catalog.gearbox),
        (("present", "motor"), (present.motor,), catalog.motor),
        (("present", "gearbox"), (present.gearbox,), catalog.gearbox),
    )
    for key, names, look_up in named:
        for name in names:
            try:
                look_up(name)
            except UnknownNameError as error:
                raise UnknownNameError(f"{study.document.place(('study', *key))}: {error}") from None


def drive_parts(document: Document) -> tuple[str, str]:
    """Return the names of the motor and the gear that candidates take the place of."""
    rig: Mapping[str, Any] = document.data.get("rig", {})
    if not isinstance(rig, dict):
        raise InputError(f"{document.place(('rig',))}: a scenario needs a mapping named rig: with one entry per part")
    found = []
    for kind in ("motor", "gear"):
        names = [name for name, part in rig.items() if isinstance(part, dict) and part.get("kind") == kind]
        if len(names) != 1:
            raise InputError(f"{document.path}: a study exchanges one {kind}, but the rig has {len(names)}; keep one")
        found.append(str(names[0]))
    return found[0], found[1]


def scenario_of(candidate: Candidate, study: Study, *, seed: int) -> Scenario:
    """Return the scenario with the candidate's motor and gearbox, its loop tuned by the rule, its drive limited.

    ``seed`` determines the values drawn from the catalog's intervals.
    """
    document, catalog = study.document, study.catalog
    motor_part, gear_part = drive_parts(document)
    data = copy.deepcopy(document.data)
    written = data["rig"][motor_part]
    if written.get("catalog") != candidate.motor:
        ripple = {key: written[key] for key in ("ripple",) if key in written}  # the study chooses the ripple model
        data["rig"][motor_part] = {"kind": "motor", "catalog": candidate.motor, **ripple}
    if candidate.gearbox in catalog.gearboxes:
        data["rig"][gear_part]["catalog"] = candidate.gearbox
    scenario = read_scenario(replace(document, data=data), catalog, seed=seed)
    limited = drive_limited(scenario.rig, study.settings.sensor_limit)
    return replace(scenario, rig=loop_tuned(limited, study.settings.speed_loop))


def drive_limited(rig: Rig, sensor_limit: float) -> Rig:
    """Return the rig with the drive's torque limit lowered to at most ``sensor_limit`` [N m] at the sensor."""
    motor = rig.parts_of(Motor)[0]
    return rig.changed(replace(motor, torque_limit=min(motor.torque_limit, sensor_limit / torque_gain(rig))))


def loop_tuned(rig: Rig, rule: SpeedLoopRule) -> Rig:
    """Return the rig with ``kp = 2 pi crossover J`` and ``ki = kp 2 pi corner``, J all inertia seen by the motor.

    The crossover of the open loop ``kp / (J s)``; it must stay well below the first torsional mode, which is not
    checked here (the drives of the study have theirs at 100 to 210 Hz).
    """
    controller = rig.parts_of(SpeedController)[0]
    ratios = rig.speed_ratios(rig.node(controller.motor))
    inertias = [term for part in rig.parts for term in part.terms(rig) if isinstance(term, Inertia)]
    seen = sum(term.inertia * ratios.get(term.node, 0.0) ** 2 for term in inertias)
    kp = 2 * pi * rule.crossover * seen
    return rig.changed(replace(controller, kp=kp, ki=kp * 2 * pi * rule.integral_corner))
