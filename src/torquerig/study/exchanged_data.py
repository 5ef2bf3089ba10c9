"""The data of a candidate: the scenario's parts with another motor and another stage in their places."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from torquerig.catalog.entry import UNKNOWN
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.metrics.drive_margins import ExchangedStage
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.parameter import Estimate
from torquerig.rig.assembly import HOST_FIELDS
from torquerig.study.exchange import STAGE_KINDS

if TYPE_CHECKING:
    from torquerig.document import Document
    from torquerig.study.definition import Study

PLACE_KEYS = ("after",)
"""What a part keeps of the one that it replaces: its place on the shaft."""
STAGE_EFFECTS: Mapping[str, tuple[str, ...]] = {"belt_lines": ("belt",), "tooth_mesh": ()}
"""Effects that another stage cannot have, with the kinds of stages that can: no belt, no stated teeth, other teeth."""


def document_of(motor: str, gearbox: str, study: Study) -> Document:
    """Return the scenario's document with the named motor and stage; see :class:`Candidate` for the names."""
    document, parts = study.document, study.exchanged
    data = copy.deepcopy(document.data)
    rig = data["rig"]
    written = rig[parts.motor]
    if "catalog" not in written:
        raise InputError(
            f"{document.place(('rig', parts.motor))}: a study needs the ratings of the motor; name its entry with "
            "catalog:, and state beside it what is known better"
        )
    if written["catalog"] != motor:
        kept = {key: written[key] for key in ("ripple", *PLACE_KEYS) if key in written}  # the study chooses the ripple
        rig[parts.motor] = {"kind": "motor", "catalog": motor, **kept}
    if gearbox and not stays(gearbox, study):
        rig[parts.stage] = _stage(rig[parts.stage], gearbox, study)
        for name in left_out_effects(gearbox, study):
            del rig[name]
    return replace(document, data=data)


def look_up_stage(name: str, study: Study) -> ExchangedStage:
    """Return name, price and efficiency of a stage; the efficiency is unknown for stages that are no catalog entry.

    Raises
    ------
    UnknownNameError
        Where it is neither in the catalog, nor in ``study: stages:``, nor the stage of the rig.
    """
    stated, own = study.settings.stages, study.exchanged.stage
    if name in stated:
        price = stated[name].price
        known = UNKNOWN if price is None else Estimate(price, evidence="DOC", source="the scenario", unit="EUR")
        return ExchangedStage(name=name, price=known)
    if name == own:
        return ExchangedStage(name=name)
    try:
        found = study.catalog.gearbox(name)
    except UnknownNameError as error:
        others = ", ".join(repr(one) for one in (*stated, own))
        raise UnknownNameError(f"{error}, and it is none of the scenario's stages ({others})") from None
    return ExchangedStage(name=found.name, price=found.price, efficiency=found.efficiency)


def stays(gearbox: str, study: Study) -> bool:
    """Return whether the rig states this very stage, so that nothing of it is replaced."""
    own = study.exchanged.stage
    return gearbox == own or (
        gearbox not in study.settings.stages and study.document.data["rig"][own].get("catalog") == gearbox
    )


def is_new_stage(gearbox: str, ratio: float, study: Study) -> bool:
    """Return whether a stage of this ratio [1] must be bought: another one, or the present one with another ratio."""
    present = look_up_stage(study.present_gearbox, study).name
    if look_up_stage(gearbox, study).name != present:
        return True
    entry = study.catalog.gearboxes.get(present)
    return entry is not None and entry.ratio != ratio


def left_out_effects(gearbox: str, study: Study) -> tuple[str, ...]:
    """Return the effects of the rig's stage that this candidate cannot have.

    Lines of a belt, a mesh without teeth, and the mesh of a fixed-axis pair where the candidate is planetary or the
    other way round.
    """
    if not gearbox or stays(gearbox, study):
        return ()
    own, stated = study.exchanged.stage, study.settings.stages.get(gearbox)
    kind = str(stated.part.get("kind")) if stated else kind_in_catalog(gearbox, study)
    forms = _forms_of_teeth(stated.part if stated else {"catalog": gearbox}, study)
    same = bool(forms) and forms == _forms_of_teeth(study.document.data["rig"][own], study)
    return tuple(
        str(name)
        for name, part in study.document.data["rig"].items()
        if isinstance(part, dict)
        and part.get("kind") in STAGE_EFFECTS
        and own in [part.get(key) for key in HOST_FIELDS]
        and kind not in STAGE_EFFECTS[part["kind"]]
        and not (part["kind"] == "tooth_mesh" and same)
    )


def _forms_of_teeth(written: Mapping[str, Any], study: Study) -> frozenset[str]:
    """Return which forms of teeth a stage has, planetary or fixed axis; none where its teeth are unknown."""
    stated = written.get("teeth")
    if stated:
        sets = stated if isinstance(stated, list) else [stated]
        return frozenset("planetary" if "sun" in one else "fixed axis" for one in sets if isinstance(one, dict))
    entry = study.catalog.gearboxes.get(str(written.get("catalog")))
    found = () if entry is None else entry.tooth_sets()
    return frozenset("planetary" if isinstance(one, Planetary) else "fixed axis" for one in found)


def _stage(written: Mapping[str, Any], gearbox: str, study: Study) -> dict[str, Any]:
    """Return the data of the exchanged stage in the place of the written one."""
    place = {key: written[key] for key in PLACE_KEYS if key in written}
    stated = study.settings.stages.get(gearbox)
    if stated is not None:
        kind = stated.part.get("kind")
        if kind not in STAGE_KINDS:
            where = study.document.place(("study", "stages", gearbox, "part"))
            raise InputError(f"{where}: {kind!r} is no kind of stage; {did_you_mean(str(kind), STAGE_KINDS)}")
        return {**stated.part, **place}
    kind = kind_in_catalog(gearbox, study)
    if written.get("kind") == kind and "catalog" in written:  # what is stated next to the entry replaces its values
        return {**{key: one for key, one in written.items() if key != "teeth"}, "catalog": gearbox}
    return {"kind": kind, "catalog": gearbox, **place}


def kind_in_catalog(gearbox: str, study: Study) -> str:
    """Return the kind of part that a gearbox of the catalog is in a scenario: ``gear``, or ``worm_gear``."""
    entry = study.catalog.gearboxes.get(gearbox)
    return "worm_gear" if entry is not None and entry.kind == "worm" else "gear"
