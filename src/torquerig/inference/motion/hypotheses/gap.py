"""Play in a gear or link."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.knobs import Knob
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypotheses.shown import stroke
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis
from torquerig.rig.parts import Gear, Link

_GAPS = (0.02, 0.1, 0.4)  # of the stroke: medians, because a gap has no derivative at zero
_SPREAD = 1.0  # of the logarithm, so that the three cover two decades


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield gaps of three sizes in each gear and link that has none."""
    present = {each.name for each in fit.model.additions}
    stated = {getattr(part, "gear", "") for part in fit.model.nominal.of_kind("backlash")}
    for joint in fit.model.nominal.parts:
        name = f"backlash_{joint.name}"
        if not isinstance(joint, Gear | Link) or joint.name in stated or name in present:
            continue
        ratio = abs(joint.ratio) if isinstance(joint, Gear) else 1.0
        for share in _GAPS:
            part = mechanisms.Backlash(name=name, gear=joint.name, gap=share * stroke(fit) / ratio)
            yield Hypothesis(
                name=name, mechanism="backlash", label=f"play in {joint.name}", parts=(part,),
                knobs=(Knob(name, "gap", _SPREAD),), start=(0.0,), log_odds=MECHANISM,
            )  # fmt: skip
