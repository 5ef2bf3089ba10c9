"""The page of a matrix: one HTML file that needs nothing beside it."""

from __future__ import annotations

from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.reporting.figures.picture import Picture, picture
from torquerig.reporting.html import html
from torquerig.reporting.matrix.chapters import chapters, trace_anchor


def matrix_page(worked: MatrixAnalysis) -> str:
    """Return the HTML of a decision: pictures inline, no script, no request to anywhere; each cell leads to its way."""
    matrix = worked.case.matrix
    content = {
        "title": matrix.name,
        "goal": worked.case.goal,
        "verdict": worked.verdict,
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
            caption="Value profile: length of a bar the points, height the weight, so that the area is T; a line over "
            "what open facts leave; red are weak spots.",
            told="bars of points per criterion and alternative",
        )
    }
    if worked.strength is not None:
        made["strength"] = picture(
            strength_figure(worked.strength, winners=worked.verdict.winners),
            caption="S-diagram: the nearer to the ideal at (1, 1) the stronger, the nearer to the diagonal the better "
            "balanced; curves join equal sqrt(x y), lines are what open facts leave; red is unsatisfactory.",
            told="technical against economic rating of each alternative",
        )
    return made
