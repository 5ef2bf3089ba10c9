"""The page of a diagnosis: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from torquerig.inference.answer.curves import run_curves
from torquerig.inference.engine import Outcome
from torquerig.reporting.diagnosis.likelihood import tables
from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.likelihood.model_figure import csv_of, model_figure
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.reporting.diagnosis.mismatch_figure import mismatch_picture
from torquerig.reporting.diagnosis.parameter_tables import fitted_parameters_table
from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL, WORDS, mechanism_text
from torquerig.reporting.diagnosis.summary import NO_MISMATCH, first_and_others, rendered
from torquerig.reporting.diagnosis.tables import mismatch_table, rejected_table
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.layout import Table, plain

LIMITS = (
    "A mechanism that is not in the library is located and modelled, but not named.",
    "The random load is compared in its spectrum and mean, not sample by sample.",
    "Held-out blocks are parts of the same runs. To judge by whole recordings, use --held-out.",
    "A confidence is a share of the posterior mass of the fitted hypotheses. It does not know of other effects.",
)
_SIZES = "Excess: power of line or band over the model's; of a mean torque the squared residual over its variance."
_MOST_PICTURES = 4


def likelihood_page(
    outcome: Outcome, data: Mapping[str, Any], *, title: str, command: str, model: str | None, seed: int
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
    further = (
        tables.setup_table(data["setup"]), tables.unnamed_table(data["unnamed"]),
        tables.limits_table(data["upper_limits"]),
    )  # fmt: skip
    before, after = tables.FittedParameters(outcome.nominal), tables.FittedParameters(outcome.model.fit)
    content = {
        "limits": LIMITS, "metric": data["fit"]["metric"], "answer": first_screen(data),
        "verdict": {**WORDS, "setup_error": "set-up error"}[data["verdict"]], "sentence": verdict_of(data),
        "figures": _figures(data), "findings": tuple(map(_finding, data["findings"])),
        "next_experiment": data["next_experiment"],
        "further_tables": tuple(each for each in further if each is not None), "remarks": remarks_of(data),
        "mismatch": mismatch_table(listed, sizes=_SIZES) if listed else None,
        "mismatch_picture": mismatch_picture(listed),
        "no_mismatch": NO_MISMATCH, "remaining": None, "held_out": tables.errors_table(data["rms"]),
        **first_and_others(_pictures(outcome, data["rms"]["unit"])), "omitted_pictures": (),
        "rejected": _rejected(data["set_aside"]), "added": None,
        "fitted": fitted_parameters_table(outcome.nominal.nominal, before, after) if before.knobs else None,
        "recordings": tables.conditions_table(data["recordings"], outcome.runs),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


def _finding(one: Mapping[str, Any]) -> Mapping[str, Any]:
    return {
        "name": mechanism_text(one["mechanism"]), "explanation": one["explanation"],
        "confidence": f"{100 * one['confidence']:.0f} %", "parameters": tables.parameters_table(one),
        "alternatives": tables.alternatives_table(one),
        "equivalents": tuple(map(mechanism_text, one["equivalent_to"])), "next_experiment": one["next_experiment"],
    }  # fmt: skip


def _figures(data: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    fit = data["fit"]
    nominal, before = (FEATURE_RESIDUAL.formatted(fit["before"][key]) for key in ("nominal", "heldout_misfit"))
    shown = [("held-out residual: nominal", nominal), ("calibrated", before)]
    if data["findings"] or data["unnamed"] or data["setup"]:
        shown.append(("completed", FEATURE_RESIDUAL.formatted(fit["after"]["heldout_misfit"])))
    if fit["improvement"] is not None:
        low, high = (plain(100 * end) for end in fit["improvement"]["ci95"])
        shown.append(("improvement", f"{plain(100 * fit['improvement']['value'])} % (95 %: {low} to {high} %)"))
    return tuple(shown)


def _rejected(reasons: Mapping[str, str]) -> Table | None:
    note = (
        "Tested on the completed model. Posterior odds are the likelihood, the prior odds and the cost of parameters."
    )
    return rejected_table(reasons, note=note) if reasons else None


def _pictures(outcome: Outcome, unit: str) -> tuple[Picture, ...]:
    """Return the pictures of the runs that improve most, steady ones first: their lines are sharp."""
    alone = not outcome.model.additions
    runs = sorted(run_curves(outcome), key=lambda one: (not one.is_steady, -one.gain))[:_MOST_PICTURES]
    return tuple(
        picture(
            model_figure(one, alone=alone, unit=unit),
            caption=f"{one.levels.name}: amplitude spectrum of the recording with noise and lines of the models, and "
            "mean torque of parts of the run. Circles and crosses: amplitudes of lines, recorded and expected.",
            alt_text="spectrum and mean torque of a recording with the nominal and the completed model",
            csv=csv_of(one, unit=unit),
        )
        for one in runs
    )  # fmt: skip
