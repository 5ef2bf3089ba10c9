"""The sentence that a chain of weighted lines found no line to remove."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.filters.line_weights import LEAST_RATIO
from torquerig.filters.weighted_lines import WeightedLines
from torquerig.orders.analysis.line_fit import FEWEST_PERIODS

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.filters.filter_effect import FilterEffect


def no_line_text(chain: Chain, effect: FilterEffect) -> str:
    """Return the sentence that no line was removed, with the number of lines tested; empty where one was.

    Only for chains that do nothing else than to weigh lines: another stage changes the torque in any case.
    """
    weighs = bool(chain.stages) and all(isinstance(stage, WeightedLines) for stage in chain.stages)
    if not (weighs and chain.lines and effect.changes_nothing):
        return ""
    turns = effect.motor_turns
    tested = [line for line in chain.lines if turns is None or line.motor_order * turns >= FEWEST_PERIODS]
    orders = {round(line.motor_order, 6) for line in tested}
    return (
        f"no line was removed; of {len(orders)} tested orders none has more than {LEAST_RATIO:g} times the power of "
        "the load near it at an angle that is known well enough"
    )
