"""The page of a diagnosis under measured motion: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.knobs import Knob
from torquerig.inference.motion.engine import MotionOutcome
from torquerig.inference.motion.fitted_model import Fit
from torquerig.reporting.diagnosis.likelihood import tables
from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.likelihood.motion_figure import motion_figure
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.reporting.diagnosis.mismatch_figure import mismatch_picture
from torquerig.reporting.diagnosis.parameter_tables import fitted_parameters_table
from torquerig.reporting.diagnosis.sentences import MOTION_RESIDUAL, WORDS, mechanism_text
from torquerig.reporting.diagnosis.summary import NO_MISMATCH, first_and_others, rendered
from torquerig.reporting.diagnosis.tables import mismatch_table, rejected_table
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.layout import Table, number, plain, words
from torquerig.rig.assembly import Rig

LIMITS = (
    "A mechanism that is not in the library is located and modelled, but not named.",
    "The comparison ends at a tenth of the sample rate. Above it, noise dominates the acceleration.",
    "The measured motion is imposed on the model. An error of the encoder therefore appears as torque or force.",
    "A confidence is a share of the posterior mass of the fitted hypotheses. It does not know of other effects.",
)
_SIZES = "Excess: power of the effect over the power of the remaining residual."
_REJECTED = (
    "Tested on the completed model. Posterior odds are the likelihood, the prior odds and the cost of parameters."
)
_MOST_PICTURES = 4


def motion_page(
    outcome: MotionOutcome, data: Mapping[str, Any], *, title: str, command: str, model: str | None, seed: int
) -> str:
    """Return the HTML of a diagnosis: pictures, data and scripts inside, no request to anywhere.

    Parameters
    ----------
    data : mapping
        The diagnosis in the contract's form.
    title : str
        Title of the scenario.
    command : str
        Command that reproduces the page.
    model : str or None
        Path of the completed scenario.
    """
    listed = tables.mismatches(data["mismatch"])
    further = (tables.setup_table(data["setup"]), tables.unnamed_table(data["unnamed"]))
    before, after = _Parameters(outcome.nominal), _Parameters(outcome.fit)
    content = {
        "limits": LIMITS, "metric": data["fit"]["metric"],
        "answer": first_screen(data, percent=True),
        "verdict": {**WORDS, "setup_error": "set-up error"}[data["verdict"]],
        "sentence": verdict_of(data, measure=MOTION_RESIDUAL), "figures": _figures(data),
        "findings": tuple(map(_finding, data["findings"])), "next_experiment": None,
        "further_tables": tuple(each for each in further if each is not None), "remarks": remarks_of(data),
        "mismatch": mismatch_table(listed, sizes=_SIZES) if listed else None,
        "mismatch_picture": mismatch_picture(listed), "no_mismatch": NO_MISMATCH, "remaining": None,
        "held_out": _errors_table(data["rms"]), **first_and_others(_pictures(outcome)), "omitted_pictures": (),
        "rejected": rejected_table(data["set_aside"], note=_REJECTED) if data["set_aside"] else None, "added": None,
        "fitted": fitted_parameters_table(outcome.nominal.model.nominal, before, after) if before.knobs else None,
        "recordings": tables.runs_table(data["recordings"]),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


@dataclass(frozen=True, eq=False)
class _Parameters:
    """A fit in the form of the table of fitted parameters."""

    fit: Fit

    @property
    def rig(self) -> Rig:
        """With every parameter at its estimate."""
        return self.fit.rig

    @property
    def knobs(self) -> tuple[Knob, ...]:
        """The parameters of the nominal rig."""
        return self.fit.model.nuisances

    @property
    def positions(self) -> NDArray[np.float64]:
        """Their estimates, in standard deviations of their priors."""
        return self.fit.positions[: len(self.knobs)]

    @property
    def covariance(self) -> NDArray[np.float64]:
        """Of the positions."""
        return self.fit.covariance[: len(self.knobs), : len(self.knobs)]


def _finding(one: Mapping[str, Any]) -> Mapping[str, Any]:
    return {
        "name": mechanism_text(one["mechanism"]), "explanation": one["explanation"],
        "confidence": f"{100 * one['confidence']:.0f} %", "parameters": tables.parameters_table(one),
        "alternatives": tables.alternatives_table(one),
        "equivalents": tuple(map(mechanism_text, one["equivalent_to"])), "next_experiment": None,
    }  # fmt: skip


def _figures(data: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    fit = data["fit"]
    nominal, before = (MOTION_RESIDUAL.formatted(fit["before"][key]) for key in ("nominal", "heldout_misfit"))
    shown = [("held-out residual: nominal", nominal), ("calibrated", before)]
    if fit["improvement"] is not None:
        low, high = (plain(100 * end) for end in fit["improvement"]["ci95"])
        shown.append(("completed", MOTION_RESIDUAL.formatted(fit["after"]["heldout_misfit"])))
        shown.append(("improvement", f"{plain(100 * fit['improvement']['value'])} % (95 %: {low} to {high} %)"))
    return tuple(shown)


def _errors_table(rms: Mapping[str, Any]) -> Table:
    unit = rms["unit"].replace("*", " ")
    rows = [(*words(each["file"]), number(plain(each["before"])), number(plain(each["after"])))
            for each in rms["recordings"]]  # fmt: skip
    total = (*words("all"), number(plain(rms["before"])), number(plain(rms["after"])))
    return Table(
        caption="Rms residual on held-out data, run by run",
        head=("recording", f"nominal, calibrated [{unit}]", f"completed [{unit}]"), rows=(*rows, total),
        emphasised=frozenset({len(rows)}),
    )  # fmt: skip


def _pictures(outcome: MotionOutcome) -> tuple[Picture, ...]:
    rows = [row for row, run in enumerate(outcome.runs) if run.held.any()][:_MOST_PICTURES]
    return tuple(
        picture(
            motion_figure(outcome, row),
            caption=f"{outcome.runs[row].name}: measured torque or force, and the residuals of the calibrated and the "
            "completed model over time and over the position. Held-out data.",
            alt_text="torque or force over time, and residuals of the models before and after over time and position",
        )
        for row in rows
    )
