"""``torquerig diagnose``: find where recordings and model differ, and which physics the model lacks."""

from __future__ import annotations

import os
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from torquerig.catalog.search import catalog_folders, catalog_for
from torquerig.cli.common_options import catalog_option, edited, set_option
from torquerig.cli.json_option import stated_options, write_json
from torquerig.cli.output_paths import check_output_paths
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar import sidecar_path
from torquerig.reporting.json_results.document import json_text
from torquerig.reporting.pdf import check_pdf_printer, write_pdf
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.writing import scenario_text, write_scenario
from torquerig.whole_file import whole_file

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording
    from torquerig.rig.assembly import Rig
    from torquerig.scenario.model import Scenario

_PAGE = "<!-- written by torquerig diagnose -->"
_MOST_WORKERS = 4  # unless --workers states another number: each process takes some 200 MB
_MARK = "Written by torquerig diagnose"
_HEAD = f"{_MARK}: the nominal rig with fitted parameters and the findings."


@click.command("diagnose")
@click.argument("recordings", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--scenario", required=True, type=click.Path(path_type=Path), help="The rig's nominal scenario.")
@click.option("--json", "out", default=None, metavar="OUT", help="JSON file to write; - writes to standard output.")
@click.option(
    "--report",
    type=click.Path(path_type=Path),
    default=None,
    help="HTML page to write, with figures, in one file.",
)
@click.option("--pdf", is_flag=True, help="Also print the page of --report as PDF, with Chromium or WeasyPrint.")
@click.option("--model", type=click.Path(path_type=Path), default=None,
              help="Completed scenario to write; default: next to the JSON file, without one none.")  # fmt: skip
@click.option("--check", is_flag=True, help="Only check that scenario and recordings match, and list what is compared.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Seed of all random numbers.")
@click.option(
    "--workers",
    type=click.IntRange(1),
    default=None,
    help="Fits to run in parallel; default: one per core, at most four.",
)
@click.option("--held-out", "held_out", multiple=True, metavar="RECORDING", type=click.Path(path_type=Path),
              help="Recording that is not fitted and judges the models (may be repeated); "
              "default: a third of every recording.")  # fmt: skip
@set_option
@catalog_option
def command(
    *, recordings: tuple[Path, ...], scenario: Path, out: str | None, report: Path | None, pdf: bool,
    model: Path | None, check: bool, seed: int, workers: int | None, held_out: tuple[Path, ...],
    settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """Find which physics the SCENARIO lacks, given RECORDINGS of one rig.

    The answer says what is missing, how large it is, how sure that is and what to do next. The JSON holds the verdict,
    the findings with confidence, and the remaining differences.

    Exit code 0 means that a diagnosis was reached, whatever the verdict. Exit code 2 means a usage or input error.

    Example: torquerig diagnose run1.parquet run2.parquet --scenario scenarios/wear_rig.yaml --report found.html
    """
    printed = _printed(report) if pdf else None
    if check:
        foreign = [*([(model, _MARK)] if model else []), *([(report, _PAGE)] if report else [])]
        _check(recordings, scenario, settings, catalogs, seed=seed, out=out, held_out=held_out,
               written=foreign)  # fmt: skip
        return
    from torquerig.cli.progress import stages
    from torquerig.inference.answer.document import SCHEMA
    from torquerig.parallel import parallel_processes
    from torquerig.reporting.diagnosis.likelihood.made import diagnosed

    target = model or _model_of(out)
    written = [(target, _MARK)] if target else []
    written += [] if out in (None, "-") else [(Path(str(out)), SCHEMA)]
    written += [(report, _PAGE)] if report else []
    # only where an earlier page of this command is there, the PDF with its name is of this command too
    written += [(printed, "%PDF-" if report and report.exists() else _PAGE)] if printed else []
    check_output_paths(written, inputs=(*recordings, *map(sidecar_path, recordings), scenario))
    made = read_scenario(edited(scenario, settings), catalog_for(scenario, catalogs), seed=seed)
    read = _read(recordings)
    with stages("diagnose") as progress, parallel_processes(workers or min(os.cpu_count() or 1, _MOST_WORKERS)):
        names = [one.name for one in held_out]
        found = diagnosed(made, read, held_out=names, seed=seed, progress=progress)
    data = {**found.data}
    data["provenance"] = _provenance((*recordings, *map(sidecar_path, recordings), scenario), scenario, catalogs, seed)
    if found.completed is not None and target is not None:
        _write_model(target, found.completed, made)
        data["model"] = str(target)
    if out != "-":
        click.echo("\n".join(found.lines(data)))
    if out is not None:  # before the page: whatever happens to it, the answer is there
        write_json(json_text(data), out)
    if report is not None:
        again = _command(recordings, scenario, settings=settings, held_out=held_out, seed=seed)
        page = found.page(data, command=again, model=_named(data["model"]))
        with whole_file(report) as partial:
            partial.write_text(page, encoding="utf-8", newline="\n")
        if printed is not None:
            write_pdf(report, printed)
    for path in (report, printed, data["model"]):
        if path is not None and out != "-":
            click.echo(f"wrote {path}")


def _printed(report: Path | None) -> Path:
    if report is None:
        raise click.UsageError("--pdf prints the page of --report; name one, such as --report found.html --pdf.")
    check_pdf_printer()
    return report.with_suffix(".pdf")


def _write_model(target: Path, completed: Rig, made: Scenario) -> None:
    text = scenario_text(
        completed, title=made.title, operating_point=made.document.data.get("operating_point", {}), head=_HEAD
    )
    write_scenario(target, text, overwrite=True)


def _model_of(out: str | None) -> Path | None:
    """Return the file of the completed scenario where ``--model`` names none; None without JSON."""
    if out is None:
        return None
    return Path("diagnosed.yaml") if out == "-" else Path(out).with_suffix(".model.yaml")


def _provenance(inputs: Sequence[Path], scenario: Path, catalogs: Sequence[Path], seed: int) -> dict[str, Any]:
    from torquerig.reporting.json_results.provenance import provenance_of
    from torquerig.reporting.json_results.values import plain_values

    made = provenance_of(inputs, seed=seed, catalogs=catalog_folders(scenario, catalogs), options=_options())
    plain: dict[str, Any] = plain_values(made)[0]
    return plain


def _options() -> dict[str, Any]:
    return stated_options(click.get_current_context(), without=("recordings", "scenario", "out"))


def _read(paths: tuple[Path, ...]) -> list[Recording]:
    read = [read_recording(path) for path in paths]
    if len({recording.name for recording in read}) < len(read):
        raise InputError(
            "two recordings have the same file name; rename one, because the diagnosis refers to them by name"
        )
    return read


def _check(
    recordings: tuple[Path, ...], scenario: Path, settings: tuple[str, ...], catalogs: tuple[Path, ...], *,
    seed: int, out: str | None, held_out: tuple[Path, ...], written: Sequence[tuple[Path, str]],
) -> None:  # fmt: skip
    from torquerig.cli.diagnose_parts.check_likelihood import checked_by_likelihood
    from torquerig.reporting.diagnosis.run_check import run_check

    inputs = (*recordings, *map(sidecar_path, recordings), scenario)
    if out not in (None, "-"):
        mark = '"schema": "torquerig.diagnose-check/'
        check_output_paths([(Path(str(out)), mark)], inputs=inputs, what="JSON of torquerig diagnose --check")
    check_output_paths(written, inputs=inputs)
    made = read_scenario(edited(scenario, settings), catalog_for(scenario, catalogs), seed=seed)
    read = _read(recordings)
    text = run_check(made, read).text()
    result = checked_by_likelihood(made, read, text.splitlines(), held_out=held_out)
    if out != "-":
        click.echo("\n".join(result.lines))
    if out is not None:
        from torquerig.reporting.json_results.document import json_document
        from torquerig.reporting.json_results.provenance import provenance_of

        folders = catalog_folders(scenario, catalogs)
        origin = provenance_of(inputs, seed=seed, catalogs=folders, options=_options())
        document = json_document("diagnose-check", result, origin)
        write_json(json_text(document), out)


def _command(
    recordings: tuple[Path, ...], scenario: Path, *, settings: tuple[str, ...], held_out: tuple[Path, ...],
    seed: int,
) -> str:  # fmt: skip
    """Return the command that reproduces the diagnosis, without folders of this machine."""
    edits = [part for setting in settings for part in ("--set", setting)]
    names = [_named(path) or "" for path in recordings]
    fixed = ["--seed", str(seed)] if seed else []
    fixed += [part for name in held_out for part in ("--held-out", name.name)]
    return shlex.join(
        ["torquerig", "diagnose", *names, "--scenario", _named(scenario) or "", *edits, *fixed, "--json",
         "diagnosis.json", "--report", "diagnosis.html"]
    )  # fmt: skip


def _named(path: Path | str | None) -> str | None:
    """Return a path for display; of an absolute path only the name."""
    if path is None:
        return None
    return Path(path).name if Path(path).is_absolute() else Path(path).as_posix()
