"""The page of a matrix: one self-contained HTML file."""

from __future__ import annotations

from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.html import html
from torquerig.reporting.matrix.answer import matrix_answer
from torquerig.reporting.matrix.chapters import chapters, trace_anchor
from torquerig.reporting.matrix.picture_csv import points_csv, strength_csv
from torquerig.reporting.moving.matrix_model import case_model
from torquerig.reporting.moving.page_scripts import data_script, page_scripts


def matrix_page(worked: MatrixAnalysis) -> str:
    """Return the HTML of a decision: figures, data and scripts inside, no request to anywhere."""
    matrix = worked.case.matrix
    content = {
        "title": matrix.name,
        "goal": worked.case.goal,
        "answer": matrix_answer(worked),
        "verdict": worked.verdict,
        "matrix_data": data_script("data-matrix", case_model(worked.case)),
        "scripts": page_scripts(with_plots=False),
        "chapters": chapters(worked),
        "pictures": _pictures(worked),
        "anchors": [trace_anchor(worked, name, one.name) for name in matrix.alternatives for one in matrix.criteria],
        "alternatives": matrix.alternatives,
        "criteria": len(matrix.criteria),
        "draws": worked.case.draws,
        "seed": worked.case.seed,
    }
    return html("matrix.html", content)


def _pictures(worked: MatrixAnalysis) -> dict[str, Picture]:
    from torquerig.reporting.figures.strength_figure import strength_figure
    from torquerig.reporting.figures.value_profile import value_profile

    profile = value_profile(worked.overall)
    made = {
        "profile": picture(
            profile,
            caption="Value profile: bar length is points, bar height is weight, so the area is T. Lines are the "
            "range of "
            "uncertain points. Orange bars are weak spots.",
            alt_text="bars of points per criterion and alternative",
            name="value_profile",
            csv=points_csv(worked.overall),
        )
    }
    if worked.strength is not None:
        made["strength"] = picture(
            strength_figure(worked.strength, winners=worked.verdict.winners),
            caption="S-diagram: the ideal is at (1, 1); on the diagonal both ratings are equal. Curves have equal "
            "sqrt(x y), lines are uncertain ranges, the orange area is unsatisfactory.",
            alt_text="technical against economic rating of each alternative",
            name="s_diagram",
            csv=strength_csv(worked.strength),
        )
    return made
