"""A matrix analysis as page, Markdown, workbook or YAML file, by its ending."""

from __future__ import annotations

from pathlib import Path

from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.schema_comment import schema_comment
from torquerig.whole_file import whole_file


def write_matrix(worked: MatrixAnalysis, path: Path) -> None:
    """Write ``path`` as .html, .md, .xlsx or .yaml; an old file is replaced when the new one is complete."""
    with whole_file(path) as partial:
        if path.suffix.lower() == ".xlsx":
            from torquerig.reporting.workbook.matrix_workbook import write_matrix_workbook

            write_matrix_workbook(partial, worked)
        else:
            comment = schema_comment(path, "matrix") if path.suffix.lower() == ".yaml" else ""
            partial.write_text(comment + _text(worked, path.suffix.lower()), encoding="utf-8", newline="\n")


def _text(worked: MatrixAnalysis, ending: str) -> str:
    if ending == ".html":
        from torquerig.reporting.matrix.page import matrix_page

        return matrix_page(worked)
    if ending == ".md":
        from torquerig.reporting.matrix.markdown import matrix_markdown

        return matrix_markdown(worked)
    from torquerig.decide.matrix_io.matrix_writing import matrix_yaml

    return matrix_yaml(worked.case)
