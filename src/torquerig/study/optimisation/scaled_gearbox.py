"""A gearbox of any ratio, scaled from the nearest one of the catalog: for the question which ratio to look for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import log, sqrt

from torquerig.document import Document
from torquerig.errors import InputError
from torquerig.rig.assembly import HOST_FIELDS
from torquerig.study.definition import Study
from torquerig.study.exchange import pinned_ratio
from torquerig.study.exchanged_data import document_of

FARTHEST = 2.0  # [1] factor between a ratio and the nearest gearbox: beyond it the number of stages differs
SCALED = (
    "The ratio is continuous. A gearbox between those of the catalog is assumed to have the efficiency, the stiffness, "
    "damping and backlash at its output, the inertia at its input and the price of the nearest one, which the table "
    "names. Its tooth counts are unknown, so lines of its teeth are not simulated."
)
TOOTHED = ("tooth_mesh",)  # effects that need the tooth counts


@dataclass(frozen=True, kw_only=True)
class RatioBounds:
    """The limits of a ratio, and the gearboxes that it is scaled from.

    Parameters
    ----------
    low, high : float
        Motor turns per output turn [1].
    ratios : mapping of str to float
        Those of the gearboxes, by name.
    """

    low: float
    high: float
    ratios: Mapping[str, float]

    def nearest(self, ratio: float) -> str:
        """Return the gearbox whose ratio is nearest, by its factor; the first listed of several."""
        return min(self.ratios, key=lambda name: abs(log(ratio / self.ratios[name])))

    def distance(self, ratio: float) -> float:
        """Return the factor between a ratio and that of the nearest gearbox [1], at least 1."""
        there = self.ratios[self.nearest(ratio)]
        return max(ratio / there, there / ratio)


def ratio_bounds(study: Study, low: float, high: float, gearboxes: Sequence[str]) -> RatioBounds:
    """Return the limits of a continuous ratio.

    Raises
    ------
    InputError
        Where the study exchanges no gear of the catalog, the limits are none, or a ratio between them is more than
        ``FARTHEST`` away from each gearbox.
    """
    option = f"--ratio {low:g}..{high:g}"
    stage = study.exchanged.stage
    if not stage:
        raise InputError(f"{option}: the study of {study.document.path.name} exchanges no stage; leave --ratio out")
    if pinned_ratio(study.document, stage) is not None:
        place = study.document.place(("rig", stage, "ratio"))
        raise InputError(f"{option}: {place} states the ratio; leave one of the two out")
    if not 1 <= low < high < float("inf"):
        raise InputError(f"{option} is no range of ratios; write motor turns per output turn from 1 on, such as 3..12")
    ratios = {}
    for name in gearboxes:
        entry = study.catalog.gearboxes.get(name)
        if entry is None or entry.kind not in ("planetary", "spur"):
            kind = "no gearbox of the catalog" if entry is None else f"a {entry.kind}"
            raise InputError(
                f"{option}: {name} is {kind}, and a ratio is scaled from planetary or spur gearboxes only; name others "
                "with --gearbox"
            )
        ratios[name] = entry.ratio
    made = RatioBounds(low=low, high=high, ratios=ratios)
    _refuse_far(made, option)
    return made


def _refuse_far(bounds: RatioBounds, option: str) -> None:
    known = sorted(set(bounds.ratios.values()))
    middles = [sqrt(first * second) for first, second in pairwise(known)]
    tried = [bounds.low, bounds.high, *(one for one in middles if bounds.low < one < bounds.high)]
    far = next((one for one in tried if bounds.distance(one) > FARTHEST * (1 + 1e-9)), None)
    if far is None:
        return
    near = bounds.ratios[bounds.nearest(far)]
    low, high = max(1.0, bounds.low, near / FARTHEST), min(bounds.high, near * FARTHEST)
    if low >= high:
        low, high = max(1.0, near / FARTHEST), near * FARTHEST
    within = f", or write {low:g}..{high:g}"
    raise InputError(
        f"{option}: the ratio {far:.3g} is more than {FARTHEST:g} times away from each gearbox (their ratios: "
        f"{', '.join(f'{one:g}' for one in known)}), too far to scale one; name nearer ones with --gearbox{within}"
    )


def scaled_document(study: Study, *, motor: str, gearbox: str, ratio: float) -> Document:
    """Return the scenario with a motor and a gearbox whose ratio is another than in its file."""
    document, stage = document_of(motor, gearbox, study), study.exchanged.stage
    rig = dict(document.data["rig"])
    rig[stage] = {**rig[stage], "kind": "gear", "ratio": float(ratio), "teeth": []}
    for name, part in list(rig.items()):
        if isinstance(part, dict) and part.get("kind") in TOOTHED and stage in [part.get(key) for key in HOST_FIELDS]:
            del rig[name]
    return replace(document, data={**document.data, "rig": rig})
