"""What a study leaves out because the scenario fixes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.study.exchange import pinned_ratio

if TYPE_CHECKING:
    from torquerig.study.definition import Study


def left_out_gearboxes(study: Study) -> str:
    """Return one sentence about the gearboxes of the study that a stated ratio leaves out; empty where it leaves none.

    A ratio next to the catalog entry of the rig's gear fixes the gearbox, as ``--set gearbox.ratio=10`` does.
    """
    stage = study.exchanged.stage
    if not stage or pinned_ratio(study.document, stage) is None:
        return ""
    part = study.document.data["rig"][stage]
    others = [box for box in study.settings.gearboxes if box != part["catalog"]]
    if not others:
        return ""
    return (
        f"Not compared: {', '.join(others)}. {study.document.place(('rig', stage, 'ratio'))}: {part['ratio']:g} is "
        f"stated next to the catalog entry {part['catalog']} and fixes the gearbox; leave the ratio out to compare all "
        "gearboxes of the study."
    )
