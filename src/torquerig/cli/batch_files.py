"""One file of ``torquerig batch``: its command run without printing, its JSON, and its row of the table."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Any

import click

from torquerig.cli.json_option import JsonCall, silent_output
from torquerig.cli.progress import drive_progress
from torquerig.cli.recordings_named import recordings_in
from torquerig.errors import InputError, TorquerigError
from torquerig.reporting.json_results.batch import FileOutcome, figures_of, problem_of
from torquerig.reporting.json_results.document import json_text
from torquerig.reporting.json_results.provenance import Provenance
from torquerig.reporting.json_results.values import plain_values
from torquerig.whole_file import whole_file

COMMANDS = ("filter", "ordermap", "info")
_OWN = {"--json": "writes the JSON of each file itself", "--force": "overwrites nothing"}
_OF_ONE_FILE = ("--out", "--picture")


def files_of(folder: Path, name: str, options: Sequence[str], *, without: Path) -> list[Path]:
    """Return the recordings of a folder, without the table and without outputs of earlier calls.

    Raises
    ------
    InputError
        For an option that belongs to one file, or that the command does not have; a folder without recordings.
    """
    for option, reason in _OWN.items():
        if option in options:
            raise InputError(f"{option}: batch {reason}; remove it")
    for option in _OF_ONE_FILE:
        if option in options:
            raise InputError(f"{option}: names one file, and batch runs over many; remove it")
    found = [path for path in recordings_in(folder) if path.resolve() != without.resolve()]
    if not found:
        raise InputError(f"{folder}: there is no recording in this folder; name a folder with recordings")
    with _context(name, found[0], options):
        pass  # a wrong option is an error of the call, not of each file
    made = {_filtered(path, options) for path in found} if name == "filter" else set()
    return [path for path in found if path not in made]


def file_outcomes(
    name: str, files: Sequence[Path], options: Sequence[str], *, workers: int, title: str
) -> list[FileOutcome]:
    """Return the outcome of each file in the order of the files; each JSON is there as soon as its file is done."""
    done: dict[Path, FileOutcome] = {}
    with drive_progress(title) as progress:
        for outcome in _each(name, files, tuple(options), workers):
            done[outcome.file] = outcome
            progress(len(done), len(files), outcome.file.name)
    return [done[path] for path in files]


def _each(name: str, files: Sequence[Path], options: tuple[str, ...], workers: int) -> Iterator[FileOutcome]:
    if workers == 1 or len(files) == 1:
        yield from (one_file(name, path, options) for path in files)
        return
    with ProcessPoolExecutor(min(workers, len(files))) as pool:
        running = [pool.submit(one_file, name, path, options) for path in files]
        try:
            yield from (one.result() for one in as_completed(running))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def one_file(name: str, path: Path, options: tuple[str, ...]) -> FileOutcome:
    """Return the outcome of one file; an error of it is an outcome."""
    target = path.with_name(f"{path.name}.{name}.json")
    try:
        with _context(name, path, options) as context:
            call = JsonCall.of(context)
            document = _earlier(
                target, call.origin(context.params), _filtered(path, options) if name == "filter" else None
            )
            status = "computed" if document is None else "taken over"
            if document is None:
                document = _computed(call, context, target)
    except (TorquerigError, click.ClickException, OSError, MemoryError) as error:
        said = error.format_message() if isinstance(error, click.ClickException) else str(error)
        return FileOutcome(file=path, status="failed", reason=said or type(error).__name__)
    reason = problem_of(document)
    return FileOutcome(
        file=path, status="failed" if reason else status, reason=reason, json=target.name,
        figures=figures_of(name, document),
    )  # fmt: skip


def _computed(call: JsonCall, context: click.Context, target: Path) -> dict[str, Any]:
    """Run the command on one file and write its JSON."""
    parameters = {key: value for key, value in context.params.items() if key != "json_out"}
    with silent_output(True):
        _, document = call.done(**parameters)
    with whole_file(target) as partial:
        partial.write_text(json_text(document), encoding="utf-8", newline="\n")
    return document


def _earlier(target: Path, origin: Provenance, filtered: Path | None) -> dict[str, Any] | None:
    """Return the document of an earlier call with the same input, options and version; None where there is none."""
    if not target.exists():
        return None
    try:
        found = json.loads(target.read_text(encoding="utf-8"))
        same = found["provenance"] == plain_values(origin)[0]
    except (ValueError, KeyError, TypeError):
        same = False
    if not same:
        raise InputError(f"{target.name}: is there already, of other input, options or version; move or delete it")
    if filtered is not None and not filtered.exists():
        raise InputError(f"{filtered.name}: is gone, and {target.name} is there; delete that too")
    document: dict[str, Any] = found
    return document


def _context(name: str, path: Path, options: Sequence[str]) -> click.Context:
    """Return the context of the command on one file, its options read."""
    command: click.Command = import_module(f"torquerig.cli.{name}").command
    filtered = _filtered(path, options) if name == "filter" else None
    out = [] if filtered is None else ["--out", str(filtered)]
    return command.make_context(name, [str(path), *options, *out])


def _filtered(path: Path, options: Sequence[str]) -> Path | None:
    """Return the file of the filtered recording: there is one where exactly one chain is named."""
    chains = [value for option, value in pairwise(options) if option == "--chain"]
    return path.with_name(f"{path.stem}.{chains[0]}.parquet") if len(chains) == 1 else None
