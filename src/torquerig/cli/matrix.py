"""``torquerig matrix``: elimination, Pugh and Kesselring matrices of a file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.cli.json_option import json_option, wants_json
from torquerig.errors import InputError
from torquerig.whole_file import refuse_unwritable

if TYPE_CHECKING:
    from torquerig.decide.matrix_analysis import MatrixAnalysis
    from torquerig.document import Document
    from torquerig.reporting.json_results.matrix import MatrixResult

ENDINGS = (".html", ".md", ".xlsx", ".yaml")


@click.command("matrix")
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--template", type=click.Choice(["pugh", "kesselring"]),
              help="Write FILE.xlsx as a filled example of this matrix, with lists and live formulas.")  # fmt: skip
@click.option("--out", "outs", multiple=True, type=click.Path(path_type=Path), metavar="FILE",
              help=f"Also write the matrix; the ending is the format: {', '.join(ENDINGS)}; repeatable.")  # fmt: skip
@click.option("--pdf", is_flag=True,
              help="Also print the page of --out FILE.html as FILE.pdf, with Chromium or WeasyPrint.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite the files of --out, --pdf or --template.")
@click.option("--trace", "traced", nargs=2, multiple=True, metavar="ALTERNATIVE CRITERION",
              help="Only show how this cell was computed; repeatable.")  # fmt: skip
@click.option("--before", type=click.Path(path_type=Path), metavar="FILE",
              help="Only show the changes since this version of FILE, and their effect on the ranking.")  # fmt: skip
@json_option("matrix", reads=("file", "before"))
def command(
    file: Path,
    *,
    template: str | None,
    outs: Sequence[Path],
    pdf: bool,
    force: bool,
    traced: Sequence[tuple[str, str]],
    before: Path | None,
) -> MatrixResult | None:
    """Compute the matrices of FILE, the confidence of the winner, and a list of errors in the matrices.

    FILE is a YAML file of published tables (scenarios/reference_tables.yaml), a decision matrix
    (scenarios/matrix_example.yaml), or a decision matrix as Excel workbook (written with --out drives.xlsx). Any other
    workbook or CSV file with a Pugh or Kesselring matrix is read by its shape, and the report says how it was read.

    Example: torquerig matrix scenarios/matrix_example.yaml --out drives.xlsx
    """
    if template is not None:
        if wants_json():
            raise InputError("--template writes a new workbook and computes nothing; remove --json")
        _write_template(template, file, force=force, others=bool(outs or traced or before))
        return None
    printed = _printed(outs, force=force) if pdf else {}
    from torquerig.decide.matrix_io.matrix_table import TableSet
    from torquerig.decide.matrix_io.opened import open_matrix
    from torquerig.reporting.json_results.matrix import matrix_result, tables_result

    opened = open_matrix(file)
    document = opened.document
    if document is None:
        if outs or traced or before:
            raise InputError(
                f"{file}: is a file of published tables; --out, --trace and --before need a decision matrix"
            )
        from torquerig.decide.matrix_io.matrix_report import tables_text

        click.echo(tables_text(opened), nl=False)
        return tables_result(opened.tables or TableSet(tables=()), opened.understood, name=file.stem)
    for path in outs:
        check_target(path, force=force)
    worked = _worked_out(document)
    shown = _texts(worked, traced, before)
    click.echo("\n\n".join(shown) + "\n" if shown else _analysis_text(worked), nl=False)
    for path in outs:
        from torquerig.reporting.matrix.files import write_matrix

        write_matrix(worked, path)
        click.echo(f"wrote {path}", err=True)
    for page, path in printed.items():
        from torquerig.reporting.pdf import write_pdf

        write_pdf(page, path)
        click.echo(f"wrote {path}", err=True)
    written = [path.as_posix() for path in (*outs, *printed.values())]
    return matrix_result(worked, name=file.stem, texts=shown, written=written)


def _printed(outs: Sequence[Path], *, force: bool) -> dict[Path, Path]:
    """Return the PDF file of each page that is written."""
    from torquerig.reporting.pdf import check_pdf_printer

    found = {path: path.with_suffix(".pdf") for path in outs if path.suffix.lower() == ".html"}
    if not found:
        raise InputError("--pdf prints the page of the matrix; name one with --out, such as --out decision.html --pdf")
    for path in found.values():
        if path.exists() and not force:
            raise InputError(f"{path}: is there already; choose another name for --out, or overwrite it with --force")
        refuse_unwritable(path)
    check_pdf_printer()
    return found


def _analysis_text(worked: MatrixAnalysis) -> str:
    from torquerig.decide.matrix_io.matrix_report import matrix_analysis_text

    return matrix_analysis_text(worked)


def _texts(worked: MatrixAnalysis, traced: Sequence[tuple[str, str]], before: Path | None) -> list[str]:
    from torquerig.decide.matrix_io.certainty_text import ranking_changes_text, trace_text
    from torquerig.decide.trace import trace
    from torquerig.decide.version_comparison import ranking_changes

    parts = [trace_text(trace(worked, *pair)) for pair in traced]
    if before is not None:
        parts.append(ranking_changes_text(ranking_changes(_worked_out(_matrix_document(before)), worked)))
    return parts


def _worked_out(document: Document) -> MatrixAnalysis:
    from torquerig.decide.matrix_analysis import analyse_matrix
    from torquerig.decide.matrix_io.matrix_file import matrix_from

    catalog = None
    if isinstance(document.data, dict) and document.data.get("motors"):
        from torquerig.catalog.search import catalog_for

        catalog = catalog_for(document.path, ())
    return analyse_matrix(matrix_from(document, catalog=catalog))


def _matrix_document(file: Path) -> Document:
    from torquerig.decide.matrix_io.opened import open_matrix

    document = open_matrix(file).document
    if document is None:
        raise InputError(f"{file}: holds tables of marks or points; --before needs a decision matrix of facts")
    return document


def _write_template(method: str, path: Path, *, force: bool, others: bool) -> None:
    if others:
        raise InputError("--template writes a new workbook; leave out --out, --trace and --before")
    if path.suffix.lower() != ".xlsx":
        raise InputError(f"{path}: a template is an Excel workbook; give it the ending .xlsx")
    check_target(path, force=force)
    from torquerig.reporting.workbook.template import write_template
    from torquerig.whole_file import whole_file

    with whole_file(path) as partial:
        write_template(partial, method)
    click.echo(f"wrote {path}; change the example in it, save it, and run torquerig matrix {path}", err=True)


def check_target(path: Path, *, force: bool) -> None:
    """Raise InputError where a matrix cannot be written to ``path``."""
    if path.suffix.lower() not in ENDINGS:
        raise InputError(f"{path}: a matrix is written as {', '.join(ENDINGS)}; choose one of these endings")
    if path.exists() and not force:
        raise InputError(f"{path}: is there already; choose another name, or overwrite it with --force")
    if not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    refuse_unwritable(path)
