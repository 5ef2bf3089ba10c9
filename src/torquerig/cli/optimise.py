"""``torquerig optimise``: the best gearbox, speed loop and filter for one motor."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option, set_option
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.cli.progress import drive_progress
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.plain_table import wrapped
from torquerig.reporting.json_results.draws import OptimiseResult, optimise_result
from torquerig.reporting.study.optimum_text import front_text, optimum_text
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import compared_gearboxes, refuse_pinned
from torquerig.study.definition import open_study
from torquerig.study.left_out import left_out_gearboxes

if TYPE_CHECKING:
    _PairType = click.ParamType[tuple[float, float]]
else:
    _PairType = click.ParamType  # generic from click 8.3 on


class _Range(_PairType):
    """Two numbers, written ``5..60``."""

    name = "LOW..HIGH"

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, float]:
        """Return both numbers."""
        if isinstance(value, tuple):
            return value
        try:
            low, high = (float(one) for one in str(value).split(".."))
        except ValueError:
            self.fail(f"{value!r} is no range; write both ends, such as 5..60", param, ctx)
        return low, high


@click.command("optimise")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option(
    "--motor", shell_complete=motor_names, default=None, help="Motor of the catalog. Default: the present one."
)
@click.option("--gearbox", "gearboxes", shell_complete=gearbox_names, multiple=True,
              help="Gearbox to try; repeatable. Default: those of the study.")  # fmt: skip
@click.option("--ratio", type=_Range(), default=None,
              help="Limits of a continuous ratio, of a gearbox scaled from the nearest one.")  # fmt: skip
@click.option("--vary", "varied", multiple=True, metavar="FILTER.KEY=LOW..HIGH",
              help="Number of a filter to vary, such as 'low_pass_20Hz.cutoff=5..60 Hz'; repeatable.")  # fmt: skip
@click.option("--crossover", type=_Range(), default="5..60", show_default=True,
              help="Limits of the speed loop's crossover [Hz].")  # fmt: skip
@click.option("--integral-corner", type=_Range(), default="0.3..5", show_default=True,
              help="Limits of the corner of its integrator [Hz].")  # fmt: skip
@click.option("--margin", type=float, default=0.5, show_default=True,
              help="Least distance of the loop gain from -1.")  # fmt: skip
@click.option("--evaluations", type=click.IntRange(16), default=160, show_default=True,
              help="Speed loops to simulate for each gearbox, about.")  # fmt: skip
@set_option
@catalog_option
@json_option("optimise", reads=("scenario",))
def command(
    *, scenario: Path, motor: str | None, gearboxes: tuple[str, ...], ratio: tuple[float, float] | None,
    varied: tuple[str, ...], crossover: tuple[float, float], integral_corner: tuple[float, float], margin: float,
    evaluations: int, settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> OptimiseResult:  # fmt: skip
    """Find the speed loop of least reading error for one motor on each gearbox, behind each filter of SCENARIO's study.

    The ratio and numbers of the filters may vary too. The table has the choices that no other beats in reading error,
    delay and price together.

    Example: torquerig optimise scenarios/wear_rig.yaml --motor bldc-12n14p --set study.duration=2s
    """
    from torquerig.study.optimisation.bounds import Bounds
    from torquerig.study.optimisation.scaled_gearbox import SCALED, ratio_bounds
    from torquerig.study.optimisation.search import optimised
    from torquerig.study.optimisation.tried import front
    from torquerig.study.optimisation.varied_number import varied_number

    study = open_study(overridden(read_document(scenario), settings), catalog_for(scenario, catalogs))
    if gearboxes and not study.exchanged.stage:
        raise InputError(f"--gearbox {gearboxes[0]}: the study of {scenario.name} exchanges no stage")
    for box in gearboxes:
        refuse_pinned(box, study)
    boxes = gearboxes or compared_gearboxes(study)
    bounds = Bounds(
        gearboxes=boxes, crossover=crossover, integral_corner=integral_corner, margin=margin, evaluations=evaluations,
        numbers=tuple(varied_number(text, study) for text in varied),
        ratio=None if ratio is None else ratio_bounds(study, *ratio, boxes),
    )  # fmt: skip
    name = motor or study.settings.present.motor
    with drive_progress(f"speed loops of {name}") as progress:
        found = optimised(study, name, bounds, progress=progress)
    best = front(found.tried)
    click.echo(wrapped(optimum_text(best, found.by_rule, unit=study.effort_unit)) + "\n")
    click.echo(front_text(best, unit=study.effort_unit))
    notes = [note for note in ("" if gearboxes else left_out_gearboxes(study), SCALED if ratio else "") if note]
    for note in notes:
        click.echo("\n" + wrapped(note))
    if found.left_out:
        listed = "; ".join(f"{one} ({why})" for one, why in found.left_out.items())
        click.echo("\n" + wrapped(f"Cannot run: {listed}."))
    sentence = optimum_text(best, found.by_rule, unit=study.effort_unit)
    return optimise_result(
        found, best, motor=name, seed=study.settings.seed, unit=study.effort_unit, sentence=sentence,
        notes=notes,
    )  # fmt: skip
